#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""The bias laboratory: its measures of masks made by hand, its numbers where they are known, its files, its sentences."""
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
import shadow_bias as scenes  # noqa: E402 the example's

WIDTH, HEIGHT = 80, 40
PIXEL, TEXELS = 0.25, 0.5  # a pixel's width in world units and in texels
WALL, SHADOW_END = 20, 50  # the column of what stands on the floor and is turned away; the first lit one behind it
THICKNESS = 0.02  # of the board
# Maps as they are without what keeps depths of the receiver's own surface apart: the laboratory is to find acne there.
NAIVE = {"shadow-maps.receiver-plane": "off", "shadow-maps.filter-radius": 0}


def floor():
    """Seen from straight above: lit, then a wall of one column, then its shadow, then lit again."""
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
    def test_the_truth_has_no_error(self):
        judge = Judge(floor(), floor().truth)
        found = judge.measure(floor().truth)
        self.assertEqual((found["acne"], found["leak"], found["gap"], judge.lost), (0, 0, 0, 0))
        self.assertEqual((judge.contact_points, judge.outline_points), (HEIGHT, HEIGHT))

    def test_acne_is_the_share_of_the_light(self):
        mask = floor().truth
        y, x = np.mgrid[:HEIGHT, :WIDTH]
        mask[(x + y) % 2 == 0] *= 0.75  # a quarter of the light, from every second of the lit pixels
        found = errors(floor(), mask)
        self.assertAlmostEqual(found["acne"], 0.125, 9)
        self.assertEqual(found["leak"], 0)

    def test_where_it_is_dimmer_errors_weigh_less(self):
        view = floor()
        view.light[:, :WALL] = 0.25
        # The columns in front of the wall but the last three, and those behind the shadow but the first four.
        before, behind = 0.25 * (WALL - 3), WIDTH - SHADOW_END - 4
        self.assertAlmostEqual(errors(view, filled(view.truth, 0, WALL, 0))["acne"], before / (before + behind), 9)
        # Contact leaks at one of ten points, which are as good as dark: less than a twentieth of the light.
        mask = view.truth.copy()
        mask[::10, WALL + 1] = 1
        view.light[:, WALL + 1] = 1
        view.light[::10, WALL + 1] = 0.1
        self.assertEqual(errors(view, mask)["contact-gap"]["world"], 0)
        view.light[:] = 1
        # A pixel by itself is dark on both sides: nearest begins the shadow there.
        self.assertAlmostEqual(errors(view, mask)["contact-gap"]["world"], math.hypot(0.5, 0.5) * PIXEL, 9)

    def test_edges_are_no_acne(self):
        view = floor()
        # Three pixels are one texel and a half: within the band.
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

    def test_stray_pixels_are_no_gap(self):
        mask = floor().truth
        mask[7, WALL + 1] = 1  # one of forty points of contact
        self.assertEqual(errors(floor(), mask)["contact-gap"]["world"], 0)

    def test_a_shadow_that_is_gone_is_as_wide_as_it_was(self):
        found = errors(floor(), np.ones((HEIGHT, WIDTH)))
        # No dark pixel is left to measure to: the patch's diagonal, from pixel centre to pixel centre.
        self.assertAlmostEqual(found["contact-gap"]["world"], math.hypot(SHADOW_END - WALL - 2, HEIGHT - 1) * PIXEL, 9)
        self.assertEqual(found["leak"], 1)

    def test_what_the_map_cannot_show_counts_for_nothing(self):
        view, unbiased = floor(), floor().truth
        view.truth[10:12, 70] = 0  # a speck that the map misses at any bias
        judge = Judge(view, unbiased)
        self.assertEqual(judge.outline_points, HEIGHT)
        self.assertAlmostEqual(judge.lost, 2 / ((SHADOW_END - WALL - 1) * HEIGHT + 2), 9)
        found = judge.measure(unbiased)
        self.assertEqual((found["gap"], found["leak"]), (0, 0))

    def test_what_hangs_in_the_air_touches_nothing(self):
        view = floor()
        view.place[:, WALL, 2] = 5  # seen before the floor, high above it
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

    def test_the_choice_is_as_far_from_acne_as_from_gaps(self):
        # The best sample, the first, is next to acne.
        sweep = samples((0.4, 0), (0, 0.1), (0, 0.4), (0, 0.7), (0, 1.2))
        self.assertEqual((safe_window(sweep)["choice"], best(sweep)["bias"]), (1.0, 1.0))
        # Without acne at the smallest bias there is nothing to keep away from.
        self.assertEqual(safe_window(samples((0, 0), (0, 0.4), (0, 0.7), (0, 1.2)))["choice"], 0)

    def test_the_limits_are_within(self):
        window = safe_window(samples((0.001, 1), (0.0011, 1), (0.001, 1.01)))
        self.assertEqual((window["low"], window["high"]), (0, 0))

    def test_the_widest_of_two(self):
        self.assertEqual(safe_window(samples((0, 0.3), (0, 2), (0, 0.5), (0, 0.4), (0, 0.9))),
                         {"low": 1, "high": 2, "reaches-end": True, "choice": 1.5})

    def test_none_still_has_a_nearest(self):
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

    def test_resolution_whose_texels_are_seen(self):
        for width, resolution in ((0.5, 2048), (0.51, 1024), (4, 256), (1e9, 64)):  # at 0.5 a texel is two pixels already
            self.assertEqual(coarse_enough(width, 2048), resolution)

    def test_kinds_come_from_the_declared_parameters(self):
        gi = penumbra.vtkGIPass()
        self.assertEqual(bias_kinds(gi.GetTechnique("shadow-maps")), ["constant", "slope", "normal"])
        self.assertEqual(bias_kinds(gi.GetTechnique("anti-aliasing")), [])


