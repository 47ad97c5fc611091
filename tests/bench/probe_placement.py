#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Indirect light by baked probes compared with the path tracer: in one grid, and in several grids with the same number of
probes. In one of the scenes detail is not concentrated. Exits with 1 if several grids have a larger error than one."""
import argparse
import math
import sys
import tempfile
import time

import numpy as np
import penumbra
from indirect_light import BOUNCES, FINER, Camera, kept, smaller, write
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

WORSE = 1.05  # limit of the error of several grids relative to one, which allows for noise
GREY, WOOD, BLUE, RED, GREEN = (0.7, 0.7, 0.7), (0.6, 0.4, 0.2), (0.2, 0.3, 0.7), (0.7, 0.15, 0.1), (0.15, 0.6, 0.2)


class Scene:
    """A scene of boxes, balls and lamps in plain VTK."""

    def __init__(self):
        self.renderer = vtkRenderer()
        self.renderer.AutomaticLightCreationOff()
        self.renderer.SetBackground(0, 0, 0)

    def add(self, source, color):
        mapper, actor = vtkPolyDataMapper(), vtkActor()
        mapper.SetInputConnection(source.GetOutputPort())
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(color)
        self.renderer.AddActor(actor)
        return actor

    def box(self, color, *bounds):
        cube = vtkCubeSource()
        cube.SetBounds(bounds)
        self.add(cube, color).GetProperty().SetInterpolationToFlat()

    def ball(self, color, radius, *position):
        sphere = vtkSphereSource()
        sphere.SetRadius(radius)
        sphere.SetCenter(position)
        sphere.SetPhiResolution(24)
        sphere.SetThetaResolution(48)
        self.add(sphere, color)

    def shell(self, colors, x0, x1, y0, y1, z0, z1, thick=0.1):
        """Add floor, ceiling and walls. The one at y0 is left out if it has no colour."""
        floor, ceiling, west, east, south, north = colors
        self.box(floor, x0, x1, y0, y1, z0 - thick, z0)
        self.box(ceiling, x0, x1, y0, y1, z1, z1 + thick)
        self.box(west, x0 - thick, x0, y0, y1, z0, z1)
        self.box(east, x1, x1 + thick, y0, y1, z0, z1)
        self.box(north, x0, x1, y1, y1 + thick, z0, z1)
        if south:
            self.box(south, x0, x1, y0 - thick, y0, z0, z1)

    def lamp(self, intensity, *position):
        lamp = vtkLight()
        lamp.SetLightTypeToSceneLight()
        lamp.PositionalOn()
        lamp.SetConeAngle(180)
        lamp.SetPosition(position)
        lamp.SetIntensity(intensity)
        self.renderer.AddLight(lamp)

    def look(self, angle, position, focal):
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(position)
        camera.SetFocalPoint(focal)
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(angle)
        self.renderer.ResetCameraClippingRange()


def furniture(scene, x, y):
    """Add a table, a shelf, a chest and a ball to an area of four by three."""
    for dx, dy in ((0, 0), (1.2, 0), (0, 0.6), (1.2, 0.6)):
        scene.box(WOOD, x + 1.2 + dx, x + 1.26 + dx, y + 1.0 + dy, y + 1.06 + dy, 0, 0.7)
    scene.box(WOOD, x + 1.15, x + 2.5, y + 0.95, y + 1.7, 0.7, 0.75)
    scene.box(RED, x + 0.1, x + 0.5, y + 1.2, y + 2.4, 0, 1.8)
    scene.box(BLUE, x + 3.0, x + 3.7, y + 1.8, y + 2.6, 0, 0.6)
    scene.ball(GREEN, 0.25, x + 1.8, y + 1.3, 1.0)


def room_in_hall():
    """A furnished room with a door, in a hall ten times as long."""
    scene = Scene()
    scene.shell((GREY,) * 6, 0, 40, 0, 30, 0, 10)
    x, y = 30, 20
    scene.box(GREY, x - 0.1, x + 4.1, y - 0.1, y + 3.1, 2.5, 2.6)
    scene.box(GREY, x - 0.1, x, y, y + 3, 0, 2.5)
    scene.box(RED, x + 4, x + 4.1, y, y + 3, 0, 2.5)
    scene.box(GREY, x - 0.1, x + 4.1, y + 3, y + 3.1, 0, 2.5)
    scene.box(GREY, x + 1, x + 4.1, y - 0.1, y, 0, 2.5)
    furniture(scene, x, y)
    scene.lamp(0.9, 15, 12, 9)
    scene.lamp(0.5, x + 2.4, y + 1.2, 2.2)
    scene.look(75, (x + 0.4, y + 0.15, 1.6), (x + 2.6, y + 2.0, 0.7))
    return scene


def furnished_corner():
    """A large empty building, furnished in a corner."""
    scene = Scene()
    scene.shell((GREY, GREY, BLUE, GREY, GREY, RED), 0, 30, 0, 20, 0, 5)
    scene.box(GREY, 14.9, 15.1, 6, 20, 0, 5)
    furniture(scene, 1, 15)
    furniture(scene, 2, 11)
    scene.lamp(0.7, 4, 12, 4.2)
    scene.lamp(0.7, 24, 8, 4.2)
    scene.look(60, (8.5, 10.5, 2.2), (2, 15, 0.5))
    return scene


def molecule():
    """Coloured balls close together over a large plane."""
    scene = Scene()
    scene.box(GREY, -30, 30, -30, 30, -0.1, 0)
    random = np.random.default_rng(5)
    for i in range(30):
        angle = 0.6 * i
        scene.ball((RED, GREY, BLUE)[i % 3], 0.5, 6 + 1.2 * math.cos(angle), -4 + 1.2 * math.sin(angle),
                   0.6 + 0.11 * i + 0.1 * random.random())
    scene.lamp(1.0, 2, -10, 9)
    scene.look(30, (4, -14, 4), (6, -4, 1.6))
    return scene


def cornell():
    """A Cornell box, for which one grid is best."""
    scene = Scene()
    scene.shell((GREY, GREY, RED, GREEN, None, GREY), -1, 1, -1, 1, 0, 2)
    scene.box(GREY, -0.6, 0.0, 0.1, 0.7, 0, 1.2)
    scene.box(GREY, 0.2, 0.75, -0.6, -0.05, 0, 0.55)
    scene.lamp(0.9, 0, 0, 1.85)
    scene.look(40, (0, -3.9, 1), (0, 0, 1))
    return scene


SCENES = {make.__name__.replace("_", "-"): make for make in (room_in_hall, furnished_corner, molecule, cornell)}


def options():
    """Parse the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--size", default="64x48", metavar="WxH", help="size of the pictures in pixels")
    parser.add_argument("--spp", type=int, default=1024, help="paths per pixel of the reference")
    parser.add_argument("--samples", type=int, default=512, help="paths per probe")
    parser.add_argument("--probes", type=int, nargs="+", default=[1000], help="maximum number of probes")
    parser.add_argument("--scene", choices=SCENES, nargs="+", default=list(SCENES))
    parser.add_argument("--keep", metavar="FOLDER", help="folder that keeps traced pictures for the next run")
    parser.add_argument("--pictures", metavar="FOLDER", help="write pictures with one grid and with several, the reference, and the probes there")
    parser.add_argument("--cost", action="store_true", help="also measure the time of the lookup")
    args = parser.parse_args()
    args.size = tuple(map(int, args.size.split("x")))
    return args


