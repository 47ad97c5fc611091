# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""penumbra lab shadow-bias: its numbers where they are known, its files, its sentences."""
import json
import math
import unittest
import xml.etree.ElementTree

from PIL import Image

import command

THICKNESS = 0.02
SMALL = ("--size", "240x160")
# A board on a floor; the light comes from straight behind it, at 45 degrees.
BOARD = {
    "size": [240, 160],
    "objects": [
        {"plane": {"size": [4, 4]}},
        {"box": {"center": [0, 0, 0.5], "size": [1.6, THICKNESS, 1]}}],
    "lights": [{"type": "directional", "position": [0, 1, 1]}],
    "camera": {"position": [0.4, -2.6, 2.2], "focal": [0, -0.35, 0.1], "up": [0, 0, 1]}}

# Maps as they are without what keeps depths of the receiver's own surface apart: the laboratory is to find acne there.
NAIVE = ("--set", "shadow-maps.receiver-plane=off", "--set", "shadow-maps.filter-radius=0")


class Laboratory(command.CommandTest):
    def study(self, scene, *arguments, notes=()):
        ended = self.succeeds("lab", "shadow-bias", self.scene(scene), "-o", "out", "--stats", *arguments,
                              notes=notes)
        return json.loads(ended.stdout)

    def test_gap_of_a_board(self):
        """Along a ray the board's far side is x / cos 45 + thickness / cos 45 before the floor at x: light
        leaks in up to where that is the bias."""
        study = self.study(BOARD, "--bias", "constant", "--from", 4, "--to", 12, "--steps", 3,
                           "--set", "shadow-maps.filter-radius=0", "--resolution", 256, "--size", "360x240")
        texel = study["texel-world"]
        self.assertGreater(study["edge-points"]["contact"], 50)
        for sample in study["sweeps"][0]["samples"]:
            expected = sample["bias"] * texel * math.cos(math.radians(45)) - THICKNESS
            # The map knows the board's depth to half a texel, and the picture the edge to half a pixel.
            off = texel * (0.5 + 0.5 * study["pixel-texels"]) * math.sqrt(2)
            self.assertAlmostEqual(sample["contact-gap"]["world"], expected, delta=off, msg=sample)
            self.assertAlmostEqual(sample["contact-gap"]["texels"],
                                   expected * math.sin(math.radians(45)) / texel, delta=1, msg=sample)

    def test_outline_of_a_board(self):
        """A bias along the normal lifts the floor by its sine; across the light, by its sine again."""
        study = self.study(BOARD, "--bias", "normal", "--from", 3, "--to", 9, "--steps", 3,
                           "--set", "shadow-maps.filter-radius=0", "--resolution", 256, "--size", "360x240")
        for sample in study["sweeps"][0]["samples"]:
            expected = sample["bias"] * math.sin(math.radians(45)) ** 2
            self.assertAlmostEqual(sample["outline-gap"]["texels"], expected, delta=1, msg=sample)
            self.assertLess(sample["contact-gap"]["texels"], 1, sample)

    def test_the_receivers_plane(self):
        quick = ("--bias", "slope", "--from", 0.5, "--to", 1, "--steps", 2)
        with_plane = self.study(BOARD, *quick)
        without = self.study(BOARD, *quick, "--set", "shadow-maps.receiver-plane=off")
        for a, b in zip(with_plane["sweeps"][0]["samples"], without["sweeps"][0]["samples"]):
            self.assertLess(a["acne"], 0.001)
            self.assertGreater(b["acne"], 0.01)

    def test_window(self):
        study = self.study(BOARD, "--steps", 9, *NAIVE)
        kinds = [sweep["kind"] for sweep in study["sweeps"]]
        self.assertEqual(kinds, ["constant", "slope", "normal"])
        self.assertLess(study["pixel-texels"], 0.6)
        for sweep in study["sweeps"]:
            window, samples = sweep["window"], sweep["samples"]
            self.assertIsNotNone(window, sweep["kind"])
            self.assertGreater(samples[0]["acne"], 0.05)
            self.assertEqual(samples[0]["gap"], 0)
            self.assertGreater(samples[-1]["gap"], 1)
            self.assertGreater(window["low"], 0)
            self.assertLess(window["high"], 4)
            self.assertTrue(window["low"] <= window["choice"] <= window["high"])
            for sample in samples:
                within = sample["acne"] <= 0.001 and sample["gap"] <= 1
                self.assertEqual(within, window["low"] <= sample["bias"] <= window["high"], sample)
        quick = self.study(BOARD, "--bias", "slope", "--steps", 2)
        self.assertLessEqual(quick["defaults"]["acne"], 0.001)

    def test_files(self):
        study = self.study(BOARD, "--bias", "slope", "--steps", 3)
        folder = self.folder / "out"
        self.assertEqual(json.loads((folder / "numbers.json").read_text()), study)
        for name in ("sheet.png", "strip-slope.png", "plot.png"):
            with Image.open(folder / name) as picture:
                self.assertGreater(len(set(picture.convert("RGB").getdata())), 20, name)
        self.assertFalse((folder / "strip-constant.png").exists())
        drawing = xml.etree.ElementTree.parse(folder / "plot.svg").getroot()
        self.assertGreater(len(list(drawing.iter())), 50)

    def test_summary(self):
        ended = self.succeeds("lab", "shadow-bias", self.scene(BOARD), "-o", "out", "--steps", 9)
        lines = ended.stdout.splitlines()
        self.assertTrue(lines[0].startswith("constant bias: safe from "), lines)
        self.assertIn("; take ", lines[0])
        self.assertTrue(lines[-1].startswith("as set (constant "), lines)

    def test_lights_of_every_type(self):
        for light in ({"type": "point", "position": [0, 2, 2]},
                      {"type": "cone", "position": [0, 2, 2], "target": [0, 0, 0], "angle": 40},
                      {"type": "key", "azimuth": 60, "elevation": 50}):
            study = self.study({**BOARD, "lights": [light]}, "--from", 0, "--to", 2, "--steps", 2, *NAIVE)
            first, last = study["sweeps"][0]["samples"]
            self.assertGreater(first["acne"], 0.05, light)
            self.assertLess(last["acne"], first["acne"] / 4, light)
            self.assertTrue(0 < study["texel-world"] < 0.3, study["texel-world"])
            self.assertGreater(study["pixels"]["dark"], 0, light)

    def test_the_strongest_of_several_lights(self):
        weak = {"type": "directional", "position": [1, 0, 0.1], "intensity": 0.2}
        quick = ("--bias", "constant", "--steps", 3)
        alone = self.study(BOARD, *quick)
        both = self.study({**BOARD, "lights": [weak, *BOARD["lights"]]}, *quick,
                          notes=["of 2 lights that cast shadows the strongest"])
        self.assertEqual(both, alone)

    def test_headlights_only_brighten_shadows(self):
        quick = ("--bias", "constant", "--steps", 3)
        alone = self.study(BOARD, *quick)
        lit = self.study({**BOARD, "lights": [*BOARD["lights"], {"type": "head", "intensity": 0.5}]}, *quick)
        for a, b in zip(alone["sweeps"][0]["samples"], lit["sweeps"][0]["samples"]):
            self.assertAlmostEqual(a["acne"], b["acne"], delta=1e-4)
            self.assertAlmostEqual(a["gap"], b["gap"], delta=0.01)

    def test_what_is_translucent_is_left_out(self):
        quick = ("--bias", "constant", "--steps", 3)
        glass = {"box": {"center": [0, -1, 0.5], "size": [1, 0.1, 0.5]}, "material": {"opacity": 0.5}}
        with_glass = self.study({**BOARD, "objects": [*BOARD["objects"], glass]}, *quick,
                                notes=["what is translucent is left out"])
        self.assertEqual(with_glass["edge-points"], self.study(BOARD, *quick)["edge-points"])

    def test_materials_cancel_out(self):
        quick = ("--bias", "constant", "--steps", 3)
        plain = self.study(BOARD, *quick)
        glowing = {**BOARD, "objects": [
            {**BOARD["objects"][0], "material": {"color": [0.2, 0.5, 0.1], "ambient": 0.3,
                                                 "emission": [0.3, 0.2, 0.1], "shading": "pbr"}},
            BOARD["objects"][1]]}
        other = self.study(glowing, *quick)
        for a, b in zip(plain["sweeps"][0]["samples"], other["sweeps"][0]["samples"]):
            self.assertAlmostEqual(a["acne"], b["acne"], delta=0.01)
            self.assertAlmostEqual(a["gap"], b["gap"], delta=0.1)

    def test_resolution_and_size(self):
        study = self.study(BOARD, "--bias", "slope", "--steps", 2, "--resolution", 100, "--size", "120x80")
        self.assertEqual((study["resolution"], study["size"]), (100, [120, 80]))
        large = {**BOARD, "size": [1280, 640]}
        coarse = ("--bias", "slope", "--steps", 2, "--resolution", 64)
        self.assertEqual(self.study(large, *coarse)["size"], [640, 320])

    def test_what_cannot_be_resolved_is_said(self):
        fine = ("--bias", "slope", "--steps", 2, "--resolution", 4096, *SMALL)
        self.study(BOARD, *fine, notes=["a pixel is "])


