#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""A Cornell box with a moving lamp and a moving block, lit by DDGI: cornell_moving_light.py FOLDER [FRAMES] [WIDTH]

Writes FOLDER/0000.png and so on. ffmpeg -i FOLDER/%04d.png movie.mp4 makes a film of them.
"""
import math
import pathlib
import sys
import time

import penumbra
from PIL import Image
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

WHITE, RED, GREEN = (0.73, 0.73, 0.73), (0.65, 0.05, 0.05), (0.12, 0.45, 0.15)
# Corners of the unit cube's sides. The side towards the camera is open.
SIDES = {
    "floor": (WHITE, ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))),
    "ceiling": (WHITE, ((0, 0, 1), (0, 1, 1), (1, 1, 1), (1, 0, 1))),
    "back": (WHITE, ((0, 1, 0), (1, 1, 0), (1, 1, 1), (0, 1, 1))),
    "left": (RED, ((0, 0, 0), (0, 1, 0), (0, 1, 1), (0, 0, 1))),
    "right": (GREEN, ((1, 0, 0), (1, 0, 1), (1, 1, 1), (1, 1, 0))),
}


def painted(data, color):
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetInterpolationToFlat()
    return actor


def side(corners):
    points, polygons, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    for corner in corners:
        points.InsertNextPoint(corner)
    polygons.InsertNextCell(4, range(4))
    data.SetPoints(points)
    data.SetPolys(polygons)
    return data


def cuboid(width, depth, height):
    source = vtkCubeSource()
    source.SetBounds(-width / 2, width / 2, -depth / 2, depth / 2, 0.0, height)
    source.Update()
    return source.GetOutput()


class Room:
    """The room, with the positions of its lamp and blocks at a time from 0 to 1."""

    def __init__(self):
        self.renderer = vtkRenderer()
        self.renderer.AutomaticLightCreationOff()
        self.renderer.SetBackground(0, 0, 0)
        for color, corners in SIDES.values():
            self.renderer.AddActor(painted(side(corners), color))
        self.tall = painted(cuboid(0.3, 0.3, 0.6), WHITE)
        self.short = painted(cuboid(0.28, 0.28, 0.28), WHITE)
        for box in (self.tall, self.short):
            self.renderer.AddActor(box)
        self.tall.SetPosition(0.33, 0.68, 0.0)
        self.tall.SetOrientation(0, 0, 20)
        self.lamp = vtkLight()
        self.lamp.SetLightTypeToSceneLight()
        self.lamp.PositionalOn()
        self.lamp.SetConeAngle(180)
        self.renderer.AddLight(self.lamp)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0.5, -1.4, 0.5)
        camera.SetFocalPoint(0.5, 0.5, 0.5)
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(40)
        self.at(0.0)
        self.renderer.ResetCameraClippingRange()

    def at(self, moment):
        turn = 2 * math.pi * moment
        self.lamp.SetPosition(0.5 + 0.3 * math.cos(turn), 0.5 + 0.3 * math.sin(turn), 0.8)
        self.short.SetPosition(0.65 - 0.2 * math.sin(turn), 0.3 + 0.1 * math.sin(turn), 0.0)
        self.short.SetOrientation(0, 0, 360 * moment)


def main():
    folder = pathlib.Path(sys.argv[1])
    frames = int(sys.argv[2]) if len(sys.argv) > 2 else 60
    width = int(sys.argv[3]) if len(sys.argv) > 3 else 512
    folder.mkdir(parents=True, exist_ok=True)
    room = Room()
    penumbra.enable(room.renderer, "balanced", on="ddgi")
    window = penumbra.window(room.renderer, size=(width, width))
    started = time.monotonic()
    for frame in range(frames):
        room.at(frame / frames)
        Image.fromarray(penumbra.render(window)).save(folder / f"{frame:04d}.png")
        left = (time.monotonic() - started) / (frame + 1) * (frames - frame - 1)
        if sys.stderr.isatty():
            print(f"\rframe {frame + 1} of {frames}, {left:.0f} s left ", end="", file=sys.stderr)
    if sys.stderr.isatty():
        print(file=sys.stderr)


if __name__ == "__main__":
    main()