def board(*more):
    """On a floor; the light comes from straight behind it, at 45 degrees."""
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
        """Along a ray the board's far side is x / cos 45 + thickness / cos 45 before the floor at x: light leaks in up to
        where that is the bias."""
        numbers, _ = studied(board(), 4, 12, kinds=["constant"], **self.FINE)
        texel = numbers["texel-world"]
        self.assertGreater(numbers["edge-points"]["contact"], 50)
        for sample in numbers["sweeps"][0]["samples"]:
            expected = sample["bias"] * texel * math.cos(math.radians(45)) - THICKNESS
            # The map knows the board's depth to half a texel, and the picture the edge to half a pixel.
            off = texel * (0.5 + 0.5 * numbers["pixel-texels"]) * math.sqrt(2)
            self.assertAlmostEqual(sample["contact-gap"]["world"], expected, delta=off, msg=sample)
            self.assertAlmostEqual(sample["contact-gap"]["texels"],
                                   expected * math.sin(math.radians(45)) / texel, delta=1, msg=sample)

    def test_outline_of_a_board(self):
        """A bias along the normal lifts the floor by its sine; across the light, by its sine again."""
        numbers, _ = studied(board(), 3, 9, kinds=["normal"], **self.FINE)
        for sample in numbers["sweeps"][0]["samples"]:
            expected = sample["bias"] * math.sin(math.radians(45)) ** 2
            self.assertAlmostEqual(sample["outline-gap"]["texels"], expected, delta=1, msg=sample)
            self.assertLess(sample["contact-gap"]["texels"], 1, sample)

    def test_the_receivers_plane(self):
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
        alone, _ = studied(board(), **quick)
        renderer = board()
        scenes.headlight(renderer, 0.5)
        weak = vtkLight()
        weak.SetPosition(1, 0, 0.1)
        weak.SetIntensity(0.2)
        renderer.AddLight(weak)
        lit, bench = studied(renderer, **quick)
        self.assertEqual(bench.other_lights, 1)
        for a, b in zip(alone["sweeps"][0]["samples"], lit["sweeps"][0]["samples"]):
            self.assertAlmostEqual(a["acne"], b["acne"], delta=1e-4)
            self.assertAlmostEqual(a["gap"], b["gap"], delta=0.01)

    def test_what_is_translucent_is_left_out(self):
        glass = scenes.box((0, -1, 0.5), (1, 0.1, 0.5), (1, 1, 1))
        glass.GetProperty().SetOpacity(0.5)
        with_glass, bench = studied(board(glass), kinds=["constant"])
        self.assertEqual(bench.left_out, 1)
        self.assertEqual(with_glass["edge-points"], studied(board(), kinds=["constant"])[0]["edge-points"])

    def test_materials_cancel_out(self):
        plain, _ = studied(board(), kinds=["constant"])
        renderer = board()
        look = renderer.GetActors().GetItemAsObject(0).GetProperty()
        look.SetInterpolationToPBR()
        look.SetColor(0.2, 0.5, 0.1)
        look.SetEmissiveFactor(0.3, 0.2, 0.1)
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
        status, printed, said = self.run_command(self.SCENE, "-o", out, "--bias", "slope", "--steps", 3, "--size", "240x160",
                                                 "--stats")
        self.assertEqual(status, 0, said)
        self.assertEqual(json.loads((out / "numbers.json").read_text()), json.loads(printed))
        for name in ("sheet.png", "strip-slope.png", "plot.png"):
            with Image.open(out / name) as picture:
                self.assertGreater(len(set(picture.convert("RGB").getdata())), 20, name)
        self.assertFalse((out / "strip-constant.png").exists())
        drawing = xml.etree.ElementTree.parse(out / "plot.svg").getroot()
        self.assertGreater(len(list(drawing.iter())), 50)

    def test_summary_and_notes(self):
        status, printed, said = self.run_command(self.SCENE, "-o", self.folder / "words", "--bias", "constant", "--steps", 2,
                                                 "--size", "120x80", "--resolution", 4096)
        self.assertEqual(status, 0, said)
        self.assertIn("note: a pixel is ", said)
        lines = printed.splitlines()
        self.assertTrue(lines[0].startswith("constant bias: "), lines)
        self.assertTrue(lines[-1].startswith("as set (constant "), lines)

    def test_bad_options(self):
        for options, says in (
                (("--bias", "sideways"), "invalid choice: 'sideways'"),
                (("--from", "3", "--to", "1"), "from 3 to 1"),
                (("--from", "-1"), "from -1 to 4"),
                (("--to", "nan"), "--from must be less than --to"),
                (("--steps", "1"), "--steps is 1"),
                (("--resolution", "3"), "--resolution is 3"),
                (("--size", "0x4"), "--size must be"),
                (("--stpes", "3"), "--stpes")):
            status, _, said = self.run_command(self.SCENE, "-o", self.folder / "bad", *options)
            self.assertEqual(status, 2, options)
            self.assertIn(says, said)

    def test_nothing_to_study(self):
        (self.folder / "dark.py").write_text("import scenes\ndef scene():\n  return scenes.stage((1, 1, 1), (1, 1, 1))\n")
        (self.folder / "file").write_text("")
        for scene, out, says in (
                (self.folder / "none.py", "o", "there is no file"), (self.folder / "file", "o", "is no Python file"),
                (f"{self.SCENE}:stool", "o", "has no function 'stool'"), (self.folder / "dark.py", "o", "no light"),
                (self.SCENE, "file", "cannot be made")):
            status, _, said = self.run_command(scene, "-o", self.folder / out, "--steps", 2)
            self.assertEqual(status, 1, said)
            self.assertIn(says, said)
            self.assertEqual(len(said.splitlines()), 1, said)
        status, _, said = self.run_command(self.SCENE, "-o", self.folder / "o", "--set", "shadow-maps.wrong=1")
        self.assertEqual(status, 1)
        self.assertIn("'wrong'", said)


if __name__ == "__main__":
    unittest.main()
