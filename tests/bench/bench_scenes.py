# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of the benchmarks, and the arguments that choose among them."""
import argparse
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkTexture

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples"))

import scenes  # noqa: E402
from isosurface_ddgi import Room  # noqa: E402

DEMO = list(scenes.SCENES)
SCENES = {name: function for name, (_, function) in scenes.SCENES.items()}
SCENES["isosurface"] = lambda: Room().renderer


def surround(renderer, radiance):
    """Light a scene by an equirectangular image of radiance, lowest row first."""
    image = vtkImageData()
    image.SetDimensions(radiance.shape[1], radiance.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(radiance.reshape(-1, 3).astype(np.float32), deep=True))
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.SetColorModeToDirectScalars()
    texture.MipmapOn()
    texture.InterpolateOn()
    renderer.SetEnvironmentTexture(texture)
    renderer.UseImageBasedLightingOn()
    # VTK's own tables, which only its highlights use, are made as small as possible.
    renderer.GetEnvMapPrefiltered().SetPrefilterMaxSamples(2)
    renderer.GetEnvMapPrefiltered().SetPrefilterLevels(2)
    renderer.GetEnvMapIrradiance().SetIrradianceSize(8)
    renderer.GetEnvMapIrradiance().SetIrradianceStep(0.3)
    renderer.GetEnvMapLookupTable().SetLUTSize(8)
    renderer.GetEnvMapLookupTable().SetLUTSamples(8)


class Parser(argparse.ArgumentParser):
    """A command line with scenes, the size of pictures and parameters."""

    def __init__(self, description, size, chosen=tuple(SCENES), parameter="TECHNIQUE.PARAMETER=VALUE"):
        super().__init__(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
        self.add_argument("scenes", nargs="*", metavar="SCENE", default=list(chosen), help="any of " + ", ".join(SCENES))
        self.add_argument("--size", default=size, type=_size, metavar="WxH", help=f"size of the pictures (default {size})")
        self.add_argument("--set", action="append", default=[], type=_setting, metavar=parameter, help="a parameter")

    def parse(self):
        """The arguments; `set` is a dictionary. Ends the program with a sentence at a mistake."""
        args = self.parse_args()
        for name in args.scenes:
            if name not in SCENES:
                self.error(f"there is no scene '{name}': choose from {', '.join(SCENES)}")
        args.set = dict(args.set)
        return args


def _size(text):
    width, _, height = text.partition("x")
    if not (width.isdigit() and height.isdigit() and int(width) > 0 and int(height) > 0):
        raise argparse.ArgumentTypeError(f"'{text}' is no size such as 320x180")
    return int(width), int(height)


def _setting(text):
    name, equals, value = text.partition("=")
    if not (name and equals):
        raise argparse.ArgumentTypeError(f"'{text}' must be NAME=VALUE")
    return name, value
