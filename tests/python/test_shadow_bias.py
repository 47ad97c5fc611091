#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""The bias laboratory: its measures of constructed masks, its results in scenes with known values, its files and messages."""
import contextlib
import io
import json
import math
import pathlib
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import numpy as np
import penumbra
from penumbra.shadow_bias import Bench, Judge, View, __main__, best, bias_kinds, coarse_enough, pixel_width, safe_window
from penumbra.shadow_bias.study import percent, share_of_limits, study, window_in_words
from PIL import Image
from vtkmodules.vtkRenderingCore import vtkLight

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "examples"))
import shadow_bias as scenes  # noqa: E402 the example's scene

WIDTH, HEIGHT = 80, 40
PIXEL, TEXELS = 0.25, 0.5  # width of a pixel in world units and in texels
WALL, SHADOW_END = 20, 50  # column of a wall that faces away from the light; first lit column behind its shadow
THICKNESS = 0.02  # thickness of the board
# Maps without the receiver's plane and without a filter, in which the laboratory must find acne.
NAIVE = {"shadow-maps.receiver-plane": "off", "shadow-maps.filter-radius": 0}


def floor():
    """A floor from above: from left to right lit floor, a wall of one column, its shadow, and lit floor."""
    y, x = np.mgrid[:HEIGHT, :WIDTH]
    place = np.stack([x * PIXEL, y * PIXEL, 0.0 * x], axis=2)
    truth = np.where((x >= WALL) & (x < SHADOW_END), 0.0, 1.0)
    return View(np.ones(x.shape, bool), x != WALL, np.ones(x.shape), truth, place, place / PIXEL * TEXELS)


def filled(mask, left, right, value):
    mask = mask.copy()
    mask[:, left:right] = value
    return mask


def errors(view, mask, band=1.5):
    return Judge(view, view.truth, band).measure(mask)


