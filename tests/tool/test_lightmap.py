# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""penumbra bake lightmap: against known light and the path tracer, its files, its life."""
import copy
import json
import math
import pathlib
import time
import unittest

import command

CORNELL = pathlib.Path(__file__).resolve().parents[2] / "examples" / "cornell.json"
OLD = pathlib.Path(__file__).with_name("old_lightmap.exr")  # of lamp_room() without the ball
OFF = {"type": "directional", "position": [0, 0, -1], "intensity": 0}  # VTK lights nothing without any light
SMALL = ("--size", "48x36", "--preset", "off", "--frames", "1")


def room(reflectance, emission):
    """A closed box whose walls give off light, seen from inside."""
    return {"objects": [{"name": "room", "box": {"size": [2, 2, 2]},
                         "material": {"color": [reflectance] * 3, "shading": "flat", "emission": [emission] * 3}}],
            "lights": [OFF], "background": [0, 0, 0],
            "camera": {"position": [0.7, 0.6, 0.8], "focal": [-0.5, -0.6, -0.3], "up": [0, 0, 1], "angle": 75}}


def write_ripples(path, slope=0.5, waves=4, width=64):
    """A picture of normals that lean along both axes, by arctan(slope) at most."""
    wave = [slope * math.sin(2 * math.pi * waves * (i + 0.5) / width) for i in range(width)]
    pixels = bytearray()
    for y in wave:
        for x in wave:
            length = math.sqrt(x * x + y * y + 1)
            pixels += bytes(round(255 * (0.5 + 0.5 * part / length)) for part in (x, y, 1))
    path.write_bytes(b"P6 %d %d 255\n" % (width, width) + pixels)


def rippled_corner():
    """A floor and a wall whose normals a picture bends, beside a wall that glows."""
    rippled = {"color": [0.7, 0.7, 0.7], "shading": "pbr", "roughness": 1, "ior": 1, "normal-texture": "ripples.ppm"}
    glowing = {"color": [0.1, 0.1, 0.1], "shading": "flat", "emission": [0.9, 0.5, 0.3]}
    walls = [([[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1]], rippled),
             ([[-1, 1, -1], [1, 1, -1], [1, 1, 1], [-1, 1, 1]], rippled),
             ([[-1, -1, -1], [-1, 1, -1], [-1, 1, 1], [-1, -1, 1]], glowing)]
    return {"objects": [{"mesh": {"points": points, "polygons": [[0, 1, 2, 3]],
                                  "texture-coordinates": [[0, 0], [1, 0], [1, 1], [0, 1]]}, "material": material}
                        for points, material in walls],
            "background": [0, 0, 0], "lights": [OFF],
            "camera": {"position": [0.4, -4, 1.3], "focal": [0, 0, -0.1], "up": [0, 0, 1], "angle": 35}}


def rippled_floor():
    """A floor with steep ripples, alone under a sky that is the same everywhere."""
    floor, *_ = rippled_corner()["objects"]
    sky = {"box": {"size": [6, 6, 6]}, "material": {"color": [0, 0, 0], "shading": "flat", "emission": [1, 1, 1]}}
    return {"objects": [floor, sky], "background": [0, 0, 0], "lights": [OFF],
            "camera": {"position": [0, 0, 1.2], "focal": [0, 0, -1], "up": [0, 1, 0], "angle": 45}}


def lamp_room():
    """A room with a lamp, a ball and a block, open to the eye."""
    grey = {"color": [0.7, 0.7, 0.7], "shading": "flat"}
    wall = [
        ("floor", [[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1]], grey),
        ("left wall", [[-1, -1, -1], [-1, 1, -1], [-1, 1, 1], [-1, -1, 1]], {**grey, "color": [0.8, 0.2, 0.1]}),
        ("back wall", [[-1, 1, -1], [1, 1, -1], [1, 1, 1], [-1, 1, 1]], grey),
    ]
    objects = [{"name": name, "mesh": {"points": points, "polygons": [[0, 1, 2, 3]]}, "material": material}
               for name, points, material in wall]
    objects.append({"name": "ball", "sphere": {"center": [0.3, 0.2, -0.5], "radius": 0.4},
                    "material": {"color": [0.6, 0.7, 0.8], "shading": "phong"}})
    return {"objects": objects, "background": [0, 0, 0],
            "lights": [{"type": "point", "position": [0.5, -0.6, 0.9], "intensity": 0.8}],
            "camera": {"position": [0.4, -4, 0.3], "focal": [0, 0, -0.1], "up": [0, 0, 1], "angle": 35}}


