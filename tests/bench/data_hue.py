#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shift of hue of a colour-mapped isosurface between a red and a green wall: CIEDE2000 and its part of hue against the
same picture without indirect light, with DDGI and the path tracer, with and without the technique data-colors. Exits with 1 if
the 99th percentile of the hue part exceeds 2 with it. Then the same surface alone under each look against its unlit colours,
which a legend shows."""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import penumbra
from PIL import Image
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkElevationFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkColorTransferFunction, vtkLight, vtkPolyDataMapper, vtkRenderer

LIMIT = 2.0  # of the hue part's 99th percentile
HALF = 12.0  # half of the room's width
# Five colours of viridis (van der Walt and Smith 2015).
VIRIDIS = ((0.267, 0.005, 0.329), (0.229, 0.322, 0.546), (0.128, 0.567, 0.551), (0.369, 0.789, 0.383), (0.993, 0.906, 0.144))


def wall(renderer, corners, color):
    """A matte rectangle given by its origin and the two corners next to it."""
    plane = vtkPlaneSource()
    plane.SetOrigin(*corners[0])
    plane.SetPoint1(*corners[1])
    plane.SetPoint2(*corners[2])
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(plane.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    renderer.AddActor(actor)


def isosurface():
    """A lumpy surface around the origin, coloured by its height."""
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(*([-10, 10] * 3))
    contour = vtkContourFilter()
    contour.SetInputConnection(source.GetOutputPort())
    contour.SetValue(0, 160.0)
    height = vtkElevationFilter()
    height.SetInputConnection(contour.GetOutputPort())
    height.SetLowPoint(0, 0, -7)
    height.SetHighPoint(0, 0, 7)
    colors = vtkColorTransferFunction()
    for i, color in enumerate(VIRIDIS):
        colors.AddRGBPoint(i / 4, *color)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(height.GetOutputPort())
    mapper.SetLookupTable(colors)
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def scene():
    """The room, its surface and a lamp of white light."""
    renderer = vtkRenderer()
    h = HALF
    wall(renderer, ((-h, -h, -h), (-h, h, -h), (-h, -h, h)), (0.8, 0.05, 0.05))
    wall(renderer, ((h, -h, -h), (h, h, -h), (h, -h, h)), (0.05, 0.7, 0.05))
    for z in (-h, h):
        wall(renderer, ((-h, -h, z), (h, -h, z), (-h, h, z)), (0.8, 0.8, 0.8))
    wall(renderer, ((-h, h, -h), (h, h, -h), (-h, h, h)), (0.8, 0.8, 0.8))
    surface = isosurface()
    renderer.AddActor(surface)
    lamp = vtkLight()
    lamp.SetLightTypeToSceneLight()
    lamp.PositionalOn()
    lamp.SetConeAngle(180)
    lamp.SetIntensity(0.5)  # so that no colour is cut off at white
    lamp.SetPosition(0, -0.7 * h, 0.8 * h)
    renderer.AddLight(lamp)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, -3.6 * h, 0)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(34)
    renderer.ResetCameraClippingRange()
    return renderer, surface


def compared(command, folder, pixels, reference):
    """What penumbra compare prints for two lists of pixels."""
    paths = [folder / "pixels.png", folder / "reference.png"]
    for path, values in zip(paths, (pixels, reference)):
        Image.fromarray(values[np.newaxis]).save(path)
    return json.loads(subprocess.run([command, "compare", *map(str, paths), "--json"], check=True, capture_output=True, text=True).stdout)


def light(surface, on):
    """Light the surface, or show its own colours."""
    surface.GetProperty().SetDiffuse(1 if on else 0)
    surface.GetProperty().SetAmbient(0 if on else 1)


def print_looks(command, size, preset):
    """Print the shift of hue under each look."""
    renderer, surface = vtkRenderer(), isosurface()
    renderer.AddActor(surface)
    window = penumbra.window(renderer, size=size, multisamples=0)
    renderer.SetBackground(0, 0, 0)
    renderer.ResetCamera()
    light(surface, False)
    legend = penumbra.render(window)[..., :3]
    light(surface, True)
    where = legend.any(axis=-1)
    for look in penumbra.looks():
        penumbra.enable(renderer, preset, look=look.name)
        picture = penumbra.render(window, frames=16)[..., :3]
        with tempfile.TemporaryDirectory() as folder:
            values = compared(command, pathlib.Path(folder), picture[where], legend[where])
        print(f"{look.name}: ΔH mean {values['delta-h-mean']:.2f}, 99th percentile {values['delta-h-p99']:.2f}; "
              f"ΔE mean {values['delta-e-mean']:.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--command", default="penumbra", help="the penumbra command")
    parser.add_argument("--size", default="320x240")
    parser.add_argument("--frames", type=int, default=60, help="frames with DDGI; the path tracer takes four times as many")
    parser.add_argument("--preset", default="balanced", help="under the looks (default %(default)s)")
    parser.add_argument("--pictures", type=pathlib.Path, help="folder for the pictures")
    options = parser.parse_args()
    size = tuple(int(n) for n in options.size.split("x"))
    renderer, surface = scene()
    window = penumbra.window(renderer, size=size, multisamples=0)

    def shot(frames, preset="off", **settings):
        penumbra.enable(renderer, preset, **settings)
        return penumbra.render(window, frames=frames)[..., :3]

    direct = {"without": shot(1), "with": shot(1, on=["data-colors"])}
    surface.VisibilityOff()
    where = np.any(shot(1) != direct["without"], axis=-1)
    surface.VisibilityOn()
    worst = 0.0
    with tempfile.TemporaryDirectory() as temporary:
        for way, settings, frames in (("DDGI", {"preset": "off", "on": ["ddgi"]}, options.frames),
                                      ("path tracer", {"preset": "reference"}, 4 * options.frames)):
            for name, extra in (("without", []), ("with", ["data-colors"])):
                on = settings.get("on", []) + extra
                picture = shot(frames, **{**settings, "on": on})
                if options.pictures:
                    Image.fromarray(picture).save(options.pictures / f"{way.replace(' ', '-')}-{name}.png")
                values = compared(options.command, pathlib.Path(temporary), picture[where], direct[name][where])
                print(f"{way}, {name} data-colors: ΔH mean {values['delta-h-mean']:.2f}, 99th percentile {values['delta-h-p99']:.2f}; "
                      f"ΔE mean {values['delta-e-mean']:.2f}")
                worst = max(worst, values["delta-h-p99"]) if extra else worst
    print_looks(options.command, size, options.preset)
    return int(worst > LIMIT)


if __name__ == "__main__":
    sys.exit(main())