class Measures(unittest.TestCase):
    def test_the_reference_has_no_error(self):
        judge = Judge(floor(), floor().truth)
        found = judge.measure(floor().truth)
        self.assertEqual((found["acne"], found["leak"], found["gap"], judge.lost), (0, 0, 0, 0))
        self.assertEqual((judge.contact_points, judge.outline_points), (HEIGHT, HEIGHT))

    def test_acne_is_the_missing_share_of_light(self):
        mask = floor().truth
        y, x = np.mgrid[:HEIGHT, :WIDTH]
        mask[(x + y) % 2 == 0] *= 0.75  # removes a quarter of the light in every second lit pixel
        found = errors(floor(), mask)
        self.assertAlmostEqual(found["acne"], 0.125, 9)
        self.assertEqual(found["leak"], 0)

    def test_errors_are_weighted_by_light(self):
        view = floor()
        view.light[:, :WALL] = 0.25
        # All columns in front of the wall except the last three, and behind the shadow except the first four.
        before, behind = 0.25 * (WALL - 3), WIDTH - SHADOW_END - 4
        self.assertAlmostEqual(errors(view, filled(view.truth, 0, WALL, 0))["acne"], before / (before + behind), 9)
        # Contact leaks at one of ten points, but these points hold less than a twentieth of the light.
        mask = view.truth.copy()
        mask[::10, WALL + 1] = 1
        view.light[:, WALL + 1] = 1
        view.light[::10, WALL + 1] = 0.1
        self.assertEqual(errors(view, mask)["contact-gap"]["world"], 0)
        view.light[:] = 1
        # A single pixel has dark neighbours on both sides, and the nearest counts as the start of the shadow.
        self.assertAlmostEqual(errors(view, mask)["contact-gap"]["world"], math.hypot(0.5, 0.5) * PIXEL, 9)

    def test_edges_do_not_count_as_acne(self):
        view = floor()
        # Three pixels are one and a half texels, which is within the band.
        self.assertEqual(errors(view, filled(view.truth, SHADOW_END, SHADOW_END + 3, 0))["acne"], 0)
        wide = filled(view.truth, SHADOW_END, SHADOW_END + 6, 0)
        self.assertGreater(errors(view, wide)["acne"], 0)
        self.assertEqual(errors(view, wide, 3.5)["acne"], 0)

    def test_gap_at_contact(self):
        for pixels in (1, 4, 9):
            found = errors(floor(), filled(floor().truth, WALL + 1, WALL + 1 + pixels, 1))
            self.assertAlmostEqual(found["contact-gap"]["world"], pixels * PIXEL, 9)
            self.assertAlmostEqual(found["contact-gap"]["texels"], pixels * TEXELS, 9)
            self.assertEqual((found["outline-gap"]["world"], found["acne"]), (0, 0))

    def test_gap_at_the_outline(self):
        found = errors(floor(), filled(floor().truth, SHADOW_END - 6, SHADOW_END, 1))
        self.assertEqual(found["contact-gap"]["world"], 0)
        self.assertAlmostEqual(found["outline-gap"]["world"], 6 * PIXEL, 9)
        self.assertAlmostEqual(found["gap"], 6 * TEXELS, 9)
        self.assertGreater(found["leak"], 0)

    def test_stray_pixels_do_not_count_as_a_gap(self):
        mask = floor().truth
        mask[7, WALL + 1] = 1  # one of forty contact points
        self.assertEqual(errors(floor(), mask)["contact-gap"]["world"], 0)

    def test_a_missing_shadow_is_a_gap_of_its_width(self):
        found = errors(floor(), np.ones((HEIGHT, WIDTH)))
        # Without dark pixels, the gap is the diagonal of the shadow, between pixel centres.
        self.assertAlmostEqual(found["contact-gap"]["world"], math.hypot(SHADOW_END - WALL - 2, HEIGHT - 1) * PIXEL, 9)
        self.assertEqual(found["leak"], 1)

    def test_details_finer_than_the_map_do_not_count(self):
        view, unbiased = floor(), floor().truth
        view.truth[10:12, 70] = 0  # a speck that the map misses with any bias
        judge = Judge(view, unbiased)
        self.assertEqual(judge.outline_points, HEIGHT)
        self.assertAlmostEqual(judge.lost, 2 / ((SHADOW_END - WALL - 1) * HEIGHT + 2), 9)
        found = judge.measure(unbiased)
        self.assertEqual((found["gap"], found["leak"]), (0, 0))

    def test_objects_above_the_floor_have_no_contact(self):
        view = floor()
        view.place[:, WALL, 2] = 5  # high above the floor
        judge = Judge(view, view.truth)
        self.assertEqual((judge.contact_points, judge.outline_points), (0, HEIGHT))

    def test_without_any_shadow(self):
        view = floor()
        view.truth[:] = 1
        judge = Judge(view, view.truth)
        self.assertEqual((judge.contact_points, judge.outline_points, judge.dark_pixels), (0, 0, 0))
        self.assertEqual(judge.lit_pixels, (WIDTH - 1) * HEIGHT)
        found = judge.measure(np.zeros((HEIGHT, WIDTH)))
        self.assertEqual((found["acne"], found["gap"]), (1, 0))

    def test_width_of_pixels(self):
        self.assertAlmostEqual(pixel_width(floor()), TEXELS, 12)
        nothing = floor()
        nothing.receiver[:] = False
        self.assertEqual(pixel_width(nothing), 0)


def samples(*acne_and_gap):
    return [{"bias": 0.5 * i, "acne": acne, "gap": gap} for i, (acne, gap) in enumerate(acne_and_gap)]


