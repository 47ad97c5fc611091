# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python package: switching techniques, errors, and drawing."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import penumbra
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow


def ball():
    source, mapper, actor, renderer = vtkSphereSource(), vtkPolyDataMapper(), vtkActor(), vtkRenderer()
    source.SetPhiResolution(24)
    source.SetThetaResolution(24)
    mapper.SetInputConnection(source.GetOutputPort())
    actor.SetMapper(mapper)
    renderer.AddActor(actor)
    renderer.SetBackground(0.1, 0.2, 0.3)
    return renderer


class Switching(unittest.TestCase):
    def test_presets_and_techniques(self):
        self.assertEqual(penumbra.presets()[0], "off")
        names = [t.name for t in penumbra.techniques()]
        self.assertIn("shadow-maps", names)
        self.assertIn("ambient-occlusion", names)
        for technique in penumbra.techniques():
            for text in (technique.title, technique.term, technique.verb, technique.source):
                self.assertTrue(text)
            for parameter in technique.parameters:
                self.assertTrue(parameter.doc)
                if parameter.type == "enum":
                    self.assertIn(parameter.default, parameter.values)
                else:
                    self.assertLessEqual(parameter.minimum, parameter.default)
                    self.assertLessEqual(parameter.default, parameter.maximum)

    def test_enable_sets_techniques_and_parameters(self):
        renderer = vtkRenderer()
        gi = penumbra.enable(renderer, "fast", on="shadow-maps", off=["ambient-occlusion"],
                             shadow_maps__resolution=512, **{"anti-aliasing.mode": "fxaa"})
        self.assertIs(renderer.GetPass(), gi)
        self.assertEqual(gi.GetPreset(), "fast")
        self.assertTrue(gi.GetTechnique("shadow-maps").GetEnabled())
        self.assertFalse(gi.GetTechnique("ambient-occlusion").GetEnabled())
        self.assertEqual(gi.GetTechnique("shadow-maps").GetResolution(), 512)
        self.assertEqual(gi.GetTechnique("anti-aliasing").GetParameter("mode"), 2)

    def test_enable_sets_a_frame_budget(self):
        renderer = vtkRenderer()
        gi = penumbra.enable(renderer, budget=16.7)
        self.assertEqual(gi.GetFrameBudget(), 16.7)
        self.assertTrue(penumbra.enable(renderer, budget="auto").GetUseDesiredUpdateRate())
        self.assertEqual(gi.GetFrameBudget(), 0)
        penumbra.enable(renderer, budget=20)
        for bad in (-1, 0.5, 1e9, float("nan"), "soon", None):
            with self.assertRaisesRegex(ValueError, "a frame budget cannot be"):
                penumbra.enable(renderer, budget=bad)
            self.assertEqual(gi.GetFrameBudget(), 20)

    def test_second_enable_keeps_the_pass(self):
        renderer = vtkRenderer()
        self.assertIs(penumbra.enable(renderer), penumbra.enable(renderer, "high"))
        self.assertEqual(renderer.GetPass().GetPreset(), "high")
        penumbra.disable(renderer)
        self.assertIsNone(renderer.GetPass())

    def test_enable_of_a_window(self):
        window, first, second, overlay = vtkRenderWindow(), vtkRenderer(), vtkRenderer(), vtkRenderer()
        window.SetNumberOfLayers(2)
        overlay.SetLayer(1)
        for renderer in (first, second, overlay):
            window.AddRenderer(renderer)
        gi = penumbra.enable(window)
        self.assertIs(first.GetPass(), gi)
        self.assertIs(second.GetPass(), gi)
        self.assertIsNone(overlay.GetPass())

    def test_looks(self):
        names = [look.name for look in penumbra.looks()]
        self.assertEqual(names[0], "as-is")
        self.assertIn("studio", names)
        renderer = ball()
        light = vtkLight()
        renderer.AddLight(light)
        gi = penumbra.enable(renderer, "fast", look="studio", ambient_occlusion__samples=7)
        self.assertEqual(penumbra.vtkGILook.GetAppliedName(renderer), "studio")
        self.assertEqual((light.GetSwitch(), gi.GetTechnique("ambient-occlusion").GetSamples()), (0, 7))
        self.assertNotEqual(renderer.GetBackground(), (0.1, 0.2, 0.3))
        for undo in (penumbra.enable, penumbra.disable):
            penumbra.enable(renderer, look="soft")
            undo(renderer)
            self.assertEqual(penumbra.vtkGILook.GetAppliedName(renderer), "as-is")
            self.assertEqual((light.GetSwitch(), renderer.GetBackground()), (1, (0.1, 0.2, 0.3)))

    def test_a_mistake_in_a_look_changes_nothing(self):
        renderer = ball()
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "mine.json"
            path.write_text('{"lights": [{"elevation": 100}]}')
            for look, says in ((path, "'elevation' of light 1"), ("stduio", "there is no look 'stduio': there are as-is")):
                with self.assertRaisesRegex(ValueError, says):
                    penumbra.enable(renderer, look=look)
            self.assertIsNone(renderer.GetPass())
            path.write_text('{"background": [1, 0, 0]}')
            penumbra.enable(renderer, look=path)
            self.assertEqual(renderer.GetBackground(), (1, 0, 0))

    def test_saved_pictures_do_not_depend_on_earlier_frames(self):
        def lit(colour):
            renderer = ball()
            other = ball().GetActors().GetLastActor()
            other.SetPosition(0.9, 0.3, 0)
            other.GetProperty().SetColor(*colour)
            renderer.AddActor(other)
            penumbra.enable(renderer, "off", on="ddgi", ddgi__probes=216, ddgi__updates=4)
            return other, penumbra.window(renderer, size=(60, 40))

        def saved(window):
            with tempfile.TemporaryDirectory() as folder:
                penumbra.save_png(window, pathlib.Path(folder) / "ball.png")
                return (pathlib.Path(folder) / "ball.png").read_bytes()

        other, window = lit((1, 0, 0))
        penumbra.render(window, frames=4)
        other.GetProperty().SetColor(0, 1, 1)
        self.assertEqual(saved(window), saved(lit((0, 1, 1))[1]))

    def test_mistakes(self):
        renderer = vtkRenderer()
        for arguments, words in (
                (dict(preset="best"), ("best", "balanced")),
                (dict(on="radiosity"), ("radiosity", "shadow-maps")),
                ({"shadow-maps.size": 3}, ("size", "resolution")),
                ({"shadow-maps.resolution": 3}, ("3", "64")),
                ({"anti-aliasing.mode": "fast"}, ("fast", "fxaa")),
                ({"resolution": 512}, ("resolution", "technique.parameter"))):
            with self.subTest(arguments), self.assertRaises(ValueError) as caught:
                penumbra.enable(renderer, **arguments)
            for word in words:
                self.assertIn(word, str(caught.exception))
            self.assertIsNone(renderer.GetPass())
        with self.assertRaises(TypeError):
            penumbra.enable("renderer")
        with self.assertRaises(ValueError):
            penumbra.enable(vtkRenderWindow())


