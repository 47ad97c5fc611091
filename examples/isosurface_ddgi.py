#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""A time-varying isosurface in a room; the surface and the walls light each other by DDGI.

The surface is an isosurface of the probability density of an electron in a hydrogen atom, in a superposition of two
states, coloured by the phase of its wave function. Its shape and colours change in every frame, the colour map changes
once, and the light follows. Writes FOLDER/0000.png and so on, and FOLDER/strip.png. ffmpeg -i FOLDER/%04d.png movie.mp4
makes a film of them.
"""
import argparse
import math
import pathlib
import sys
import time

import numpy
import penumbra
from cornell_moving_light import SIDES, side
from PIL import Image
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkRenderingCore import vtkActor, vtkColorTransferFunction, vtkLight, vtkPolyDataMapper, vtkRenderer

HALF = 17.0     # half of the room's extent, in Bohr radii
SAMPLES = 48    # of the field, along each axis
DENSITY = 6e-5  # probability density on the surface, per cubed Bohr radius
COLORS = {"white": (0.75, 0.75, 0.75), "left": (0.70, 0.42, 0.12), "right": (0.15, 0.40, 0.55)}
# Colours of the phase, from opposite to aligned, each from a time on.
MAPS = ((0.0, ((0.10, 0.25, 0.85), (0.85, 0.85, 0.80), (0.90, 0.20, 0.05))),
        (0.6, ((0.55, 0.10, 0.60), (0.90, 0.85, 0.75), (0.10, 0.65, 0.20))))
BLOCK = 4       # width of the blocks of pixels whose means are compared with the path tracer


def orbital(n, x, y, z):
    """The real wave functions 2p and 3d along z, in units of Bohr radii (Griffiths 1995, Introduction to Quantum
    Mechanics, section 4.2)."""
    r = numpy.sqrt(x * x + y * y + z * z)
    if n == 2:
        return z * numpy.exp(-r / 2) / (4 * math.sqrt(2 * math.pi))
    return (3 * z * z - r * r) * numpy.exp(-r / 3) / (81 * math.sqrt(6 * math.pi))


class Atom:
    """The isosurface of a superposition of two states. Its shape has period 1 in time."""

    def __init__(self):
        steps = numpy.linspace(-0.95 * HALF, 0.95 * HALF, SAMPLES)
        z, y, x = numpy.meshgrid(steps, steps, steps, indexing="ij")
        self.low, self.high = orbital(2, x, y, z), orbital(3, x, y, z)
        self.field = vtkImageData()
        self.field.SetDimensions(SAMPLES, SAMPLES, SAMPLES)
        self.field.SetOrigin(steps[0], steps[0], steps[0])
        self.field.SetSpacing(*3 * (steps[1] - steps[0],))
        surface = vtkFlyingEdges3D()
        surface.SetInputData(self.field)
        surface.SetValue(0, DENSITY)
        surface.ComputeScalarsOff()
        surface.InterpolateAttributesOn()
        self.mapper, self.actor = vtkPolyDataMapper(), vtkActor()
        self.mapper.SetInputConnection(surface.GetOutputPort())
        self.mapper.SetScalarModeToUsePointFieldData()
        self.mapper.SelectColorArray("phase")
        self.mapper.InterpolateScalarsBeforeMappingOff()
        self.actor.SetMapper(self.mapper)

    def at(self, moment):
        wave = 0.6 * self.low + 0.8 * self.high * numpy.exp(-2j * math.pi * moment)
        for name, values in (("density", abs(wave) ** 2), ("phase", wave.real / numpy.maximum(abs(wave), 1e-12))):
            array = numpy_to_vtk(values.ravel(), deep=True)
            array.SetName(name)
            self.field.GetPointData().AddArray(array)
        self.field.GetPointData().SetActiveScalars("density")
        self.field.Modified()
        colors = vtkColorTransferFunction()
        for value, color in zip((-1, 0, 1), [colors for since, colors in MAPS if since <= moment][-1]):
            colors.AddRGBPoint(value, *color)
        self.mapper.SetLookupTable(colors)


class Room:
    """The room with a lamp, and the atom at a time from 0 to 1."""

    def __init__(self):
        self.renderer, self.atom = vtkRenderer(), Atom()
        for name, (_, corners) in SIDES.items():
            mapper, wall = vtkPolyDataMapper(), vtkActor()
            mapper.SetInputData(side((2 * numpy.array(corners) - 1) * HALF))
            wall.SetMapper(mapper)
            wall.GetProperty().SetColor(COLORS.get(name, COLORS["white"]))
            wall.GetProperty().SetInterpolationToFlat()
            self.renderer.AddActor(wall)
        self.renderer.AddActor(self.atom.actor)
        lamp = vtkLight()
        lamp.SetLightTypeToSceneLight()
        lamp.PositionalOn()
        lamp.SetConeAngle(180)
        lamp.SetPosition(0.55 * HALF, -0.75 * HALF, 0.8 * HALF)
        lamp.SetIntensity(0.7)
        self.renderer.AddLight(lamp)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0, -4 * HALF, 0)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(38)
        self.at(0.0)
        self.renderer.ResetCameraClippingRange()

    def at(self, moment):
        self.atom.at(moment)


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", metavar="FOLDER", type=pathlib.Path, default=pathlib.Path("isosurface"))
    parser.add_argument("--frames", type=int, default=60, help="number of frames (60)")
    parser.add_argument("--size", default="480x480", metavar="WxH", help="size of a frame in pixels (480x480)")
    parser.add_argument("--compare", type=int, default=0, metavar="PATHS",
                        help="compare three frames with the path tracer at this many paths per pixel: print relMSE and "
                             "signed mean of linear radiance, and write pairs of pictures")
    args = parser.parse_args()
    try:
        args.size = tuple(map(int, args.size.split("x")))
        if len(args.size) != 2 or min(args.size) < BLOCK or args.frames < 1 or args.compare < 0:
            raise ValueError
    except ValueError:
        parser.error(f"--size is two numbers of at least {BLOCK} as 480x480, --frames at least 1, --compare at least 0")
    return args


class Progress:
    """A progress bar, shown only on a terminal."""

    def __init__(self, steps):
        self.steps, self.done, self.started = steps, 0, time.monotonic()

    def step(self, what):
        self.done += 1
        if sys.stderr.isatty():
            left = (time.monotonic() - self.started) / self.done * (self.steps - self.done)
            bar = "#" * (30 * self.done // self.steps)
            print(f"\r[{bar:30}] {what}, {left:.0f} s left ", end="\n" if self.done == self.steps else "", file=sys.stderr)


def blocks(picture):
    """Return means of blocks of pixels, because paths sample a pixel's whole area, and frames do not."""
    height, width = (n // BLOCK * BLOCK for n in picture.shape[:2])
    return picture[:height, :width, :3].astype(float).reshape(
        height // BLOCK, BLOCK, width // BLOCK, BLOCK, 3).mean(axis=(1, 3))


def traced(size, paths, moment):
    """Return the path tracer's radiance and picture."""
    room = Room()
    room.at(moment)
    gi = penumbra.enable(room.renderer, "reference", path_tracing__samples=paths)
    gi.KeepRadianceOn()
    window = penumbra.window(room.renderer, size=size, multisamples=0)
    picture = penumbra.render(window, frames=paths)
    return penumbra.radiance(gi, room.renderer), picture


def main():
    args = options()
    args.output.mkdir(parents=True, exist_ok=True)
    room = Room()
    gi = penumbra.enable(room.renderer, "balanced", on="ddgi")
    gi.KeepRadianceOn()
    window = penumbra.window(room.renderer, size=args.size, multisamples=0)
    chosen = sorted({(2 * part + 1) * args.frames // 6 for part in range(3)})
    progress = Progress(args.frames + (len(chosen) if args.compare else 0))
    strip, pairs = [], []
    for frame in range(args.frames):
        room.at(frame / args.frames)
        picture = penumbra.render(window)
        Image.fromarray(picture).save(args.output / f"{frame:04d}.png")
        if len(strip) * args.frames <= 6 * frame:  # six frames, evenly spaced
            strip.append(picture)
        if frame in chosen:
            pairs.append((frame, picture, penumbra.radiance(gi, room.renderer)))
        progress.step(f"frame {frame + 1} of {args.frames}")
    Image.fromarray(numpy.concatenate(strip, axis=1)).save(args.output / "strip.png")
    for frame, picture, ours in pairs if args.compare else ():
        truth, exact = traced(args.size, args.compare, frame / args.frames)
        progress.step(f"traced frame {frame}")
        error, mean = penumbra.relative_error(blocks(ours), blocks(truth))
        print(f"frame {frame}: relMSE {error:.4f}, signed mean {100 * mean:+.2f} %")
        Image.fromarray(numpy.concatenate((picture, exact), axis=1)).save(args.output / f"compared_{frame:04d}.png")


if __name__ == "__main__":
    main()