class Refused(command.CommandTest):
    def test_bad_options(self):
        board = self.scene(BOARD)
        for options, says in (
                (("--bias", "sideways"), "unknown bias 'sideways'"),
                (("--from", "3", "--to", "1"), "from 3 to 1"),
                (("--from", "-1"), "from -1 to 4"),
                (("--to", "nan"), "--from must be less than --to"),
                (("--steps", "1"), "--steps is 1"),
                (("--resolution", "3"), "--resolution is 3"),
                (("--set", "shadow-maps.wrong=1"), "unknown parameter 'wrong'"),
                (("--stpes", "3"), "unknown option '--stpes': did you mean '--steps'?")):
            self.refused("lab", "shadow-bias", board, "-o", "out", *options, says=says, status=2)
        self.refused("lab", "shadow-bias", board, says="--output is required", status=2)
        # Before anything is read, which may take long.
        self.refused("lab", "shadow-bias", "none.json", "-o", "out", "--steps", "1", says="--steps is 1",
                     status=2)

    def test_unknown_experiments(self):
        self.refused("lab", says="name a command: shadow-bias", status=2)
        self.refused("lab", "shadow-bais", says="did you mean 'shadow-bias'?", status=2)

    def test_nothing_to_study(self):
        def lab(*options, says):
            self.refused("lab", "shadow-bias", self.scene(BOARD), "-o", "out", *options, says=says, status=1)

        lab("--light", "head", says="no light of the scene casts shadows")
        lab("--light", "directional:0,0,-1", "--camera", "position=0,0,9,focal=0,0,0,up=0,1,0",
            says="the light shines on nothing in view")
        (self.folder / "file").write_text("")
        self.refused("lab", "shadow-bias", self.scene(BOARD), "-o", "file", says="the folder 'file'", status=1)


if __name__ == "__main__":
    unittest.main()