class Drawing(unittest.TestCase):
    def test_off_equals_stock(self):
        window = penumbra.window(ball(), size=(121, 90), multisamples=0)
        stock = penumbra.render(window)
        self.assertEqual(stock.shape, (90, 121, 3))
        self.assertGreater(np.ptp(stock), 50)
        penumbra.enable(window, "off")
        off = penumbra.render(window)
        self.assertLessEqual(np.abs(stock.astype(int) - off).max(), 2)
        penumbra.disable(window)
        self.assertTrue((penumbra.render(window) == stock).all())

    def test_top_row_first_and_alpha(self):
        renderer = ball()
        renderer.GradientBackgroundOn()
        renderer.SetBackground(0, 0, 0)
        renderer.SetBackground2(1, 1, 1)
        picture = penumbra.render(penumbra.window(renderer, size=(60, 60)), alpha=True)
        self.assertEqual(picture.shape[2], 4)
        self.assertGreater(int(picture[0, 0, 0]), int(picture[-1, 0, 0]))

    def test_statistics_and_radiance(self):
        renderer = ball()
        window = penumbra.window(renderer, size=(64, 48))
        gi = penumbra.enable(renderer)
        gi.CollectStatisticsOn()
        gi.KeepRadianceOn()
        penumbra.render(window)
        penumbra.render(window)
        self.assertIn("passes", penumbra.statistics(gi))
        light = penumbra.radiance(gi, renderer)
        self.assertEqual(light.shape, (48, 64, 4))
        self.assertTrue(np.isfinite(light).all())
        gi.KeepRadianceOff()
        with self.assertRaises(RuntimeError):
            penumbra.radiance(penumbra.vtkGIPass(), renderer)

    def test_frame_chart(self):
        renderer = ball()
        window = penumbra.window(renderer, size=(64, 48))
        gi = penumbra.enable(renderer, budget=50)
        gi.CollectStatisticsOn()
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "frame.svg"
            for _ in range(3):
                renderer.GetActiveCamera().Azimuth(1)
                window.Render()
            penumbra.frame_chart(gi, path, title="a ball")
            text = path.read_text()
            self.assertIn("ambient-occlusion samples=8", text)
            self.assertIn("budget 50", text)
            with self.assertRaisesRegex(ValueError, "ends with .svg"):
                penumbra.frame_chart(gi, "frame.gif")
            with self.assertRaisesRegex(ValueError, "cannot be written"):
                penumbra.frame_chart(gi, pathlib.Path(folder) / "none" / "frame.svg")

    def test_relative_error(self):
        truth = np.array([1.0, 3.0])  # the mean is 2, so epsilon is 0.04
        error, mean = penumbra.relative_error([2.0, 3.0], truth)
        self.assertAlmostEqual(error, 0.5 / 1.04)
        self.assertAlmostEqual(mean, 0.25)
        self.assertEqual(penumbra.relative_error(truth, truth), (0.0, 0.0))
        error, mean = penumbra.relative_error([2.0, 6.0], truth, where=np.array([False, True]))
        self.assertAlmostEqual(error, 9.0 / 9.04)
        self.assertAlmostEqual(mean, 1.0)
        with self.assertRaises(ValueError):
            penumbra.relative_error([2.0, 3.0], truth, where=np.array([False, False]))
        with self.assertRaises(ValueError):
            penumbra.relative_error([1.0], truth)
        with self.assertRaises(ValueError):
            penumbra.relative_error(truth, [0.0, 0.0])

    def test_save_png(self):
        window = penumbra.window(ball(), size=(40, 30))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "ball.png"
            penumbra.save_png(window, path)
            self.assertEqual(path.read_bytes()[1:4], b"PNG")
            with self.assertRaisesRegex(OSError, "cannot write"):
                penumbra.save_png(window, path / "below.png")

    def test_mistakes(self):
        with self.assertRaisesRegex(ValueError, "no window"):
            penumbra.render(vtkRenderer())
        with self.assertRaises(TypeError):
            penumbra.render(3)
        with self.assertRaisesRegex(ValueError, "frames"):
            penumbra.render(penumbra.window(ball()), frames=0)

    def test_no_opengl_is_an_exception(self):
        code = ("import penumbra; from vtkmodules.vtkRenderingCore import vtkRenderer;"
                "penumbra.render(penumbra.window(vtkRenderer()))")
        run = subprocess.run(
            [sys.executable, "-c", code], capture_output=True, text=True, check=False,
            env={**__import__("os").environ, "PENUMBRA_BACKEND": "egl", "PENUMBRA_EGL_DEVICE": "99"})
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertIn("RuntimeError", run.stderr)


if __name__ == "__main__":
    unittest.main()