class Windows(unittest.TestCase):
    def test_between_acne_and_gap(self):
        self.assertEqual(safe_window(samples((0.4, 0), (0.0009, 0.2), (0.0002, 0.5), (0, 0.8), (0, 1.1))),
                         {"low": 0.5, "high": 1.5, "reaches-end": False, "choice": 1.0})

    def test_the_choice_is_between_acne_and_gaps(self):
        # The best safe sample, the first one, is too close to acne.
        sweep = samples((0.4, 0), (0, 0.1), (0, 0.4), (0, 0.7), (0, 1.2))
        self.assertEqual((safe_window(sweep)["choice"], best(sweep)["bias"]), (1.0, 1.0))
        # Without acne at the smallest bias, the smallest bias is the choice.
        self.assertEqual(safe_window(samples((0, 0), (0, 0.4), (0, 0.7), (0, 1.2)))["choice"], 0)

    def test_the_limits_are_inclusive(self):
        window = safe_window(samples((0.001, 1), (0.0011, 1), (0.001, 1.01)))
        self.assertEqual((window["low"], window["high"]), (0, 0))

    def test_the_wider_of_two_windows(self):
        self.assertEqual(safe_window(samples((0, 0.3), (0, 2), (0, 0.5), (0, 0.4), (0, 0.9))),
                         {"low": 1, "high": 2, "reaches-end": True, "choice": 1.5})

    def test_without_a_window_the_best_sample_remains(self):
        sweep = samples((0.5, 0), (0.003, 1.5), (0.0015, 6))
        self.assertIsNone(safe_window(sweep))
        self.assertEqual(best(sweep)["bias"], 0.5)
        self.assertEqual(share_of_limits({"acne": 0.002, "gap": 1.5}), 2)

    def test_in_words(self):
        for sweep, words in (
                (samples((1, 0), (0, 0.2), (0, 0.5), (0, 0.8), (0, 2)), "safe from 0.5 to 1.5 texels; take 1"),
                (samples((1, 0), (0, 0.2), (0, 0.5)), "safe from 0.5 to 1 texels at least; take 0.5"),
                (samples((1, 0), (0, 0.2), (0, 2)), "safe at 0.5 texels only; take that"),
                (samples((1, 0), (0.01, 2)), "none safe from 0 to 0.5 texels; nearest 0.5")):
            described = {"samples": sweep, "window": safe_window(sweep), "best": best(sweep)["bias"]}
            self.assertEqual(window_in_words(described), words)
        for share, words in ((0, "0 %"), (1e-7, "under 0.001 %"), (0.00123, "0.12 %"), (0.1234, "12 %"), (1, "100 %")):
            self.assertEqual(percent(share), words)

    def test_resolution_with_visible_texels(self):
        for width, resolution in ((0.5, 2048), (0.51, 1024), (4, 256), (1e9, 64)):  # at 0.5 a texel already covers two pixels
            self.assertEqual(coarse_enough(width, 2048), resolution)

    def test_kinds_come_from_the_declared_parameters(self):
        gi = penumbra.vtkGIPass()
        self.assertEqual(bias_kinds(gi.GetTechnique("shadow-maps")), ["constant", "slope", "normal"])
        self.assertEqual(bias_kinds(gi.GetTechnique("anti-aliasing")), [])


def board(*more):
    """A board on a floor, with light at 45 degrees from behind it."""
    return scenes.view([scenes.plane(4, (0.8, 0.8, 0.8)), scenes.box((0, 0, 0.5), (1.6, THICKNESS, 1), (0.8, 0.8, 0.8)),
                        *more], toward=(0, 1, 1), position=(0.4, -2.6, 2.2), focal=(0, -0.35, 0.1))


def studied(renderer, low=0, high=4, steps=3, kinds=None, size=(240, 160), resolution=None, **parameters):
    window = penumbra.window(renderer, size=size, multisamples=0)
    window.Render()
    bench = Bench(window, renderer, **parameters)
    numbers, _ = study(bench, list(np.linspace(low, high, steps)), kinds, resolution)
    return numbers, bench


