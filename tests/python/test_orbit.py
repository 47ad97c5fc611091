# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""An orbit around each of the demo's scenes: no view differs abruptly, no surface is black, no value is infinite or NaN."""
import pathlib
import sys
import unittest

import numpy as np
import penumbra
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkWindowToImageFilter

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "examples"))
import scenes  # noqa: E402 the demo's scenes

VIEWS = 36
WIDTH, HEIGHT = 240, 180


def picture(window):
    """Picture of a window, rows from the bottom, values from 0 to 1."""
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    return vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).reshape(HEIGHT, WIDTH, 3) / 255.0


def linear(gi, renderer):
    image = vtkImageData()
    assert gi.GetRadiance(renderer, image)
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(HEIGHT, WIDTH, 4)


class Orbit(unittest.TestCase):
    def check_orbit(self, name):
        renderer = scenes.SCENES[name][1]()
        window = vtkRenderWindow()
        window.SetSize(WIDTH, HEIGHT)
        window.SetMultiSamples(0)
        window.AddRenderer(renderer)
        gi = penumbra.vtkGIPass()
        gi.SetPreset("balanced")
        gi.KeepRadianceOn()
        gain = []
        for view in range(VIEWS + 1):
            renderer.SetPass(None)
            stock = picture(window).mean(axis=2)
            renderer.SetPass(gi)
            # Accumulated light lags by some frames, so it settles first in the first and last view, which are compared.
            for _ in range(12 if view in (0, VIEWS) else 1):
                lit = picture(window).mean(axis=2)
            radiance = linear(gi, renderer)
            surface = radiance[..., 3] > 0
            self.assertTrue(np.isfinite(radiance).all(), f"{name}, view {view}: not finite")
            self.assertGreater(surface.mean(), 0.05, f"{name}, view {view}: almost nothing in view")
            black = (surface & (lit < 1 / 255) & (stock > 8 / 255)).sum() / surface.sum()
            self.assertLess(black, 0.002, f"{name}, view {view}: black where stock VTK is not")
            gain.append(lit[surface].mean() - stock[surface].mean())
            renderer.GetActiveCamera().Azimuth(360.0 / VIEWS)
            renderer.ResetCameraClippingRange()
        # The difference in brightness from stock VTK changes smoothly between views, as shadows come into view. A lost map,
        # a flipped normal or a stale texture in one view shows in the second difference.
        curvature = np.abs(np.diff(gain, 2)).max()
        print(f"{name}: brighter than stock by {min(gain):.3f} to {max(gain):.3f}, "
              f"largest second difference {curvature:.4f}, first and last view differ by {abs(gain[-1] - gain[0]):.5f}")
        self.assertLess(curvature, 0.02)
        self.assertLess(abs(gain[-1] - gain[0]), 0.002)

    def test_head(self):
        self.check_orbit("head")

    def test_protein(self):
        self.check_orbit("protein")

    def test_terrain(self):
        self.check_orbit("terrain")


if __name__ == "__main__":
    unittest.main()