def truth(args, name):
    """Reference of the indirect light: light that was reflected at least once."""
    def traced(bounces):
        camera = Camera(args.size, "reference", SCENES[name](),
                        **{"path-tracing.samples": args.spp, "path-tracing.bounces": bounces})
        return camera.picture(args.spp)
    kind = f"{name}_{args.size[0]}_{args.spp}"
    return (kept(args.keep, "placement_full_" + kind, lambda: traced(BOUNCES))
            - kept(args.keep, "placement_once_" + kind, lambda: traced(0)))


def bake(args, camera, probes, adaptive):
    """Bake probes and switch the technique on. Returns the number of probes, the sizes of the grids, and a text with the time
    that it took and the result of the trial."""
    started = time.monotonic()
    baker, field = penumbra.vtkGIProbeBaker(), vtkImageData()
    baker.SetProbes(probes)
    baker.SetAdaptive(adaptive)
    baker.SetSamples(args.samples)
    technique = camera.gi.GetTechnique("sh-probes")
    if not baker.Bake(camera.room.renderer, field) or not technique.SetBake(field):
        sys.exit(baker.GetLastError() or technique.GetBakeError())
    took = time.monotonic() - started
    sizes = []
    for number in range(baker.CountGrids(field)):
        counts, bounds = [0, 0, 0], [0.0] * 6
        baker.GetGrid(field, number, counts, bounds)
        sizes.append("x".join(map(str, counts)) + f" of {(bounds[1] - bounds[0]) / (counts[0] - 1):.2f}")
    technique.EnabledOn()
    if baker.GetNumberOfTriedGrids():
        took = (f"{took:.1f} s, {baker.GetNumberOfTriedGrids()} grids tried: {baker.GetErrorOfTriedGrids():.2f} of one's error, "
                f"{'kept' if len(sizes) > 1 else 'rejected'}")
    else:
        took = f"{took:.1f} s"
    return field.GetNumberOfPoints(), sizes, took


def lookup(camera):
    """Milliseconds of the pass that looks up the probes."""
    camera.gi.CollectStatisticsOn()
    times = []
    for _ in range(15):
        camera.window.Render()
        times += [row["milliseconds"] for row in penumbra.statistics(camera.gi)["passes"] if row["name"] == "indirect-light"]
    return float(np.median(times))


def compare(args, name, probes):
    """Errors with one grid and with several."""
    camera = Camera(tuple(FINER * n for n in args.size), "off", SCENES[name](), on=["ray-traced-shadows"])
    direct = camera.picture()
    expected = truth(args, name)
    errors, pictures = [], []
    for adaptive in (False, True):
        count, sizes, took = bake(args, camera, probes, adaptive)
        ours = smaller(camera.picture() - direct)
        error, mean = penumbra.relative_error(ours, expected)
        errors.append(error)
        pictures.append(ours)
        line = (f"{name}, {'several grids' if adaptive else 'one grid'}: {count} probes ({', '.join(sizes)}), relMSE {error:.4f}, "
                f"signed mean {100 * mean:+.1f} %, baked in {took}")
        print(line + (f", lookup {lookup(camera):.1f} ms" if args.cost else ""), flush=True)
    if args.pictures:
        camera.gi.GetTechnique("sh-probes").SetShow(True)
        shown = smaller(camera.picture())
        brighter = 0.35 / max(expected.mean(), 1e-6)
        write(args.pictures, f"{name}_{probes}.png", *(brighter * picture for picture in pictures + [expected]), brighter * shown)
    return errors


def main():
    """Compare all scenes."""
    args = options()
    passed = True
    with tempfile.TemporaryDirectory() as scratch:
        args.keep = args.keep or scratch
        for name in args.scene:
            for probes in args.probes:
                one, several = compare(args, name, probes)
                print(f"{name}: {several / one:.2f} of the error{'' if several <= WORSE * one else ': WORSE'}", flush=True)
                passed &= several <= WORSE * one
    sys.exit(0 if passed else 1)


if __name__ == "__main__":
    main()
