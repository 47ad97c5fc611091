#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""What an update of DDGI's probes costs in a Cornell box whose lamp moves: by probes and rays, and by triangles, which a
ball in the room is made of. Prints tables, and draws the second one. Exit code 1 where the default update takes longer
than --limit, where a ray costs more or less the more there are, or where the cost grows faster than the logarithm of
the triangles."""
import argparse
import math
import os
import statistics
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "examples"))

import penumbra  # noqa: E402
from cornell_moving_light import WHITE, Room, painted  # noqa: E402
from PIL import Image  # noqa: E402
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY  # noqa: E402
from vtkmodules.vtkCommonCore import vtkFloatArray  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkTable  # noqa: E402
from vtkmodules.vtkFiltersSources import vtkSphereSource  # noqa: E402
from vtkmodules.vtkRenderingContext2D import vtkContextActor  # noqa: E402
from vtkmodules.vtkRenderingCore import vtkRenderer  # noqa: E402
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: E402,F401

PROBES, RAYS = 1024, 128  # the defaults
UNEVEN = 1.25  # how many times the least cost of a ray the greatest may be: noise, and what updates cost beside rays
LEAST = 1e4  # triangles of the smallest ball
WARM = 10  # updates before those that count: shaders compile, distances settle


def options():
    """From the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--updates", type=int, default=15, help="that are timed in each scene")
    parser.add_argument("--most", type=float, default=4e6, help="triangles of the largest scene")
    parser.add_argument("--limit", type=float, help="milliseconds that the default update may take")
    parser.add_argument("--plot", metavar="FILE.png", help="draw the cost by triangles there")
    args = parser.parse_args()
    if args.most < LEAST:
        parser.error(f"--most is at least {LEAST:g}")
    return args


def ball(triangles):
    """Of about so many."""
    around = round(0.5 + math.sqrt(0.25 + 0.5 * triangles))
    source = vtkSphereSource()
    source.SetRadius(0.25)
    source.SetCenter(0.5, 0.5, 0.4)
    source.SetThetaResolution(around)
    source.SetPhiResolution(around)
    source.Update()
    return source.GetOutput()


def update_cost(updates, probes=PROBES, rays=RAYS, triangles=0):
    """Probes, triangles and median milliseconds of an update."""
    room = Room()
    data = ball(triangles) if triangles else None
    if data:
        room.renderer.AddActor(painted(data, WHITE))
    gi = penumbra.enable(room.renderer, "off", on="ddgi", ddgi__probes=probes, ddgi__rays=rays)
    gi.CollectStatisticsOn()
    window = penumbra.window(room.renderer, size=(64, 64), multisamples=0)
    times = []
    for step in range(WARM + updates):
        room.lamp.SetPosition(0.5 + 0.005 * step, 0.5, 0.8)
        window.Render()
        passes = {one["name"]: one["milliseconds"] for one in penumbra.statistics(gi)["passes"]}
        times.append(passes["ddgi-trace"] + passes["ddgi-blend"])
    counts = [0, 0, 0]
    gi.GetTechnique("ddgi").GetGrid(room.renderer, counts)
    return math.prod(counts), data.GetNumberOfPolys() if data else 0, statistics.median(times[WARM:])


def plot(points, path):
    """Milliseconds over triangles, on a logarithmic axis."""
    table = vtkTable()
    for column, name in enumerate(("triangles", "milliseconds")):
        array = vtkFloatArray()
        array.SetName(name)
        for point in points:
            array.InsertNextValue(math.log10(point[0]) if column == 0 else point[1])
        table.AddColumn(array)
    chart = vtkChartXY()
    line = chart.AddPlot(vtkChart.LINE)
    line.SetInputData(table, 0, 1)
    line.SetColor(30, 90, 180, 255)
    line.SetWidth(2.5)
    line.SetMarkerStyle(4)
    axes = ((vtkAxis.BOTTOM, "triangles, powers of ten", 4, math.log10(points[-1][0]) + 0.05),
            (vtkAxis.LEFT, "milliseconds of an update", 0, 1.15 * max(point[1] for point in points)))
    for place, title, low, high in axes:
        axis = chart.GetAxis(place)
        axis.SetTitle(title)
        axis.SetBehavior(vtkAxis.FIXED)
        axis.SetRange(low, high)
    renderer, actor = vtkRenderer(), vtkContextActor()
    renderer.SetBackground(1, 1, 1)
    actor.GetScene().AddItem(chart)
    actor.GetScene().SetRenderer(renderer)
    renderer.AddActor(actor)
    window = penumbra.window(renderer, size=(640, 400), multisamples=4)
    Image.fromarray(penumbra.render(window)).save(path)


def excesses(default, limit, rays, points):
    """Sentences on what is more than it may be, of milliseconds of the default update and their limit or None, nanoseconds
    a ray, and pairs of triangles and milliseconds."""
    said = []
    if limit and default > limit:
        said.append(f"the default update takes {default:.1f} ms, more than {limit:g}")
    if max(rays) > UNEVEN * min(rays):
        said.append(f"a ray costs from {min(rays):.0f} to {max(rays):.0f} ns: not linear")
    (few, least), (many, most) = points[0], points[-1]
    if most / least > max(1.1, math.log(many) / math.log(few)):
        said.append(f"{many / few:.0f} times the triangles cost {most / least:.2f} times as much: more than logarithmic growth")
    return said


def main():
    """Both tables."""
    args = options()
    started = time.monotonic()
    each = []
    base = update_cost(args.updates)
    print(f"{'probes':>8} {'rays':>6} {'ms':>8} {'ns a ray':>9}")
    for probes, rays in ((512, 128), (1024, 64), (1024, 128), (2048, 128)):
        made, _, milliseconds = base if (probes, rays) == (PROBES, RAYS) else update_cost(args.updates, probes, rays)
        each.append(1e6 * milliseconds / (made * rays))
        print(f"{made:8d} {rays:6d} {milliseconds:8.1f} {each[-1]:9.0f}", flush=True)
    print(f"\n{'triangles':>9} {'ms':>8}")
    points = []
    size = LEAST
    while size <= 1.01 * args.most:
        _, triangles, milliseconds = update_cost(args.updates, triangles=size)
        points.append((triangles, milliseconds))
        print(f"{triangles:9d} {milliseconds:8.1f}", flush=True)
        size = min(10 * size, args.most) if size < args.most else 2 * args.most
    if args.plot:
        plot(points, args.plot)
    print(f"\n{time.monotonic() - started:.0f} s; the default update: {base[2]:.1f} ms"
          + (f" (at most {args.limit:g})" if args.limit else ""))
    said = excesses(base[2], args.limit, each, points)
    for sentence in said:
        print(sentence)
    sys.exit(1 if said else 0)


if __name__ == "__main__":
    main()
