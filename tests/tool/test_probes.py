# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""penumbra bake probes: its files, its sentences, its life."""
import json
import math
import pathlib
import time
import unittest

import command

WALL = {"color": [0.7, 0.7, 0.7], "shading": "flat"}
ROOM = {"size": [32, 24],
        "objects": [{"name": "room", "box": {"size": [2, 2, 2]}, "material": WALL},
                    {"name": "ball", "sphere": {"radius": 0.2}, "transform": {"translate": [0.4, 0, 0]}, "material": WALL}],
        "lights": [{"type": "point", "position": [0.3, -0.2, 0.6]}],
        "camera": {"position": [-0.9, -0.8, 0.5], "focal": [0.6, 0.5, -0.4], "up": [0, 0, 1], "angle": 70}}
# Balls close together over a large plane.
HEAP = {"size": [32, 24],
        "objects": [{"name": "plane", "box": {"size": [60, 60, 0.1], "center": [0, 0, -0.05]}, "material": WALL}] +
                   [{"name": f"ball {i}", "sphere": {"radius": 0.5}, "material": WALL, "transform":
                     {"translate": [6 + 1.2 * math.cos(0.6 * i), -4 + 1.2 * math.sin(0.6 * i), 0.6 + 0.15 * i]}}
                    for i in range(18)],
        "lights": [{"type": "point", "position": [2, -10, 9]}],
        "camera": {"position": [4.5, -9.5, 2.5], "focal": [6, -4, 1.6], "up": [0, 0, 1], "angle": 70}}
BAKE = ("--probes", 64, "--samples", 64)


