# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""penumbra bake radiosity: against the path tracer, its files, its sentences, its life."""
import base64
import json
import math
import os
import pathlib
import pty
import signal
import struct
import subprocess
import time
import unittest

import command

CORNELL = pathlib.Path(__file__).resolve().parents[2] / "examples" / "cornell.json"
LAMP = {"type": "directional", "position": [0, 0, 1]}
FLOOR = {"plane": {"size": [2, 2]}, "material": {"color": [0.5, 0.5, 0.5]}}
ROOM = {"size": [32, 24], "objects": [FLOOR], "lights": [LAMP]}


class Radiosity(command.CommandTest):
    def bake(self, scene, *arguments, notes=()):
        return self.report("bake", "radiosity", scene, "-o", "solution.vtp", "--stats", *arguments, notes=notes)

    def test_cornell_box_is_the_path_tracers(self):
        """The lamp's own pixels are masked: what its outline makes is no light of radiosity."""
        size = ("--size", "64x64")
        self.succeeds("render", CORNELL, "--preset", "reference", "--spp", 512, *size, "-o", "traced.exr")
        baked = self.bake(CORNELL, *size, "--patch-size", 40, "--refine", 0, "--solver", "both", "--view",
                          "baked.exr")
        compared = self.compare("baked.exr", "traced.exr", "--mask-above", 3)
        print(f"\nCornell box, {baked['patches']} patches: relMSE {compared['relmse']:.6f} ({compared['masked-pixels']} "
              f"pixels of the lamp masked), signed mean "
              f"{compared['signed-mean']:+.6f}; solvers apart by {100 * baked['solvers-differ']:.4f} %")
        self.assertLess(compared["relmse"], 0.00075)
        self.assertLess(baked["solvers-differ"], 0.001)

    def test_a_lamp_without_reflections(self):
        """A light of colour 1 makes a surface of reflectance 0.5 show 0.5."""
        self.bake(self.scene(ROOM), "--camera", "position=0,0,5,focal=0,0,0,up=0,1,0", "--view", "floor.exr",
                  "--background", "0.5,0.5,0.5")
        flat = {**ROOM, "objects": [{"plane": {"size": [90, 90]}, "material": {"color": [0.5, 0.5, 0.5]}}]}
        self.succeeds("render", self.scene(flat, "flat.json"), "--stock", "-o", "flat.exr", "--camera",
                      "position=0,0,5,focal=0,0,0,up=0,1,0")
        compared = json.loads(self.succeeds("compare", "floor.exr", "flat.exr", "--json").stdout)
        self.assertLess(compared["maximum"], 0.003, "an 8-bit picture's rounding")

    def test_colours_of_data(self):
        """Cell arrays albedo and emission stand in place of the look: a lamp over a floor."""
        (self.folder / "lamp.vtk").write_text(
            "# vtk DataFile Version 3.0\nlamp\nASCII\nDATASET POLYDATA\nPOINTS 8 double\n"
            "-1 -1 0 1 -1 0 1 1 0 -1 1 0 -1 -1 1 -1 1 1 1 1 1 1 -1 1\n"
            "POLYGONS 2 10\n4 0 1 2 3\n4 4 5 6 7\nCELL_DATA 2\n"
            "FIELD data 2\nalbedo 3 2 double\n0.25 0.5 0.75\n0 0 0\nemission 3 2 double\n0 0 0\n1 2 3\n")
        scene = {"objects": [{"file": "lamp.vtk"}], "lights": []}
        self.bake(self.scene(scene), "--patch-size", 0.5, "--refine", 0, "--rays", 16,
                  notes=("highlights",))
        content = (self.folder / "solution.vtp").read_bytes()
        for name in (b"radiosity", b"irradiance", b"albedo", b"emission", b"error", b"gathering residual"):
            self.assertIn(b'Name="' + name, content)

    def test_an_environment_lights(self):
        """A white floor under a sky of radiance 1 has radiance 1 less what it absorbs."""
        self.succeeds("render", self.scene(ROOM), "--stock", "-o", "sky.hdr", "--background", "1,1,1", "--camera",
                      "position=0,0,5,focal=0,0,90,up=0,1,0", "--size", "16x8")
        open_floor = {**ROOM, "lights": []}
        self.bake(self.scene(open_floor, "open.json"), "--env", "sky.hdr", "--camera",
                  "position=0,0,3,focal=0,0,0,up=0,1,0", "--view", "open.exr", "--background", "0.5,0.5,0.5")
        self.succeeds("render", self.scene(ROOM), "--stock", "-o", "half.exr", "--background", "0.5,0.5,0.5",
                      "--camera", "position=0,0,5,focal=0,0,90,up=0,1,0")
        compared = json.loads(self.succeeds("compare", "open.exr", "half.exr", "--json").stdout)
        self.assertLess(compared["maximum"], 0.003)

    def test_what_is_refused(self):
        def refused(scene, *arguments, says, status):
            path = self.scene(scene, "refused.json")
            self.refused("bake", "radiosity", path, "-o", "no.vtp", *arguments, says=says, status=status)
            self.assertFalse((self.folder / "no.vtp").exists())
        refused({**ROOM, "lights": []}, says="has no light", status=1)
        line = {"mesh": {"points": [[0, 0, 0], [1, 0, 0], [2, 0, 0]], "polygons": [[0, 1, 2]]}}
        refused({**ROOM, "objects": [line]}, says="no surface of any area", status=1)
        refused({**ROOM, "objects": []}, says="no objects", status=2)
        white = {"box": {}, "material": {"color": [1, 1, 1]}}
        refused({**ROOM, "objects": [white]}, says="reflects all light", status=1)
        refused(ROOM, "--max-patches", 1, says="--max-patches", status=1)
        refused(ROOM, "--patch-size", 0.0001, says="--patch-size", status=1)
        refused(ROOM, "--patch-size", -1, says="--patch-size is -1", status=2)
        refused(ROOM, "--rays", 0, says="--rays is 0", status=2)
        refused(ROOM, "--solver", "shoting", says="shooting", status=2)
        refused(ROOM, "--view", "no.txt", says="no.txt", status=2)
        self.refused("bake", "radiosity", self.scene(ROOM), "-o", "no.vtk", says=".vtp", status=2)
        self.refused("bake", "radiosity", self.scene(ROOM), "-o", "nowhere/no.vtp", says="nowhere/no.vtp", status=1)
        self.refused("bake", says="name a command", status=2)
        self.refused("bake", "radiosty", says="radiosity", status=2)

    def test_points_that_are_no_numbers(self):
        def block(form, *numbers):
            raw = struct.pack(f"<{len(numbers)}{form}", *numbers)
            return base64.b64encode(struct.pack("<I", len(raw)) + raw).decode()
        array = '<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="binary">{}</DataArray>'
        (self.folder / "nan.vtp").write_text(
            '<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>'
            '<Piece NumberOfPoints="5" NumberOfPolys="2"><Points>'
            + array.format("Float32", "Points", 3, block("f", 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, math.nan, 0, 0))
            + "</Points><Polys>" + array.format("Int64", "connectivity", 1, block("q", 0, 1, 2, 0, 2, 4))
            + array.format("Int64", "offsets", 1, block("q", 3, 6)) + "</Polys></Piece></PolyData></VTKFile>")
        scene = {"objects": [{"file": "nan.vtp", "material": {"color": [0.5, 0.5, 0.5]}}], "lights": [LAMP]}
        self.bake(self.scene(scene), "--refine", 0, notes=("not finite",))

    def test_a_killed_bake_leaves_what_was_there(self):
        """A long one says how long; killed, it leaves the older solution as it is."""
        self.bake(self.scene(ROOM))
        before = (self.folder / "solution.vtp").read_bytes()
        leader, follower = pty.openpty()
        process = subprocess.Popen(
            [command.COMMAND, "bake", "radiosity", CORNELL, "-o", "solution.vtp", "--rays", "100000"],
            cwd=self.folder, stdout=subprocess.DEVNULL, stderr=follower, start_new_session=True)
        os.close(follower)
        said = b""
        until = time.monotonic() + command.LONGEST
        while b" left" not in said and time.monotonic() < until:
            said += os.read(leader, 4096)
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        os.close(leader)
        self.assertIn(b"tracing form factors", said)
        self.assertIn(b" left", said)
        self.assertEqual((self.folder / "solution.vtp").read_bytes(), before)
        self.assertFalse(list(self.folder.glob("*.part")))
        (self.folder / "solution.vtp.baking").unlink()  # what it traced is for no other test

    def test_a_killed_bake_is_gone_on_with(self):
        """To the solution of one that was not killed, to the last byte; whatever was cut off or damaged is traced again."""
        ball = {"sphere": {"radius": 0.3}, "material": FLOOR["material"]}
        bake = ("bake", "radiosity", self.scene({**ROOM, "objects": [FLOOR, ball]}), "--patch-size", 0.2, "--rays", 256)
        start = time.monotonic()
        self.succeeds(*bake, "-o", "whole.vtp")
        seconds = time.monotonic() - start
        whole = (self.folder / "whole.vtp").read_bytes()
        broken = self.folder / "broken.vtp"
        self.killed_at_any_moment(*bake, "-o", "broken.vtp", seconds=seconds, output="broken.vtp")
        self.assertEqual(broken.read_bytes(), whole)
        log = self.folder / "broken.vtp.baking"

        def goes_on(left, *more, notes=()):
            log.write_bytes(left)
            broken.unlink(missing_ok=True)
            told = self.report(*bake, "-o", "broken.vtp", "--stats", *more, notes=notes)
            self.assertFalse(log.exists())
            self.assertEqual(broken.read_bytes(), whole)
            return told["resumed"]

        # Killed later and later, until a whole block was written.
        share, least = 0, 1000
        while share == 0:
            self.killed_at_work(*bake, "-o", "broken.vtp", output="broken.vtp",
                                when=lambda: log.exists() and log.stat().st_size > least)
            kept = log.read_bytes()
            share, least = goes_on(kept), 2 * len(kept)
        print(f"resumed: {100 * share:.0f} % taken over")
        self.assertEqual(goes_on(kept[:1000]), 0, "a block that is cut off is not taken")
        self.assertEqual(goes_on(kept[:1000] + bytes([kept[1000] ^ 1]) + kept[1001:]), 0)
        self.assertEqual(goes_on(kept, "--from-scratch"), 0)
        self.assertEqual(goes_on(b"nothing of use", notes=("starts from scratch",)), 0)
        log.write_bytes(kept)
        other = self.report("bake", "radiosity", self.scene(ROOM, "other.json"), "-o", "broken.vtp", "--stats",
                            notes=("starts from scratch",))
        self.assertEqual(other["resumed"], 0)


if __name__ == "__main__":
    unittest.main()
