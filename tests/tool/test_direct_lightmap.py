# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""penumbra bake lightmap --direct: the lamps' own light in the map, once, for what stands still."""
import copy
import json
import pathlib
import unittest

import command

CORNELL = pathlib.Path(__file__).resolve().parents[2] / "examples" / "cornell_lamp.json"
SMALL = ("--size", "64x64", "--preset", "off")
BALL = {"name": "ball", "sphere": {"center": [160, 300, 120], "radius": 70, "resolution": 48},
        "material": {"color": [0.8, 0.8, 0.3], "shading": "phong"}}


class DirectLightmap(command.LightmapTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.cornell = json.loads(CORNELL.read_text())

    def test_cornell_box_is_the_path_tracers(self):
        """The whole picture, with no technique for shadows: they are the map's."""
        scene = self.scene(self.cornell)
        baked = self.bake(scene, "--direct", "--texel-size", 5, "--samples", 16, "--from-scratch")
        self.succeeds("render", scene, *SMALL, "--on", "anti-aliasing", "--bake", "map.vti", "-o", "lit.exr")
        self.succeeds("render", scene, "--preset", "reference", "--spp", 256, "--size", "64x64", "-o", "traced.exr")
        compared = self.compare("lit.exr", "traced.exr")
        self.succeeds("render", scene, *SMALL, "--on", "anti-aliasing", "-o", "unshadowed.exr")
        without = self.compare("unshadowed.exr", "traced.exr")["relmse"]
        print(f"\nCornell box with a lamp, {baked['texels']} texels: relMSE {compared['relmse']:.6f}, signed mean "
              f"{compared['signed-mean']:+.6f}; the lamp alone {without:.4f}")
        self.assertLess(compared["relmse"], 0.003)
        self.assertLess(abs(compared["signed-mean"]), 0.0018)

    def test_what_moves_is_lit_by_lamps(self):
        """A ball that the bake does not know has the lamps' light and shadow, the walls have theirs."""
        scene = copy.deepcopy(self.cornell)
        scene["objects"].append(BALL)
        path = self.scene(scene)
        few = ("--texel-size", 24, "--samples", 16, "--from-scratch", "--without", "ball")
        self.bake(path, *few, "--direct", output="direct.vti")
        near = {**scene, "camera": {**scene["camera"], "focal": BALL["sphere"]["center"], "angle": 4}}
        differ = {}
        for view, described in (("room", scene), ("ball", near)):
            path = self.scene(described, f"{view}.json")
            for name, more in (("none", ()), ("direct", ("--bake", "direct.vti"))):
                self.succeeds("render", path, *SMALL, "--on", "shadow-maps", *more, "-o", f"{name}_picture.exr")
            differ[view] = self.compare("direct_picture.exr", "none_picture.exr")["maximum"]
        print(f"\nby the map other light in the room by {differ['room']:.2f}, on the ball by {differ['ball']:.2g}")
        self.assertEqual(differ["ball"], 0, "the ball's light is the frame's")
        self.assertGreater(differ["room"], 0.05, "the walls' is the map's")

    def test_a_changed_lamp_is_live(self):
        path = self.scene(self.cornell)
        self.bake(path, "--direct", "--texel-size", 24, "--samples", 16, "--from-scratch")
        other = copy.deepcopy(self.cornell)
        other["lights"][0]["intensity"] = 0.7
        dimmed = self.scene(other, "dimmed.json")
        self.succeeds("render", dimmed, *SMALL, "-o", "without.exr")
        self.succeeds("render", dimmed, "--bake", "map.vti", "--set", "lightmap.live-fallback=off", *SMALL, "-o", "with.exr",
                      notes=("no longer fits: light 1 changed its colour or strength since the bake",))
        self.assertEqual(self.compare("with.exr", "without.exr")["maximum"], 0)

    def test_a_floor_that_only_a_lamp_lights(self):
        """Without any indirect light: nothing to bake but with --direct, and then what VTK draws."""
        points = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]
        scene = {"objects": [{"mesh": {"points": points, "polygons": [[0, 1, 2, 3]]}}], "background": [0, 0, 0],
                 "lights": [{"type": "point", "position": [0.3, 0.2, 1], "intensity": 0.8}],
                 "camera": {"position": [0, -2, 2], "focal": [0, 0, 0], "up": [0, 0, 1]}}
        path = self.scene(scene)
        self.refused("bake", "lightmap", path, "-o", "no.vti", says="no indirect light", status=1)
        self.bake(path, "--direct", "--texel-size", 0.02, "--samples", 16, "--from-scratch")
        self.succeeds("render", path, *SMALL, "-o", "without.exr")
        self.succeeds("render", path, *SMALL, "--bake", "map.vti", "-o", "with.exr")
        compared = self.compare("with.exr", "without.exr")
        print(f"\na floor: relMSE {compared['relmse']:.2g} of what VTK draws")
        self.assertLess(compared["relmse"], 1.5e-7)

    def test_killed_and_resumed(self):
        """As without --direct; and what was gathered with it is not gone on with without, or the other way."""
        scene = self.scene(self.cornell)
        settings = ("--texel-size", 12, "--samples", 64)
        self.bake(scene, *settings, "--direct", "--from-scratch", output="whole.vti")
        progress = self.folder / "broken.vti.baking"
        self.killed_at_work("bake", "lightmap", scene, "-o", "broken.vti", "--direct", *settings, when=progress.exists,
                            output="broken.vti")
        kept = progress.read_bytes()
        other = self.bake(scene, *settings, notes=("of other settings",), output="broken.vti")
        self.assertEqual(other["resumed"], 0)
        (self.folder / "broken.vti").unlink()
        progress.write_bytes(kept)
        resumed = self.bake(scene, *settings, "--direct", output="broken.vti")
        compared = self.compare_maps("broken.vti", "whole.vti")
        print(f"\nkilled at {100 * resumed['resumed']:.0f} %, resumed: differs by {compared['maximum']:.2g} at most")
        self.assertGreater(resumed["resumed"], 0)
        self.assertLess(compared["maximum"], 1e-3, "rounding of half floats")

    def test_baked_again(self):
        """Of a map without the lamps' light nothing is kept for one with it; of one with it, what did not change."""
        scene = self.scene(self.cornell)
        few = ("--texel-size", 24, "--samples", 16)
        tiles = self.bake(scene, *few, "--from-scratch")["tiles"]
        self.assertEqual(self.bake(scene, *few, "--direct")["kept-tiles"], 0)
        first = (self.folder / "map.vti").read_bytes()
        self.assertEqual(self.bake(scene, *few, "--direct")["kept-tiles"], tiles)
        (self.folder / "first.vti").write_bytes(first)
        self.assertLess(self.compare_maps("map.vti", "first.vti")["maximum"], 1e-3)
        self.assertEqual(self.bake(scene, *few)["kept-tiles"], 0)


if __name__ == "__main__":
    unittest.main()