class Probes(command.CommandTest):
    def bake(self, scene, *arguments, notes=()):
        return self.report("bake", "probes", scene, "-o", "room.vti", "--stats", *BAKE, *arguments, notes=notes)

    def brightness(self, scene, *arguments, notes=()):
        self.succeeds("render", scene, "-o", "seen.exr", "--preset", "off", "--frames", 1, *arguments, notes=notes)
        self.succeeds("render", scene, "-o", "plain.exr", "--preset", "off", "--frames", 1)
        compared = self.compare("seen.exr", "plain.exr")
        return compared["signed-mean"]

    def test_a_room_is_lit_by_its_bake(self):
        scene = self.scene(ROOM)
        report = self.bake(scene, "--without", "ball")
        self.assertEqual(report["samples"], 64)
        self.assertLessEqual(report["probes"], 64)
        self.assertEqual(report["resumed-samples"], 0)
        self.assertFalse((self.folder / "room.vti.part").exists())
        self.assertGreater(self.brightness(scene, "--bake", "room.vti"), 0.1)
        # From the scene file too.
        self.assertGreater(self.brightness(self.scene({**ROOM, "bakes": ["room.vti"]}, "with.json")), -1e-6)
        # The ball is no part of the bake; the lamp is.
        moved = json.loads(json.dumps(ROOM))
        moved["objects"][1]["transform"] = {"translate": [0.5, 0.2, 0]}
        self.assertGreater(self.brightness(self.scene(moved, "moved.json"), "--bake", "room.vti"), 0.1)
        moved["lights"][0]["position"] = [0.3, -0.2, 0.5]
        dark = self.brightness(self.scene(moved, "dark.json"), "--bake", "room.vti", "--set",
                               "sh-probes.live-fallback=off", notes=("no longer fit: light",))
        self.assertAlmostEqual(dark, 0.0, places=6)

    def test_finer_grids_where_light_needs_them(self):
        scene = self.scene(HEAP, "heap.json")
        bake = ("bake", "probes", scene, "--stats", "--probes", 900, "--samples", 16, "-o")
        one = self.report(*bake, "one.vti")
        self.assertEqual(one["finer-grids"], [])
        several = self.report(*bake, "several.vti", "--adaptive")
        self.assertLessEqual(several["probes"], 900)
        self.assertGreater(len(several["finer-grids"]), 0)
        finest = several["finer-grids"][-1]
        self.assertLess(max(finest["spacing"]), 0.7 * min(one["spacing"]))
        for axis, place in enumerate((6, -4)):
            self.assertLess(finest["bounds"][2 * axis], place)
            self.assertGreater(finest["bounds"][2 * axis + 1], place)
        self.assertGreater(self.brightness(scene, "--bake", "several.vti"), 0.01)
        content = (self.folder / "several.vti").read_bytes()
        at = content.index(b'Name="grids"')
        at = content.index(b">", at) + 40
        changed = content[:at] + (b"B" if content[at:at + 1] != b"B" else b"C") + content[at + 1:]
        (self.folder / "changed.vti").write_bytes(changed)
        self.refused("render", scene, "--bake", "changed.vti", "-o", "x.png", says="damaged", status=1)
        self.refused("bake", "probes", scene, "-o", "x.vti", "--adaptive", "--uniform", says="--uniform", status=2)
        self.refused("bake", "probes", scene, "-o", "x.vti", "--adaptive", "--probe-spacing", 1, says="--probe-spacing",
                     status=2)

    def test_a_killed_bake_is_gone_on_with(self):
        self.bake_killed(ROOM, "64", "4096")

    def test_a_killed_bake_of_several_grids_is_gone_on_with(self):
        self.bake_killed(HEAP, "900", "1024", "--adaptive")

    def bake_killed(self, described, probes, samples, *more):
        scene = self.scene(described, "killed.json")
        for earlier in self.folder.glob("killed.vti*"):  # folders may be kept
            earlier.unlink()
        settings = ["--probes", probes, "--samples", samples, *more]
        start = time.monotonic()
        whole = self.succeeds("bake", "probes", scene, "-o", "whole.vti", *settings, "--stats")
        seconds = time.monotonic() - start
        self.assertEqual(json.loads(whole.stdout)["resumed-samples"], 0)
        arguments = ["bake", "probes", scene, "-o", "killed.vti", *settings]
        part = self.folder / "killed.vti.part"
        self.killed_at_work(*arguments, when=part.exists, output="killed.vti")
        self.assertTrue(part.exists())
        self.assertFalse((self.folder / "killed.vti").exists())
        resumed = json.loads(self.succeeds(*arguments, "--stats").stdout)
        self.assertGreater(resumed["resumed-samples"], 0)
        self.assertFalse(part.exists())
        self.assertAlike(scene)
        self.killed_at_any_moment(*arguments, seconds=seconds, output="killed.vti", kills=3)
        self.assertAlike(scene)

    def assertAlike(self, scene):
        for name in ("whole", "killed"):
            self.succeeds("render", scene, "--bake", f"{name}.vti", "--preset", "off", "--frames", 1, "-o",
                          f"{name}.exr")
        compared = json.loads(self.succeeds("compare", "whole.exr", "killed.exr", "--json").stdout)
        self.assertLess(compared["maximum"], 0.002, "half floats round")

    def test_a_foreign_part_is_left(self):
        scene = self.scene(ROOM)
        self.bake(scene)
        other = self.folder / "room.vti.part"
        other.write_bytes((self.folder / "room.vti").read_bytes())
        self.assertEqual(self.bake(scene, notes=("starts from scratch",))["resumed-samples"], 0)
        other.write_text("nothing of use")
        self.assertEqual(self.bake(scene, notes=("starts from scratch",))["resumed-samples"], 0)

    def test_damaged_and_foreign_files(self):
        scene = self.scene(ROOM)
        self.bake(scene)
        content = (self.folder / "room.vti").read_bytes()

        def refused(name, data, says):
            (self.folder / name).write_bytes(data)
            self.refused("render", scene, "--bake", name, "-o", "x.png", says=says, status=1)

        refused("cut.vti", content[:len(content) // 2], "cut.vti")
        at = content.index(b'Spacing="') + 9
        refused("moved.vti", content[:at] + (b"9" if content[at:at + 1] != b"9" else b"8") + content[at + 1:],
                "checksum")
        refused("text.vti", b"no picture at all", "holds no baked light")
        self.succeeds("render", scene, "--stock", "-o", "sky.png")
        refused("picture.vti", (self.folder / "sky.png").read_bytes(), "holds no baked light")
        self.refused("render", scene, "--bake", "none.vti", "-o", "x.png", says="does not exist", status=1)

    def test_sentences(self):
        scene = self.scene(ROOM)
        for arguments, says in (
                (("-o", "x.exr"), ".vti"), (("-o", "x.vti", "--probes", 3), "--probes"),
                (("-o", "x.vti", "--samples", 0), "--samples"), (("-o", "x.vti", "--without", "bal"), "ball")):
            self.refused("bake", "probes", scene, *arguments, says=says, status=2)
        self.refused("bake", "probes", scene, "-o", "/nowhere/x.vti", says="cannot be written", status=1)
        self.refused("bake", "probes", scene, "-o", "x.vti", "--probe-spacing", 0.0001, says="more than 828100 probes", status=1)
        camera = {**ROOM, "lights": [{"type": "head"}]}
        self.bake(self.scene(camera, "head.json"), notes=("a light that follows the camera",))


if __name__ == "__main__":
    unittest.main()
