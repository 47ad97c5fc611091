#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""A static room lit by its lightmap and a ball that moves through it lit by baked probes, compared with the path tracer.
Exits with 1 if an error is above its limit or a bake does not fit."""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import numpy as np
import penumbra
from indirect_light import FINER, Camera, kept, smaller, write
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

# Limits of relMSE: without the ball, and its means over the frames for static surfaces and for the ball. Limits of the
# signed mean: without the ball, and in any frame. They are a third to a half above the values measured at 240x135. Smaller
# pictures blur the shadow below the ball and have smaller errors. Without the ball, most of the error is noise of the
# reference. With it, most comes from light that the ball blocks, which the bakes do not know (docs/indirect-light.md).
EMPTY, STILL, BALL = 0.003, 0.018, 0.04
EMPTY_MEAN, MEAN = 0.005, 0.10
BOUNCES = 30
RADIUS = 0.35
LAMP = ((-0.9, -1.1, 1.7), 0.5)
SIDES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (2, 3, 7, 6), (0, 4, 7, 3), (1, 2, 6, 5))  # indices of a box's corners
# Two opposite corners and a colour of each. The room is open toward the camera.
BOXES = {"floor": ((-2, -1.5, -0.1), (2, 1.5, 0), (0.75, 0.75, 0.75)),
         "ceiling": ((-2, -1.5, 2), (2, 1.5, 2.1), (0.75, 0.75, 0.75)),
         "back": ((-2, 1.5, 0), (2, 1.6, 2), (0.75, 0.75, 0.75)),
         "left": ((-2.1, -1.5, 0), (-2, 1.5, 2), (0.75, 0.15, 0.1)),
         "right": ((2, -1.5, 0), (2.1, 1.5, 2), (0.1, 0.3, 0.7)),
         "block": ((0.1, 0.1, 0), (0.9, 0.9, 0.9), (0.75, 0.75, 0.75))}


def options():
    """Parse the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tool", default="penumbra", help="the command that bakes")
    parser.add_argument("--size", default="80x45", metavar="WxH", help="size of the pictures in pixels")
    parser.add_argument("--spp", type=int, default=256, help="paths per pixel of the reference")
    parser.add_argument("--frames", type=int, default=9, help="number of frames with the ball")
    parser.add_argument("--samples", type=int, default=256, help="paths per texel and probe")
    parser.add_argument("--texel-size", type=float, default=0.05, help="texel size of the lightmap in world units")
    parser.add_argument("--direct", action="store_true", help="bake the direct light into the lightmap too")
    parser.add_argument("--probes", type=int, default=1024, help="maximum number of probes")
    parser.add_argument("--occlusion", type=float, metavar="RADIUS", help="add ambient occlusion with this radius; 0: automatic")
    parser.add_argument("--live", type=int, default=0, metavar="UPDATES", help="use DDGI instead of the bakes, with this number of updates per frame")
    parser.add_argument("--keep", metavar="FOLDER", help="folder that keeps bakes and traced pictures for the next run")
    parser.add_argument("--pictures", metavar="FOLDER", help="write our picture, the reference and their difference there")
    args = parser.parse_args()
    args.size = tuple(map(int, args.size.split("x")))
    return args


def corners(low, high):
    """Corners of a box."""
    (a, b, c), (d, e, f) = low, high
    return [(a, b, c), (d, b, c), (d, e, c), (a, e, c), (a, b, f), (d, b, f), (d, e, f), (a, e, f)]


def sides(low, high):
    """Points and polygons of the sides of a box. Each side has four points of its own, so that shading is flat."""
    points = corners(low, high)
    return [points[i] for side in SIDES for i in side], [tuple(range(4 * n, 4 * n + 4)) for n in range(len(SIDES))]


def scene_file(folder):
    """Write the room without the ball to a scene file for the bakes. Returns its path."""
    objects = []
    for name, (low, high, color) in BOXES.items():
        points, polygons = sides(low, high)
        objects.append({"name": name, "mesh": {"points": points, "polygons": polygons},
                        "material": {"color": color, "shading": "flat"}})
    path = os.path.join(folder, "room.json")
    with open(path, "w", encoding="ascii") as file:
        json.dump({"objects": objects, "lights": [{"type": "point", "position": LAMP[0], "intensity": LAMP[1]}]}, file)
    return path


def baked(args, folder):
    """Bake the lightmap and the probes, unless the folder has them. Returns their files."""
    scene = scene_file(folder)
    files = []
    for kind, suffix, more in (("lightmap", "vti", ["--texel-size", args.texel_size]), ("probes", "vti", ["--probes", args.probes])):
        if kind == "lightmap" and args.direct:
            more.append("--direct")
        file = os.path.join(folder, f"{kind}_{'_'.join(map(str, more[1:]))}_{args.samples}.{suffix}")
        if not os.path.exists(file):
            command = [args.tool, "bake", kind, scene, "-o", file, "--samples", args.samples] + more
            subprocess.run(list(map(str, command)), check=True, stdout=subprocess.DEVNULL)
        files.append(file)
    return files


