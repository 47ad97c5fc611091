#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""A still room in the light of its lightmap and a ball that moves through it in that of baked probes, both at once,
beside the path tracer. Exit code 1 where an error is above its limit or a bake does not fit."""
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

# Limits of relMSE without the ball, and its mean over the frames of still surfaces and of the ball; of the signed mean,
# without the ball and in any frame. A third to a half above what is measured at 240x135; smaller pictures blur the dark
# below the ball, and err less. Without the ball most of it is the truth's noise; with it, what the bakes cannot know: the
# light that the ball takes away (docs/indirect-light.md).
EMPTY, STILL, BALL = 0.003, 0.018, 0.04
EMPTY_MEAN, MEAN = 0.005, 0.10
BOUNCES = 30
RADIUS = 0.35
LAMP = ((-0.9, -1.1, 1.7), 0.5)
SIDES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (2, 3, 7, 6), (0, 4, 7, 3), (1, 2, 6, 5))  # of a box's corners
# Two opposite corners and a colour; the room is open toward the eye.
BOXES = {"floor": ((-2, -1.5, -0.1), (2, 1.5, 0), (0.75, 0.75, 0.75)),
         "ceiling": ((-2, -1.5, 2), (2, 1.5, 2.1), (0.75, 0.75, 0.75)),
         "back": ((-2, 1.5, 0), (2, 1.6, 2), (0.75, 0.75, 0.75)),
         "left": ((-2.1, -1.5, 0), (-2, 1.5, 2), (0.75, 0.15, 0.1)),
         "right": ((2, -1.5, 0), (2.1, 1.5, 2), (0.1, 0.3, 0.7)),
         "block": ((0.1, 0.1, 0), (0.9, 0.9, 0.9), (0.75, 0.75, 0.75))}


def options():
    """From the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tool", default="penumbra", help="the command that bakes")
    parser.add_argument("--size", default="80x45", metavar="WxH", help="of the pictures, pixels")
    parser.add_argument("--spp", type=int, default=256, help="paths through each pixel of the truth")
    parser.add_argument("--frames", type=int, default=9, help="of the ball's way")
    parser.add_argument("--samples", type=int, default=256, help="paths of each texel and probe")
    parser.add_argument("--texel-size", type=float, default=0.05, help="of the lightmap, world units")
    parser.add_argument("--direct", action="store_true", help="the lamp's own light too is the lightmap's")
    parser.add_argument("--probes", type=int, default=1024, help="at most")
    parser.add_argument("--occlusion", type=float, metavar="RADIUS", help="with ambient occlusion of that radius; 0: automatic")
    parser.add_argument("--live", type=int, default=0, metavar="UPDATES", help="DDGI in place of the bakes, so many updates a frame")
    parser.add_argument("--keep", metavar="FOLDER", help="where bakes and traced pictures are kept for the next run")
    parser.add_argument("--pictures", metavar="FOLDER", help="write ours, the truth and their difference there")
    args = parser.parse_args()
    args.size = tuple(map(int, args.size.split("x")))
    return args


def corners(low, high):
    """Of a box."""
    (a, b, c), (d, e, f) = low, high
    return [(a, b, c), (d, b, c), (d, e, c), (a, e, c), (a, b, f), (d, b, f), (d, e, f), (a, e, f)]


def sides(low, high):
    """Of a box: four points for each, as they share no edges in the light."""
    at = corners(low, high)
    return [at[i] for side in SIDES for i in side], [tuple(range(4 * n, 4 * n + 4)) for n in range(len(SIDES))]


def scene_file(folder):
    """The room without the ball, for the bakes."""
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
    """The files of both bakes."""
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
    """The room in plain VTK, with the ball where it is at a time from 0 to 1. mask: the ball white, all else black."""

    def __init__(self, mask=False):
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0, 0, 0)
        for low, high, color in BOXES.values():
            points, polygons, data = vtkPoints(), vtkCellArray(), vtkPolyData()
            points.SetDataTypeToDouble()  # as the command has them: the bake tells other digits apart
            at, numbers = sides(low, high)
            for point in at:
                points.InsertNextPoint(point)
            for polygon in numbers:
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
        """Across the room in two leaps, before the block; None: not there."""
        self.ball.SetVisibility(moment is not None)
        if moment is not None:
            self.ball.SetPosition(-1.4 + 2.8 * moment, -0.5, RADIUS + 0.7 * abs(np.sin(2 * np.pi * moment)))


def traced(args, moment):
    """The truth."""
    camera = Camera(args.size, "reference", Room(), **{"path-tracing.samples": args.spp, "path-tracing.bounces": BOUNCES})
    camera.room.at(moment)
    return camera.picture(args.spp)


def drawn_camera(args, files):
    """With both bakes, and shadows by rays."""
    on, settings = ["ray-traced-shadows"] + (["ddgi"] if args.live else []), {"ddgi.probes": args.probes}
    if args.occlusion is not None:
        on.append("ambient-occlusion")
        settings["ambient-occlusion.radius"] = args.occlusion
    camera = Camera(tuple(FINER * n for n in args.size), "off", Room(), on=on, **settings)
    for file in files:
        penumbra.load_bake(camera.gi, file)
    return camera


def difference(ours, truth):
    """Too much light is red, too little blue; white is none, full colour a quarter of the mean."""
    off = np.clip((ours - truth).mean(axis=-1, keepdims=True) / (0.25 * truth.mean()), -1, 1)
    return 1 - np.concatenate([np.maximum(-off, 0), abs(off), np.maximum(off, 0)], axis=-1)


def main():
    """Errors of every frame, of still surfaces and of the ball apart."""
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
        print(f"{'no ball' if frame is None else f'frame {frame}'}: still surfaces relMSE {still[-1][0]:.4f}, "
              f"signed mean {100 * still[-1][1]:+.2f} %", end="" if frame is not None else "\n")
        if frame is not None:
            ball.append(penumbra.relative_error(ours, truth, share == 1))
            print(f"; ball {ball[-1][0]:.4f}, {100 * ball[-1][1]:+.2f} %")
    passed = True
    for what, value, limit in (
            ("relMSE without the ball", still[0][0], EMPTY), ("signed mean without it", abs(still[0][1]), EMPTY_MEAN),
            ("mean relMSE of still surfaces", np.mean([e for e, _ in still[1:]]), STILL),
            ("mean relMSE of the ball", np.mean([e for e, _ in ball]), BALL),
            ("worst signed mean", max(abs(mean) for _, mean in still[1:] + ball), MEAN)):
        print(f"{what}: {value:.4f}, at most {limit}{'' if value <= limit else ': TOO MUCH'}")
        passed &= bool(value <= limit)
    sys.exit(0 if passed else 1)


if __name__ == "__main__":
    main()
