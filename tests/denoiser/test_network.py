# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""The denoiser's network: its file, and the shaders against the reference in NumPy."""
import ctypes.util
import os
import pathlib
import tempfile
import unittest

import data
import numpy as np
import penumbra
import reference
import weights
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

NETWORK = pathlib.Path(__file__).resolve().parents[2] / "glsl" / "denoising" / "network.txt"
SIZE = 97, 75     # no multiples of anything
LARGE = 193, 151  # larger than the pictures of the training
REFLECTANCE = 0.8


class File(unittest.TestCase):
    """The file of weights."""

    def test_is_small_and_complete(self):
        self.assertLess(NETWORK.stat().st_size, 128 * 1024)
        facts, layers = weights.read(NETWORK)
        self.assertIn("generator", facts)
        self.assertEqual(sum(layer.count() for layer in layers.values()), 34132)

    def test_is_read_as_it_was_written(self):
        facts, layers = weights.read(NETWORK)
        with tempfile.TemporaryDirectory() as folder:
            copy = os.path.join(folder, "copy.txt")
            weights.write(copy, facts, layers)
            self.assertEqual(NETWORK.read_bytes(), pathlib.Path(copy).read_bytes())

    def test_damage_is_noticed(self):
        text = NETWORK.read_text(encoding="ascii")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "damaged.txt")
            for damaged in (text.replace("A", "B", 1), text[:len(text) // 2], "", "\u00e9"):
                pathlib.Path(path).write_text(damaged, encoding="utf-8")
                with self.assertRaisesRegex(ValueError, r"damaged.txt is not a denoiser's network, or is damaged: .*\.$"):
                    weights.read(path)


class Concavity(unittest.TestCase):
    """How hollow surfaces are."""

    def found(self, height):
        """The concavity of surfaces that face the eye at this height toward it, a function of the distances from the middle."""
        y, x = np.mgrid[-32:33, -40:41]
        depth = height(x, y) - 3
        shape = depth.shape
        signal = data.Signal(np.ones((*shape, 3)), np.zeros(shape), np.ones(shape), np.full((*shape, 2), 0.5), depth,
                             np.array((2.0, 2.5)))
        return reference.Surfaces(signal).concavity

    def test_hollows_are_positive_and_ridges_negative(self):
        valley = self.found(lambda x, y: 0.05 * np.abs(x))
        self.assertGreater(valley[32, 40], 0.1)
        self.assertLess(self.found(lambda x, y: -0.05 * np.abs(x))[32, 40], -0.05)
        self.assertLess(self.found(lambda x, y: -0.02 * np.hypot(x, y))[32, 40], -0.1)

    def test_a_face_is_flat_beside_its_edges_and_its_corner(self):
        falling = self.found(lambda x, y: -0.1 * (np.maximum(x, 0) + np.maximum(y, 0)))
        self.assertLess(np.abs(falling[:33, :41]).max(), 1e-6)
        rising = self.found(lambda x, y: 0.1 * np.maximum(x, 0))
        self.assertGreater(rising[32, 40], 0.05)


def white(source):
    """An actor without highlights."""
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputConnection(source.GetOutputPort())
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor([REFLECTANCE] * 3)
    actor.GetProperty().SetSpecular(0)
    actor.GetProperty().SetAmbient(0)
    return actor


def lit_boxes():
    """A ground with boxes and balls, which one box lights: all light is indirect, so the picture is reflectance times that."""
    renderer = vtkRenderer()
    ground = vtkPlaneSource()
    ground.SetOrigin(-2, -2, 0)
    ground.SetPoint1(2, -2, 0)
    ground.SetPoint2(-2, 2, 0)
    renderer.AddActor(white(ground))
    for number, place in enumerate(((-0.7, 0, 0.4), (0.5, 0.3, 0.3), (0, -0.6, 0.2))):
        cube = vtkCubeSource()
        cube.SetCenter(place)
        cube.SetXLength(2 * place[2])
        cube.SetYLength(2 * place[2])
        cube.SetZLength(2 * place[2])
        actor = white(cube)
        actor.GetProperty().SetAmbient(1 if number == 1 else 0)
        actor.GetProperty().SetDiffuse(0 if number == 1 else 1)
        renderer.AddActor(actor)
    for x, y, radius in ((-0.1, -1.1, 0.35), *((0.5 + 0.24 * i, -0.9 + 0.24 * j, 0.12) for i in range(3) for j in range(2))):
        ball = vtkSphereSource()
        ball.SetCenter(x, y, radius)
        ball.SetRadius(radius)
        ball.SetThetaResolution(64)
        ball.SetPhiResolution(48)
        renderer.AddActor(white(ball))
    renderer.AutomaticLightCreationOff()
    faint = vtkLight()
    faint.SetIntensity(1e-9)
    renderer.AddLight(faint)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.5, -3, 2.5)
    camera.SetFocalPoint(0, 0, 0.2)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCameraClippingRange()
    return renderer


class Film(data.Film):
    """The boxes in a window, with the denoiser if it has parameters."""

    def __init__(self, size, **parameters):
        super().__init__(lit_boxes(), size, ["denoising"] if parameters else [], **parameters)
        self.gi.KeepRadianceOn()

    def picture(self):
        """Radiance, bottom row first."""
        return penumbra.radiance(self.gi, self.renderer)[::-1, :, :3].astype(float)


def stored(light, error):
    """What the signal's texture holds: half floats, and the root of the error in 8 bits."""
    root = np.floor(np.sqrt(np.clip(error, 0, 1)) * 255 + 0.5)
    return reference.half(light), np.where(error > 0, np.maximum(root, 1) / 255, 0) ** 2


@unittest.skipIf(os.environ.get("PENUMBRA_BACKEND") == "osmesa" and not ctypes.util.find_library("OSMesa"),
                 "there is no OSMesa: Mesa after 25.0 has none")
class Shaders(unittest.TestCase):
    """The denoiser of a picture, against the reference."""

    def compare(self, frames, size=SIZE, **parameters):
        """Differences of filtered light, as shares of the light, in pixels that are lit."""
        raw, film = Film(size), Film(size, **{"denoising.method": "neural", **parameters})
        for each in (raw, film):
            each.gi.Restart()
            each.frame(frames)
        self.assertEqual(film.gi.GetLastError(), "")
        signal = film.signal(True)
        signal.light, signal.error = stored(signal.light, signal.error)
        expected = reference.denoise(signal, NETWORK, stored)
        before, after = raw.picture(), film.picture()
        reflects = np.abs(before.mean(-1) - REFLECTANCE * signal.light.mean(-1)) < 0.01 * before.mean(-1)
        lit = reflects & (signal.frames > 0) & (signal.light.min(-1) > 1e-3)
        self.assertGreater(lit.sum(), 1000)
        found = after[lit] / before[lit] * signal.light[lit]
        change = np.abs(expected - signal.light)[lit].mean()
        self.assertGreater(change, 0.01 * expected[lit].mean())
        differences = np.abs(found - expected[lit]).max(-1) / expected[lit].mean()
        print(f"{frames} frames of {size} {parameters}: differences {differences.mean():.1e} in the mean, {np.median(differences):.1e} "
              f"(median), {np.quantile(differences, 0.99):.1e} (99 %)")
        return differences

    def test_agree_with_the_reference(self):
        for frames, size in ((1, SIZE), (6, SIZE), (30, SIZE), (1, LARGE)):
            differences = self.compare(frames, size)
            self.assertLess(differences.mean(), 1e-3)
            self.assertLess(np.quantile(differences, 0.99), 4e-3)

    def test_direct_light_is_what_pictures_show(self):
        renderer = lit_boxes()
        renderer.RemoveAllLights()
        for place, color, positional in (((2, -1, 3), (0.9, 0.6, 0.3), False), ((-0.6, -0.8, 1.5), (0.2, 0.4, 0.8), True)):
            light = vtkLight()
            light.SetPosition(place)
            light.SetFocalPoint(0.2, 0, 0)
            light.SetDiffuseColor(color)
            light.SetIntensity(1.3)
            light.SetPositional(positional)
            light.SetConeAngle(180)
            renderer.AddLight(light)
        film = data.Film(renderer, SIZE)
        film.gi.KeepRadianceOn()
        film.frame()
        signal = film.signal(True)
        film.gi.GetTechnique("ray-traced-light").EnabledOff()
        film.frame()
        shown = penumbra.radiance(film.gi, renderer)[::-1, :, :3]
        direct = data.direct_light(renderer, signal)
        glows = np.abs(shown - REFLECTANCE).max(-1) < 1e-3
        matte = (signal.frames > 0) & (shown.min(-1) > 0) & ~glows
        self.assertGreater(matte.sum(), 2000)
        differences = np.abs(REFLECTANCE * direct - shown)[matte].max(-1)
        print(f"direct light: differences {np.median(differences):.1e} (median), {np.quantile(differences, 0.98):.1e} (98 %)")
        self.assertLess(np.quantile(differences, 0.98), 2e-3)

    def test_agree_with_weights_in_buffers(self):
        self.assertLess(np.mean(self.compare(6, **{"denoising.weights": "buffer"})), 1e-3)


if __name__ == "__main__":
    unittest.main()