class Room:
    """The room and the ball in plain VTK. mask: draw the ball white and everything else black."""

    def __init__(self, mask=False):
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0, 0, 0)
        for low, high, color in BOXES.values():
            points, polygons, data = vtkPoints(), vtkCellArray(), vtkPolyData()
            points.SetDataTypeToDouble()  # as in the command, because the bake compares all digits
            corner_points, sides_of_box = sides(low, high)
            for point in corner_points:
                points.InsertNextPoint(point)
            for polygon in sides_of_box:
                polygons.InsertNextCell(len(polygon), polygon)
            data.SetPoints(points)
            data.SetPolys(polygons)
            self.add(data, color, mask, 0.0).GetProperty().SetInterpolationToFlat()
        source = vtkSphereSource()
        source.SetRadius(RADIUS)
        source.SetPhiResolution(48)
        source.SetThetaResolution(96)
        source.Update()
        self.ball = self.add(source.GetOutput(), (0.9, 0.9, 0.9), mask, 1.0)
        lamp = vtkLight()
        lamp.SetLightTypeToSceneLight()
        lamp.PositionalOn()
        lamp.SetConeAngle(180)
        lamp.SetPosition(LAMP[0])
        lamp.SetIntensity(LAMP[1])
        self.renderer.AddLight(lamp)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0, -5.2, 1.2)
        camera.SetFocalPoint(0, 0, 0.9)
        camera.SetViewUp(0, 0, 1)
        self.at(0)
        self.renderer.ResetCameraClippingRange()

    def add(self, data, color, mask, brightness):
        mapper, actor = vtkPolyDataMapper(), vtkActor()
        mapper.SetInputData(data)
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor((brightness,) * 3 if mask else color)
        actor.GetProperty().SetLighting(not mask)
        self.renderer.AddActor(actor)
        return actor

    def at(self, moment):
        """Place the ball at a time from 0 to 1, while it bounces through the room; None removes it."""
        self.ball.SetVisibility(moment is not None)
        if moment is not None:
            self.ball.SetPosition(-1.4 + 2.8 * moment, -0.5, RADIUS + 0.7 * abs(np.sin(2 * np.pi * moment)))


def traced(args, moment):
    """Picture of the path tracer."""
    camera = Camera(args.size, "reference", Room(), **{"path-tracing.samples": args.spp, "path-tracing.bounces": BOUNCES})
    camera.room.at(moment)
    return camera.picture(args.spp)


def drawn_camera(args, files):
    """A camera that draws the room with both bakes and ray-traced shadows."""
    on, settings = ["ray-traced-shadows"] + (["ddgi"] if args.live else []), {"ddgi.probes": args.probes}
    if args.occlusion is not None:
        on.append("ambient-occlusion")
        settings["ambient-occlusion.radius"] = args.occlusion
    camera = Camera(tuple(FINER * n for n in args.size), "off", Room(), on=on, **settings)
    for file in files:
        penumbra.load_bake(camera.gi, file)
    return camera


def difference(ours, truth):
    """Picture of the signed difference: red for too much light, blue for too little, with full colour at a quarter of the
    mean."""
    off = np.clip((ours - truth).mean(axis=-1, keepdims=True) / (0.25 * truth.mean()), -1, 1)
    return 1 - np.concatenate([np.maximum(-off, 0), abs(off), np.maximum(off, 0)], axis=-1)


def main():
    """Print the errors of each frame, separately for static surfaces and the ball."""
    args = options()
    with tempfile.TemporaryDirectory() as scratch:
        folder = args.keep or scratch
        os.makedirs(folder, exist_ok=True)
        camera = drawn_camera(args, [] if args.live else baked(args, folder))
    mask = Room(mask=True)
    mask_window = penumbra.window(mask.renderer, size=tuple(FINER * n for n in args.size), multisamples=0)
    still, ball = [], []
    for frame in [None] + list(range(args.frames)):
        moment = frame if frame is None else frame / max(args.frames - 1, 1)
        camera.room.at(moment)
        ours = smaller(camera.picture(args.live or 1))
        if camera.gi.GetNotes():
            sys.exit(camera.gi.GetNotes())
        truth = kept(args.keep, f"baked_{args.size[0]}_{args.spp}_{args.frames}_{frame}", lambda m=moment: traced(args, m))
        write(args.pictures, f"baked_{'empty' if frame is None else format(frame, '02d')}.png", ours, truth,
              difference(ours, truth) ** 2.2)
        mask.at(moment)
        share = smaller(penumbra.render(mask_window) / 255.0)[..., 0]
        still.append(penumbra.relative_error(ours, truth, share == 0))
        print(f"{'no ball' if frame is None else f'frame {frame}'}: static surfaces relMSE {still[-1][0]:.4f}, "
              f"signed mean {100 * still[-1][1]:+.2f} %", end="" if frame is not None else "\n")
        if frame is not None:
            ball.append(penumbra.relative_error(ours, truth, share == 1))
            print(f"; ball {ball[-1][0]:.4f}, {100 * ball[-1][1]:+.2f} %")
    passed = True
    for name, value, limit in (
            ("relMSE without the ball", still[0][0], EMPTY), ("signed mean without it", abs(still[0][1]), EMPTY_MEAN),
            ("mean relMSE of static surfaces", np.mean([e for e, _ in still[1:]]), STILL),
            ("mean relMSE of the ball", np.mean([e for e, _ in ball]), BALL),
            ("worst signed mean", max(abs(mean) for _, mean in still[1:] + ball), MEAN)):
        print(f"{name}: {value:.4f}, at most {limit}{'' if value <= limit else ': TOO MUCH'}")
        passed &= bool(value <= limit)
    sys.exit(0 if passed else 1)


if __name__ == "__main__":
    main()