class Laboratory(unittest.TestCase):
    FINE = {"size": (360, 240), "resolution": 256, "shadow-maps.filter-radius": 0}

    def test_gap_of_a_board(self):
        """Along a ray, the floor at x lies x / cos 45 + thickness / cos 45 behind the board's far side. Light leaks up to the
        x where this equals the bias."""
        numbers, _ = studied(board(), 4, 12, kinds=["constant"], **self.FINE)
        texel = numbers["texel-world"]
        self.assertGreater(numbers["edge-points"]["contact"], 50)
        for sample in numbers["sweeps"][0]["samples"]:
            expected = sample["bias"] * texel * math.cos(math.radians(45)) - THICKNESS
            # The map's depth of the board is accurate to half a texel, and the picture's edge to half a pixel.
            off = texel * (0.5 + 0.5 * numbers["pixel-texels"]) * math.sqrt(2)
            self.assertAlmostEqual(sample["contact-gap"]["world"], expected, delta=off, msg=sample)
            self.assertAlmostEqual(sample["contact-gap"]["texels"],
                                   expected * math.sin(math.radians(45)) / texel, delta=1, msg=sample)

    def test_outline_of_a_board(self):
        """A normal bias lifts the floor by its product with the sine, and perpendicular to the light by the sine squared."""
        numbers, _ = studied(board(), 3, 9, kinds=["normal"], **self.FINE)
        for sample in numbers["sweeps"][0]["samples"]:
            expected = sample["bias"] * math.sin(math.radians(45)) ** 2
            self.assertAlmostEqual(sample["outline-gap"]["texels"], expected, delta=1, msg=sample)
            self.assertLess(sample["contact-gap"]["texels"], 1, sample)

    def test_receiver_plane(self):
        with_plane, _ = studied(board(), 0.5, 1, 2, ["slope"])
        without, _ = studied(board(), 0.5, 1, 2, ["slope"], **{"shadow-maps.receiver-plane": "off"})
        for a, b in zip(with_plane["sweeps"][0]["samples"], without["sweeps"][0]["samples"]):
            self.assertLess(a["acne"], 0.001)
            self.assertGreater(b["acne"], 0.01)
        self.assertLessEqual(with_plane["defaults"]["acne"], 0.001)

    def test_window(self):
        numbers, _ = studied(board(), steps=9, **NAIVE)
        self.assertEqual([sweep["kind"] for sweep in numbers["sweeps"]], ["constant", "slope", "normal"])
        self.assertLess(numbers["pixel-texels"], 0.6)
        for sweep in numbers["sweeps"]:
            window, found = sweep["window"], sweep["samples"]
            self.assertIsNotNone(window, sweep["kind"])
            self.assertGreater(found[0]["acne"], 0.05)
            self.assertEqual(found[0]["gap"], 0)
            self.assertGreater(found[-1]["gap"], 1)
            self.assertGreater(window["low"], 0)
            self.assertLess(window["high"], 4)
            self.assertTrue(window["low"] <= window["choice"] <= window["high"])

    def test_lights_of_every_type(self):
        for kind in ("point", "cone", "camera"):
            renderer = board()
            light = renderer.GetLights().GetItemAsObject(0)
            if kind == "camera":
                light.SetLightTypeToCameraLight()
                light.SetPosition(1.5, 1, 0.5)
            else:
                light.PositionalOn()
                light.SetPosition(0, 2, 2)
                light.SetConeAngle(180 if kind == "point" else 40)
            numbers, _ = studied(renderer, 0, 2, 2, **NAIVE)
            first, last = numbers["sweeps"][0]["samples"]
            self.assertGreater(first["acne"], 0.05, kind)
            self.assertLess(last["acne"], first["acne"] / 4, kind)
            self.assertTrue(0 < numbers["texel-world"] < 0.3, numbers["texel-world"])
            self.assertGreater(numbers["pixels"]["dark"], 0, kind)

    def test_the_strongest_of_several_lights(self):
        quick = {"kinds": ["constant"]}
        single, _ = studied(board(), **quick)
        renderer = board()
        scenes.headlight(renderer, 0.5)
        weak = vtkLight()
        weak.SetPosition(1, 0, 0.1)
        weak.SetIntensity(0.2)
        renderer.AddLight(weak)
        lit, bench = studied(renderer, **quick)
        self.assertEqual(bench.other_lights, 1)
        for a, b in zip(single["sweeps"][0]["samples"], lit["sweeps"][0]["samples"]):
            self.assertAlmostEqual(a["acne"], b["acne"], delta=1e-4)
            self.assertAlmostEqual(a["gap"], b["gap"], delta=0.01)

    def test_translucent_props_are_left_out(self):
        glass = scenes.box((0, -1, 0.5), (1, 0.1, 0.5), (1, 1, 1))
        glass.GetProperty().SetOpacity(0.5)
        with_glass, bench = studied(board(glass), kinds=["constant"])
        self.assertEqual(bench.left_out, 1)
        self.assertEqual(with_glass["edge-points"], studied(board(), kinds=["constant"])[0]["edge-points"])

    def test_materials_cancel_out(self):
        plain, _ = studied(board(), kinds=["constant"])
        renderer = board()
        material = renderer.GetActors().GetItemAsObject(0).GetProperty()
        material.SetInterpolationToPBR()
        material.SetColor(0.2, 0.5, 0.1)
        material.SetEmissiveFactor(0.3, 0.2, 0.1)
        other, _ = studied(renderer, kinds=["constant"])
        for a, b in zip(plain["sweeps"][0]["samples"], other["sweeps"][0]["samples"]):
            self.assertAlmostEqual(a["acne"], b["acne"], delta=0.01)
            self.assertAlmostEqual(a["gap"], b["gap"], delta=0.1)


