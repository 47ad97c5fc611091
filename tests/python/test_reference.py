# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""With direct light only, the path tracer and the rasterizer with hard shadows draw the same pictures of the demo's scenes."""
import os
import pathlib
import sys
import unittest

import numpy as np
import penumbra
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkWindowToImageFilter

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "examples"))
import scenes  # noqa: E402 the demo's scenes

WIDTH, HEIGHT = 480, 360


def grab(window, name):
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.Update()
    folder = os.environ.get("PENUMBRA_TEST_OUTPUT")
    if folder:
        writer = vtkPNGWriter()
        writer.SetFileName(str(pathlib.Path(folder) / f"{name}.png"))
        writer.SetInputConnection(image.GetOutputPort())
        writer.Write()
    shown = vtk_to_numpy(image.GetOutput().GetPointData().GetScalars())
    return shown.reshape(HEIGHT, WIDTH, 3).astype(int)


def parameters(gi, technique, **values):
    found = gi.GetTechnique(technique)
    found.EnabledOn()
    for name, value in values.items():
        assert found.SetParameter(name.replace("_", "-"), value), found.GetLastError()


class Reference(unittest.TestCase):
    def check_agreement(self, name, maps):
        """maps: minimum share of equal pixels for shadow maps; for rays it is 99 %."""
        renderer = scenes.SCENES[name][1]()
        window = vtkRenderWindow()
        window.SetSize(WIDTH, HEIGHT)
        window.SetMultiSamples(0)
        window.AddRenderer(renderer)
        rays = penumbra.vtkGIPass()
        parameters(rays, "path-tracing", bounces=0, samples=1)
        renderer.SetPass(rays)
        reference = grab(window, f"{name}-reference")
        for technique, minimum, values in (
                ("ray-traced-shadows", 0.99, {"light_angle": 0}),
                # Rays end on the smooth surface of the shading normals. Maps of this resolution would show shadows
                # of facets on themselves without a bias of one texel.
                ("shadow-maps", maps, {"resolution": 8192, "filter_radius": 0, "constant_bias": 1,
                                       "slope_bias": 1, "normal_bias": 1})):
            raster = penumbra.vtkGIPass()
            parameters(raster, technique, **values)
            renderer.SetPass(raster)
            shadowed = grab(window, f"{name}-{technique}")
            within = (np.abs(shadowed - reference).max(axis=2) <= 2).mean()
            print(f"{name}, {technique}: {100 * within:.2f} % of the pixels within 2/255")
            self.assertGreaterEqual(within, minimum)

    def test_head(self):
        self.check_agreement("head", 0.99)

    def test_protein(self):
        self.check_agreement("protein", 0.99)

    def test_terrain(self):
        # A single map of the whole landscape moves edges of shadows by up to a pixel, and there are many edges.
        self.check_agreement("terrain", 0.96)


if __name__ == "__main__":
    unittest.main()