class Lightmap(command.LightmapTest):
    def test_closed_enclosure(self):
        for reflectance in (0.5, 0.8):
            emission = 0.2
            scene = self.scene(room(reflectance, emission))
            self.bake(scene, "--texel-size", 0.7, "--samples", 4096, "--from-scratch")
            self.succeeds("render", scene, "--bake", "map.vti", *SMALL, "-o", "lit.exr")
            expected = emission / (1 - reflectance)
            flat = {"objects": [{"box": {}}], "background": [expected] * 3, "camera": {"position": [0, 0, 9],
                                                                                       "focal": [0, 0, 90]}}
            self.succeeds("render", self.scene(flat, "flat.json"), *SMALL, "-o", "flat.exr")
            compared = self.compare("lit.exr", "flat.exr")
            error = compared["maximum"] / expected
            print(f"\nreflectance {reflectance}: E / (1 - r) = {expected}, off by {100 * error:.2f} % at most")
            self.assertLess(error, 0.0045 if reflectance < 0.8 else 0.0075)

    def test_cornell_box_is_the_path_tracers(self):
        scene = json.loads(CORNELL.read_text())
        scene["lights"] = [OFF]
        path = self.scene(scene, "cornell.json")
        size = ("--size", "64x64")
        baked = self.bake(path, "--texel-size", 16, "--samples", 64, "--from-scratch")
        self.succeeds("render", path, "--preset", "off", "--on", "anti-aliasing", "--bake", "map.vti", *size, "-o",
                      "lit.exr")
        self.succeeds("render", path, "--preset", "reference", "--spp", 256, *size, "-o", "traced.exr")
        compared = self.compare("lit.exr", "traced.exr", "--mask-above", 3)
        print(f"\nCornell box, {baked['texels']} texels of 64 samples: relMSE {compared['relmse']:.6f}, "
              f"signed mean {compared['signed-mean']:+.6f}")
        self.assertLess(compared["relmse"], 0.0012)
        self.assertGreater(baked["buried-texels"], 0, "the floor below the blocks")
        self.assertGreater(baked["dark-sides"], 0, "the insides of the blocks")

    def test_no_seam_shows(self):
        """A ball of many charts: the step where they meet, of the light there."""
        scene = self.scene(lamp_room())
        baked = self.bake(scene, "--texel-size", 0.1, "--samples", 64, "--from-scratch")
        print(f"\n{baked['tiles']} charts: step across seams {100 * baked['open-seam-step']:.2f} %, closed "
              f"{100 * baked['seam-step']:.2f} %")
        self.assertGreater(baked["tiles"], 8)
        self.assertGreater(baked["open-seam-step"], 0.54)
        self.assertLess(baked["seam-step"], 0.01)

    def test_denoising_pays(self):
        """Error against many samples, of few samples with and without."""
        scene = self.scene(lamp_room())
        few = ("--texel-size", 0.06, "--open-seams", "--from-scratch")
        self.bake(scene, *few, "--samples", 512, "--no-denoise", output="exact.vti")
        self.bake(scene, *few, "--samples", 32, "--no-denoise", output="noisy.vti")
        self.bake(scene, *few, "--samples", 32, output="denoised.vti")
        noisy = self.compare_maps("noisy.vti", "exact.vti")["relmse"]
        denoised = self.compare_maps("denoised.vti", "exact.vti")["relmse"]
        print(f"\nrelMSE of the map at 32 samples {noisy:.5f}, denoised {denoised:.5f}")
        self.assertLess(denoised, 0.6 * noisy)

    def test_a_changed_scene_is_told(self):
        scene = lamp_room()
        self.bake(self.scene(scene), "--texel-size", 0.4, "--samples", 16, "--from-scratch")

        def changed(change, says):
            other = copy.deepcopy(scene)
            change(other)
            path = self.scene(other, "other.json")
            self.succeeds("render", path, *SMALL, "-o", "without.exr")
            notes = (f"no longer fits: {says} since the bake",) if says else ()
            self.succeeds("render", path, "--bake", "map.vti", "--set", "lightmap.live-fallback=off", *SMALL, "-o",
                          "with.exr", notes=notes)
            same = self.compare("with.exr", "without.exr")["maximum"] == 0
            self.assertEqual(same, bool(says), f"stale light in '{says}'")

        changed(lambda s: None, "")
        changed(lambda s: s["objects"][0]["mesh"]["points"][0].__setitem__(0, -1.1), "'floor' changed its shape")
        changed(lambda s: s["objects"][3].update(transform={"translate": [0.01, 0, 0]}), "'ball' moved")
        changed(lambda s: s["objects"][1]["material"].update(color=[0.8, 0.21, 0.1]), "'left wall' changed its look")
        changed(lambda s: s["lights"][0].update(intensity=0.81), "light 1 changed its colour or strength")
        changed(lambda s: s["objects"].pop(2), "'back wall' is gone or hidden")
        changed(lambda s: s["objects"].append({"name": "visitor", "box": {"size": [0.2, 0.2, 0.2]}}), "")

    def test_probes_light_what_a_stale_bake_does_not(self):
        """Without being asked to, as where they are on and there is no bake."""
        scene = lamp_room()
        self.bake(self.scene(scene), "--texel-size", 0.4, "--samples", 16, "--from-scratch")
        scene["lights"][0]["intensity"] = 0.5
        path = self.scene(scene, "other.json")
        few = ("--set", "ddgi.probes=64", "--set", "ddgi.updates=8", "--size", "48x36", "--preset", "off")
        live = self.report("render", path, "--on", "ddgi", *few, "-o", "live.exr", "--stats")
        self.assertGreaterEqual(live["frames"], 8)
        self.succeeds("render", path, *SMALL, "-o", "without.exr")
        stale = self.report("render", path, "--bake", "map.vti", *few, "-o", "fallen-back.exr", "--stats",
                            notes=("no longer fits",))
        self.assertEqual(stale["frames"], live["frames"], "all updates are waited for")
        self.assertEqual(self.compare("fallen-back.exr", "live.exr")["maximum"], 0)
        self.assertGreater(self.compare("without.exr", "live.exr")["maximum"], 0.01)

    def test_what_moves_is_left_out(self):
        scene = self.scene(lamp_room())
        self.bake(scene, "--texel-size", 0.4, "--samples", 16, "--from-scratch", "--without", "ball")
        other = lamp_room()
        other["objects"][3]["transform"] = {"translate": [0.1, 0, 0]}
        self.succeeds("render", self.scene(other, "other.json"), "--bake", "map.vti", *SMALL, "-o", "with.exr")
        self.refused("bake", "lightmap", scene, "-o", "no.vti", "--without", "bal", says="ball", status=2)

    def test_killed_and_resumed(self):
        """A bake that is killed goes on where it was, to the light that one without a break has."""
        scene = self.scene(lamp_room())
        settings = ("--texel-size", 0.08, "--samples", 1024)
        start = time.monotonic()
        self.bake(scene, *settings, "--from-scratch", output="whole.vti")
        seconds = time.monotonic() - start
        bake = ("bake", "lightmap", scene, "-o", "broken.vti", *settings)
        progress = self.folder / "broken.vti.baking"
        self.killed_at_work(*bake, when=progress.exists, output="broken.vti")
        self.assertTrue(progress.exists())
        self.assertFalse((self.folder / "broken.vti").exists())
        kept = progress.read_bytes()
        # Of another scene's, and one that is cut off, nothing is taken.
        progress.write_bytes(kept[:-100])
        damaged = self.bake(scene, "--texel-size", 0.4, "--samples", 16, notes=("is damaged",), output="broken.vti")
        self.assertEqual(damaged["resumed"], 0)
        (self.folder / "broken.vti").unlink()
        progress.write_bytes(kept)
        other = self.bake(scene, "--texel-size", 0.4, "--samples", 16, notes=("of another scene",), output="broken.vti")
        self.assertEqual(other["resumed"], 0)
        (self.folder / "broken.vti").unlink()
        progress.write_bytes(kept)
        resumed = self.bake(scene, *settings, output="broken.vti")
        compared = self.compare_maps("broken.vti", "whole.vti")
        print(f"\nkilled at {100 * resumed['resumed']:.0f} %, resumed: differs by {compared['maximum']:.2g} at most")
        self.assertGreater(resumed["resumed"], 0)
        self.assertLess(compared["maximum"], 1e-3, "rounding of half floats")
        self.assertFalse(progress.exists())
        self.killed_at_any_moment(*bake, seconds=seconds, output="broken.vti")
        self.assertLess(self.compare_maps("broken.vti", "whole.vti")["maximum"], 1e-3)

    def test_baked_again_what_changed(self):
        """Two closed rooms: a change in one leaves the other's light as it was baked."""
        def rooms(color):
            left, right = room(0.5, 0.2)["objects"][0], room(0.5, 0.2)["objects"][0]
            left = {**left, "name": "left"}
            right = {**right, "name": "right", "transform": {"translate": [3, 0, 0]}}
            right["material"] = {**right["material"], "color": color}
            return {**room(0.5, 0.2), "objects": [left, right]}
        settings = ("--texel-size", 0.4, "--samples", 64)
        first = self.bake(self.scene(rooms([0.5] * 3)), *settings, "--from-scratch")
        again = self.bake(self.scene(rooms([0.5] * 3)), *settings)
        self.assertEqual((first["kept-tiles"], again["kept-tiles"]), (0, first["tiles"]))
        # With seams, of a ball's charts: closed once, they stay as they are.
        scene = self.scene(lamp_room(), "ball.json")
        first = self.bake(scene, "--texel-size", 0.1, "--samples", 16, "--from-scratch", output="ball.vti")
        (self.folder / "once.vti").write_bytes((self.folder / "ball.vti").read_bytes())
        again = self.bake(scene, "--texel-size", 0.1, "--samples", 16, output="ball.vti")
        self.assertEqual(again["kept-tiles"], first["tiles"])
        self.assertLess(self.compare_maps("ball.vti", "once.vti")["maximum"], 1e-3, "rounding of half floats")
        before = self.bake(self.scene(rooms([0.3, 0.5, 0.4])), *settings, "--from-scratch", output="whole.vti")
        changed = self.bake(self.scene(rooms([0.3, 0.5, 0.4])), *settings)
        print(f"\n{changed['kept-tiles']} of {changed['tiles']} tiles kept")
        self.assertGreaterEqual(changed["kept-tiles"], 6)
        self.assertLess(changed["kept-tiles"], changed["tiles"])
        self.assertEqual(before["tiles"], changed["tiles"])
        self.assertLess(self.compare_maps("map.vti", "whole.vti")["maximum"], 2e-3)

    def test_directional(self):
        scene = self.scene(room(0.5, 0.2))
        self.bake(scene, "--texel-size", 0.4, "--samples", 256, "--directional", "--from-scratch")
        self.succeeds("render", scene, "--bake", "map.vti", *SMALL, "-o", "with.exr")
        self.bake(scene, "--texel-size", 0.4, "--samples", 256, "--from-scratch")
        self.succeeds("render", scene, "--bake", "map.vti", *SMALL, "-o", "plain.exr")
        difference = self.compare("with.exr", "plain.exr")["maximum"]
        self.assertLess(difference, 0.01 * 0.4, "normals are as baked, other directions are sampled")

    def bent_errors(self, scene, slope, texel):
        """relMSE against the path tracer, of maps without moments and with."""
        write_ripples(self.folder / "ripples.ppm", slope)
        scene = self.scene(scene)
        size = ("--size", "64x64")
        self.succeeds("render", scene, "--preset", "reference", "--spp", 512, *size, "-o", "traced.exr")
        errors = []
        for options in ((), ("--directional",)):
            self.bake(scene, "--texel-size", texel, "--samples", 256, *options, "--from-scratch")
            self.succeeds("render", scene, "--preset", "off", "--on", "anti-aliasing", "--bake", "map.vti", *size, "-o",
                          "lit.exr")
            compared = self.compare("lit.exr", "traced.exr", "--mask-above", 0.85)
            errors.append(compared["relmse"])
            print(f"\nbent normals, {' '.join(options) or 'plain'}: relMSE {compared['relmse']:.5f}, signed mean "
                  f"{compared['signed-mean']:+.5f}")
        return errors

    def test_normals_that_a_picture_bends(self):
        """Light from the side, and light from everywhere, which is lost half as fast."""
        plain, directional = self.bent_errors(rippled_corner(), 0.5, 0.1)
        self.assertGreater(plain, 0.03, "else there is nothing to gain")
        self.assertLess(directional, 0.002)
        plain, directional = self.bent_errors(rippled_floor(), 1.2, 0.3)
        self.assertGreater(plain, 0.03)
        self.assertLess(directional, 0.001)

    def test_old_files(self):
        """A lightmap in the old form shows the same light before and after it is converted."""
        described = lamp_room()
        described["objects"].pop()
        scene = self.scene(described, "walls.json")
        self.succeeds("render", scene, *SMALL, "-o", "without.exr")
        for old in (OLD, OLD.with_name("old_lightmap_plain.exr")):
            self.succeeds("render", scene, "--bake", old, *SMALL, "-o", "old.exr",
                          notes=(f"penumbra bake convert {old} -o NEW.vti",))
            self.succeeds("bake", "convert", old, "-o", "new.vti")
            self.succeeds("render", scene, "--bake", "new.vti", *SMALL, "-o", "new.exr")
            self.assertEqual(self.compare("new.exr", "old.exr")["maximum"], 0)
            self.assertGreater(self.compare("new.exr", "without.exr")["maximum"], 0.01)

    def test_what_is_refused(self):
        scene = self.scene(lamp_room())
        self.bake(scene, "--texel-size", 0.4, "--samples", 16, "--from-scratch")
        whole = (self.folder / "map.vti").read_bytes()

        def refused(content, says, name="bad.vti"):
            (self.folder / name).write_bytes(content)
            self.refused("render", scene, "--bake", name, "-o", "no.png", says=says, status=1)
        refused(whole[: len(whole) // 2], "damaged")
        refused(b"no picture", "bad.vti")
        refused(whole[:2000] + b"\x55" * 64 + whole[2064:], "bad.vti")
        self.succeeds("render", scene, *SMALL, "-o", "picture.exr")
        refused((self.folder / "picture.exr").read_bytes(), "no baked light")
        self.refused("bake", "convert", "picture.exr", "-o", "no.vti", says="no baked light", status=1)
        self.refused("bake", "convert", "map.vti", "-o", "no.vti", says="'map.vti' is not an OpenEXR file", status=1)
        self.refused("bake", "convert", "nowhere.exr", "-o", "no.vti", says="'nowhere.exr'", status=1)
        self.refused("bake", "convert", "picture.exr", "-o", "no.exr", says=".vti", status=2)
        old = OLD.read_bytes()
        refused(old[: len(old) // 2], "bad.vti")
        refused(old.replace(b"'floor'", b"'flour'"), "checksum")
        self.refused("render", scene, "--bake", "nowhere.vti", "-o", "no.png", says="nowhere.vti", status=1)
        (self.folder / "map.vti").write_bytes(b"no picture")
        self.refused("bake", "lightmap", scene, "-o", "map.vti", says="--from-scratch", status=1)
        self.refused("bake", "lightmap", scene, "-o", "map.png", says=".vti", status=2)
        self.refused("bake", "lightmap", scene, "-o", "no.vti", "--samples", 40, says="multiple of 16", status=2)
        self.refused("bake", "lightmap", scene, "-o", "no.vti", "--texel-size", -1, says="--texel-size", status=2)
        self.refused("bake", "lightmap", scene, "-o", "no.vti", "--max-size", 16, says="--max-size", status=1)
        dark = {**lamp_room(), "lights": [OFF]}
        self.refused("bake", "lightmap", self.scene(dark, "dark.json"), "-o", "no.vti", says="no indirect light",
                     status=1)
        self.assertFalse((self.folder / "no.vti").exists())


if __name__ == "__main__":
    unittest.main()