class Command(unittest.TestCase):
    SCENE = str(pathlib.Path(scenes.__file__))

    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name)

    def run_command(self, *arguments):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            try:
                __main__.main([str(argument) for argument in arguments])
                status = 0
            except SystemExit as end:
                status = end.code
        return status, out.getvalue(), err.getvalue()

    def test_files(self):
        out = self.folder / "out"
        status, printed, errors = self.run_command(self.SCENE, "-o", out, "--bias", "slope", "--steps", 3, "--size", "240x160",
                                                 "--stats")
        self.assertEqual(status, 0, errors)
        self.assertEqual(json.loads((out / "numbers.json").read_text()), json.loads(printed))
        for name in ("sheet.png", "strip-slope.png", "plot.png"):
            with Image.open(out / name) as picture:
                self.assertGreater(len(set(picture.convert("RGB").getdata())), 20, name)
        self.assertFalse((out / "strip-constant.png").exists())
        drawing = xml.etree.ElementTree.parse(out / "plot.svg").getroot()
        self.assertGreater(len(list(drawing.iter())), 50)

    def test_summary_and_notes(self):
        status, printed, errors = self.run_command(self.SCENE, "-o", self.folder / "words", "--bias", "constant", "--steps", 2,
                                                 "--size", "120x80", "--resolution", 4096)
        self.assertEqual(status, 0, errors)
        self.assertIn("note: a pixel is ", errors)
        lines = printed.splitlines()
        self.assertTrue(lines[0].startswith("constant bias: "), lines)
        self.assertTrue(lines[-1].startswith("as set (constant "), lines)

    def test_bad_options(self):
        for options, message in (
                (("--bias", "sideways"), "invalid choice: 'sideways'"),
                (("--from", "3", "--to", "1"), "from 3 to 1"),
                (("--from", "-1"), "from -1 to 4"),
                (("--to", "nan"), "--from must be less than --to"),
                (("--steps", "1"), "--steps is 1"),
                (("--resolution", "3"), "--resolution is 3"),
                (("--size", "0x4"), "--size must be"),
                (("--stpes", "3"), "--stpes")):
            status, _, errors = self.run_command(self.SCENE, "-o", self.folder / "bad", *options)
            self.assertEqual(status, 2, options)
            self.assertIn(message, errors)

    def test_nothing_to_study(self):
        (self.folder / "dark.py").write_text("import scenes\ndef scene():\n  return scenes.stage((1, 1, 1), (1, 1, 1))\n")
        (self.folder / "file").write_text("")
        for scene, out, message in (
                (self.folder / "none.py", "o", "there is no file"), (self.folder / "file", "o", "is no Python file"),
                (f"{self.SCENE}:stool", "o", "has no function 'stool'"), (self.folder / "dark.py", "o", "no light"),
                (self.SCENE, "file", "cannot be made")):
            status, _, errors = self.run_command(scene, "-o", self.folder / out, "--steps", 2)
            self.assertEqual(status, 1, errors)
            self.assertIn(message, errors)
            self.assertEqual(len(errors.splitlines()), 1, errors)
        status, _, errors = self.run_command(self.SCENE, "-o", self.folder / "o", "--set", "shadow-maps.wrong=1")
        self.assertEqual(status, 1)
        self.assertIn("'wrong'", errors)


if __name__ == "__main__":
    unittest.main()
