#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Error at edges with and without coverage by rays: RMS difference between the displayed picture and the mean of many frames, in
1/255, after 1, 2, 3, 5 and 8 still frames; and the time of the rays. Exits with 1 if rays do not reduce the error."""
import argparse
import sys

import numpy as np
import penumbra
from denoiser import named
from indirect_light import write
from ray_scenes import Film, Report
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

SCENES = ("isosurface", "cornell", "head", "terrain", "protein", "tubes-1000", "plates-1000")
COUNTS = (1, 2, 3, 5, 8)
MANY = 256
BETTER = 0.95  # share of the error, first frame


def shown(film):
    """The picture in the window, rows from the bottom."""
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(film.window)
    grabber.ShouldRerenderOff()
    grabber.ReadFrontBufferOff()
    grabber.Update()
    image = grabber.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[..., :3].astype(float)


def film(name, args, edges):
    """A scene after a camera cut. edges: value of anti-aliasing.edges."""
    made = Film(named(name), args.size, args.preset, smooth=True, **{"anti-aliasing.edges": edges})
    made.gi.CollectStatisticsOn()
    for _ in range(2):
        made.frame()
    made.cut()
    return made


def main():
    """Print two lines for each scene."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", default=SCENES, metavar="SCENE",
                        help="any of the bench's, or FAMILY-SEED (default: " + ", ".join(SCENES) + ")")
    parser.add_argument("--size", default="320x240", metavar="WxH", help="size of the pictures (default %(default)s)")
    parser.add_argument("--preset", default="off", choices=penumbra.presets(), help="without noise (default %(default)s)")
    parser.add_argument("--pictures", metavar="FOLDER", help="write first frames there: frames, rays, the mean")
    args = parser.parse_args()
    args.size = tuple(map(int, args.size.split("x")))
    report = Report()
    for name in args.scenes:
        report.going_on(f"{name}: mean")
        still = film(name, args, "frames")
        for _ in range(MANY):
            still.frame()
        truth, errors, first, cost = shown(still), {}, {}, 0
        for edges in ("frames", "rays"):
            shot, errors[edges] = film(name, args, edges), {}
            for frame in range(1, max(COUNTS) + 1):
                shot.frame()
                picture = shown(shot)
                errors[edges][frame] = np.sqrt(np.mean((picture - truth) ** 2))
                first.setdefault(edges, picture)
                if edges == "rays" and frame == 3:
                    cost = sum(entry["milliseconds"] for entry in penumbra.statistics(shot.gi)["passes"]
                               if entry["name"] == "edge-rays")
        write(args.pictures, f"edges_{name}.png", *((picture / 255) ** 2.2 for picture in (*first.values(), truth)))
        for edges, found in errors.items():
            print(f"{name:12} {edges:7}" + "".join(f"{found[count]:8.2f}" for count in COUNTS), flush=True)
        report.figure(f"{name}: error of the first frame, rays / frames", errors["rays"][1] / errors["frames"][1], BETTER,
                      more=f"rays take {cost:.0f} ms")
    return 0 if report.passed else 1


if __name__ == "__main__":
    sys.exit(main())
