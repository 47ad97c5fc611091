# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the command promises where all is well."""
import array
import itertools
import json
import math
import unittest

from PIL import Image

import command

SCENE = {
    "size": [64, 48],
    "objects": [
        {"plane": {"size": [6, 6]}, "material": {"color": "gray"}},
        {"box": {"center": [0, 0, 0.5]}, "material": {"color": [0.8, 0.3, 0.2]}},
        {"sphere": {"center": [1.3, 0, 0.5]}, "material": {"shading": "phong", "specular": 0.5}}],
    "lights": [{"type": "directional", "position": [-1, -1, 1.4], "intensity": 0.9}, {"type": "head"}],
    "camera": {"azimuth": 15, "elevation": 30}, "frames": 4}


class Rendered(command.CommandTest):
    def render(self, output, *arguments, scene=SCENE, **more):
        return self.succeeds("render", self.scene(scene), "-o", output, *arguments, **more)

    def test_png(self):
        self.render("out.png")
        with Image.open(self.folder / "out.png") as picture:
            self.assertEqual((picture.size, picture.mode), ((64, 48), "RGB"))
            self.assertGreater(len(set(picture.getdata())), 100)

    def test_transparent_background(self):
        self.render("clear.png", "--background", "transparent", scene=command.box())
        with Image.open(self.folder / "clear.png") as picture:
            alpha = picture.getchannel("A")
            self.assertEqual((alpha.getpixel((0, 0)), alpha.getpixel((16, 12))), (0, 255))

    def test_exr_keeps_radiance_above_one(self):
        glow = {"size": [32, 24], "frames": 2, "background": "black", "lights": [],
                "camera": {"position": [0, 0, 5], "focal": [0, 0, 0]}}
        plane = {"plane": {"size": [50, 50]}, "material": {"color": "black"}}
        bright = {**plane, "material": {"color": "black", "emission": [5, 2, 0.5]}}
        self.render("dark.exr", scene={**glow, "objects": [plane]})
        for suffix, least, most in (("exr", 4.9, 5.1), ("png", 0.9, 1.0)):
            self.render(f"glow.{suffix}", scene={**glow, "objects": [bright]})
            measured = self.compare(f"glow.{suffix}", "dark.exr")
            self.assertTrue(least <= measured["maximum"] <= most, measured)
            self.assertEqual(measured["non-finite-pixels"], 0)

    def test_no_lamp_is_needed(self):
        """What glows lights surfaces, translucent ones and those of balls as beside a lamp that is dark."""
        objects = [
            {"plane": {"size": [4, 4]}, "material": {"color": [0.7, 0.7, 0.7]}},
            {"sphere": {"center": [0.6, 0, 0.4], "radius": 0.4}, "material": {"color": [0.3, 0.5, 0.8], "opacity": 0.5}},
            {"mesh": {"points": [[0, 1, 0.4]]}, "points-as-balls": True, "radius": 0.3, "material": {"shading": "phong"}},
            {"box": {"center": [-0.8, 0, 0.6], "size": [0.2, 1, 1.2]}, "material": {"color": "black", "emission": [3, 2, 1]}}]
        scene = {"size": [64, 48], "objects": objects, "background": [0, 0, 0], "camera": {"azimuth": 15, "elevation": 30}}
        dark = {"type": "directional", "position": [0, 0, -1], "intensity": 0}
        lit = ("--preset", "off", "--on", "ddgi", "--set", "ddgi.updates=4", "--frames", 6)
        for name, lights in (("none", []), ("dark", [dark])):
            self.succeeds("render", self.scene({**scene, "lights": lights}), *lit, "-o", f"{name}.exr")
        self.assertEqual(self.compare("none.exr", "dark.exr")["maximum"], 0)
        self.succeeds("render", self.scene({**scene, "lights": []}), "--preset", "off", "-o", "flat.exr")
        self.assertGreater(self.compare("none.exr", "flat.exr")["relmse"], 0.1, "VTK shows colours as they are")

    def test_environments_are_reflected_where_they_are_seen(self):
        """A mirror shows the part of the environment that is seen when looking along the reflected rays."""
        width, height = 64, 32
        texels = bytearray()
        for row in range(height):
            for column in range(width):
                turn = 2.0 * math.pi * (column + 0.5) / width
                rise = math.cos(math.pi * (row + 0.5) / height)
                color = (1.1 + math.cos(turn), 1.1 + math.sin(turn), 1.1 + rise)
                texels += bytes(int(64.0 * value) for value in color) + bytes([130])  # 256 is 4
        (self.folder / "sky.hdr").write_bytes(
            b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (height, width) + texels)
        mirror = {"plane": {"size": [1, 1]}, "material": {"shading": "pbr", "metallic": 1, "roughness": 0}}
        scene = {"size": [16, 16], "lights": [], "environment": {"file": "sky.hdr", "visible": True}}
        for name, position in (("mirror", [5, 1, 3]), ("sky", [5, 1, -3])):
            camera = {"position": position, "focal": [0, 0, 0], "angle": 3, "up": [0.1, 1, 0.2]}
            aside = [3, 0, 0] if name == "sky" else [0, 0, 0]
            objects = [{**mirror, "transform": {"translate": aside}}]
            # As many samples as average the lobe's tail, where sampling the sky takes over from sampling the mirror.
            self.succeeds("render", self.scene({**scene, "objects": objects, "camera": camera}),
                          "--preset", "reference", "--spp", 64, "-o", f"{name}.exr")
        measured = self.compare("mirror.exr", "sky.exr")
        self.assertLess(measured["maximum"], 0.15, measured)  # the mirror turns the picture round
        # Every preset has the visible environment in linear pictures.
        for preset in ("off", "balanced"):
            self.succeeds("render", "scene.json", "--preset", preset, "-o", "drawn.exr")
            self.assertLess(self.compare("drawn.exr", "sky.exr")["maximum"], 0.15, preset)

    def test_skies_light_the_scene(self):
        """A white ball vanishes in a uniform sky; other skies light it from where they say."""
        ball = {"sphere": {}, "material": {"color": [1, 1, 1]}}
        camera = {"position": [0, 0, 5], "focal": [0, 0, 0], "angle": 16}
        scene = {"size": [16, 16], "objects": [ball], "camera": camera, "lights": []}
        path = ("--preset", "reference", "--spp", 64)
        plain = {"sky": "uniform", "color": [0.5, 0.5, 0.5], "visible": True}
        self.succeeds("render", self.scene({**scene, "environment": plain}), *path, "-o", "ball.exr")
        away = {**ball, "transform": {"translate": [9, 0, 0]}}
        self.succeeds("render", self.scene({**scene, "objects": [away], "environment": plain}), *path, "-o", "sky.exr")
        difference = self.compare("ball.exr", "sky.exr")
        self.assertLess(abs(difference["signed-mean"]), 0.01, difference)
        self.assertLess(difference["relmse"], 0.02, difference)
        box = {"elevation": 0, "azimuth": -90, "width": 30, "height": 30, "radiance": 20, "softness": 0}
        pictures = {}
        for name, azimuth in (("left", -90), ("right", 90)):
            studio = {"sky": "gradient", "strength": 0.1, "follow-camera": True, "boxes": [{**box, "azimuth": azimuth}]}
            self.succeeds("render", self.scene({**scene, "environment": studio, "background": "black"}), *path,
                          "-o", f"{name}.png")
            with Image.open(self.folder / f"{name}.png") as picture:
                pictures[name] = (sum(picture.getpixel((5, 8))), sum(picture.getpixel((10, 8))))
        self.assertGreater(pictures["left"][0], pictures["left"][1] + 60)
        self.assertGreater(pictures["right"][1], pictures["right"][0] + 60)
        # The sun replaces the default lights.
        noon = {"sky": "daylight", "sun": {"latitude": 0, "longitude": 0, "time": "2026-03-20T12:00Z"}}
        for name, lights in (("sun", {}), ("none", {"lights": []}), ("more", {"lights": [{"type": "head"}]})):
            described = {"size": [16, 16], "objects": [ball], "environment": noon, **lights}
            self.succeeds("render", self.scene(described), "--preset", "off", "-o", f"{name}.png")
        self.assertEqual(self.compare("sun.png", "none.png")["maximum"], 0)
        self.assertGreater(self.compare("sun.png", "more.png")["maximum"], 0.1)

    def test_data_stands_upright_and_fills_the_picture(self):
        """Terrains stand along z whatever their format; shapes along y; results along z. Margins are five percent."""
        def mesh(name, point, arrays=""):
            side = 12
            points = [point(i / (side - 1), j / (side - 1)) for j in range(side) for i in range(side)]
            faces = [(j * side + i, j * side + i + 1, (j + 1) * side + i + 1, (j + 1) * side + i)
                     for j in range(side - 1) for i in range(side - 1)]
            flat = " ".join(str(value) for p in points for value in p)
            (self.folder / name).write_text(
                '<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>'
                f'<Piece NumberOfPoints="{len(points)}" NumberOfPolys="{len(faces)}"><PointData>{arrays}</PointData><Points>'
                f'<DataArray type="Float64" NumberOfComponents="3" format="ascii">{flat}</DataArray></Points><Polys>'
                f'<DataArray type="Int64" Name="connectivity" format="ascii">{" ".join(str(c) for f in faces for c in f)}</DataArray>'
                f'<DataArray type="Int64" Name="offsets" format="ascii">{" ".join(str(4 * i + 4) for i in range(len(faces)))}</DataArray>'
                '</Polys></Piece></PolyData></VTKFile>')
            return name

        def box_of(name):
            with Image.open(self.folder / name) as picture:
                return picture.convert("L").point(lambda value: 255 * (value > 0)).getbbox()
        hill = mesh("hill.vtp", lambda u, v: (u, v, 0.2 * math.sin(3 * u) * math.sin(3 * v)))
        upright = mesh("upright.vtp", lambda u, v: (u, 0.2 * math.sin(3 * u) * math.sin(3 * v), -v))
        heat = '<DataArray type="Float64" Name="heat" format="ascii">' + "0 " * 144 + "</DataArray>"
        pole = (lambda axis: lambda u, v: tuple([0.2 * math.cos(6.28 * u), 0.2 * math.sin(6.28 * u)][:axis] + [2 * v] +
                                                [0.2 * math.cos(6.28 * u), 0.2 * math.sin(6.28 * u)][axis:]))
        plain = ("--preset", "off", "--size", "160x120", "--frames", 1, "--background", "black", "--light", "head",
                 "--color", "white")
        for name, note, options, tall in ((hill, "stands along z", (), False), (upright, "stands along y", (), False),
                                          (mesh("shape.vtp", pole(1)), None, (), True),
                                          (mesh("result.vtp", pole(2), heat), "stands along z", (), True),
                                          (mesh("lying.vtp", pole(2)), None, ("--camera", "up=0,0,1"), True)):
            self.succeeds("render", name, *plain, *options, "-o", "up.png", notes=[note] if note else [])
            left, top, right, bottom = box_of("up.png")
            self.assertEqual(bottom - top > 2 * (right - left), tall, name)
            share = max((right - left) / 160, (bottom - top) / 120)
            self.assertTrue(0.88 <= share <= 0.94, f"{name}: {share}")
            # Perspective leaves the direction in which there is room a little off the middle.
            self.assertLess(abs(left - (160 - right)), 12, name)
            self.assertLess(abs(top - (120 - bottom)), 12, name)

    def test_pictures_of_normals(self):
        """Faces of any number of corners show them; what has no texture coordinates is told."""
        Image.new("RGB", (4, 4), (128, 128, 255)).save(self.folder / "even.png")
        matter = {"shading": "pbr", "roughness": 1, "ior": 1}
        quad = {"mesh": {"points": [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], "polygons": [[0, 1, 2, 3]],
                         "texture-coordinates": [[0, 0], [1, 0], [1, 1], [0, 1]]}}
        pentagon = {"mesh": {"points": [[-1, -1, 0], [1, -1, 0], [1, 0.5, 0], [0, 1, 0], [-1, 0.5, 0]],
                             "polygons": [[0, 1, 2, 3, 4]],
                             "texture-coordinates": [[0, 0], [1, 0], [1, 0.7], [0.5, 1], [0, 0.7]]}}
        ball = {"sphere": {}, "name": "ball"}
        (self.folder / "quad.obj").write_text("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                                              "f 1/1 2/2 3/3 4/4\n")
        for shape, notes in ((quad, ()), (pentagon, ()), ({"file": "quad.obj"}, ()), ({"plane": {}}, ()), ({"box": {}}, ()),
                             (ball, ("'ball' has no texture coordinates",))):
            for name, material in (("plain", matter), ("even", {**matter, "normal-texture": "even.png"})):
                scene = self.scene({"objects": [{**shape, "material": material}], "lights": [{"type": "head"}],
                                    "background": [0, 0, 0]})
                self.succeeds("render", scene, *command.TINY, "--preset", "off", "-o", f"{name}.exr",
                              notes=notes if name == "even" else ())
            self.assertLess(self.compare("even.exr", "plain.exr")["maximum"], 0.02, shape)

    def test_computed_tomography_shows_bone(self):
        """A ball of flesh in air with bone inside; in other units the air is what is told apart."""
        side = 12
        for name, shift, said in (("ct", 0, "isovalue 300 of 'MetaImage' (range -1000 to 1000: bone"), ("other", 1000, "isovalue 7.8")):
            values = array.array("h")
            for z, y, x in itertools.product(range(side), repeat=3):
                away = math.dist((x, y, z), (5.5, 5.5, 5.5))
                values.append(shift + (1000 if away < 2.5 else 40 if away < 5 else -1000))
            (self.folder / f"{name}.mha").write_bytes(
                f"ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nDimSize = {side} {side} {side}\n"
                "ElementType = MET_SHORT\nElementDataFile = LOCAL\n".encode() + values.tobytes())
            self.succeeds("render", self.folder / f"{name}.mha", "-o", f"{name}.png", "--size", "32x24", notes=[said])

    def test_stats(self):
        stats = json.loads(self.render("out.png", "--stats").stdout)
        self.assertEqual(stats["size"], [64, 48])
        self.assertEqual((stats["frames"], stats["accumulated-frames"]), (4, 4))
        self.assertGreater(stats["triangles"], 14)
        self.assertFalse(stats["stock"])
        self.assertEqual(stats["notes"], [])
        self.assertIn("shadow-maps", [row["name"] for row in stats["pass"]["passes"]])
        stock = json.loads(self.render("stock.png", "--stats", "--stock").stdout)
        self.assertTrue(stock["stock"])
        self.assertEqual(stock["triangles"], stats["triangles"])

    def test_frames_accumulate(self):
        counts = []
        for frames in (1, 16):
            ended = self.render(f"frames{frames}.png", "--frames", frames, "--stats")
            counts.append(json.loads(ended.stdout)["accumulated-frames"])
        self.assertEqual(counts, [1, 16])
        measured = self.compare("frames1.png", "frames16.png", "--min-ssim", 0.9)
        self.assertGreater(measured["maximum"], 0)

    def test_notes_of_the_techniques(self):
        lamps = [{"type": "point", "position": [x, 1, 3], "intensity": 0.2} for x in range(3)]
        scene = {**command.box(lights=lamps), "frames": 3}
        fewer = ("--set", "shadow-maps.maximum-lights=1", "--stats")
        says = "2 of 3 lights cast no shadow"
        ended = self.render("out.png", *fewer, scene=scene, notes=[says])
        notes = json.loads(ended.stdout)["notes"]
        self.assertEqual(len(notes), 1)
        self.assertIn(says, notes[0])
        self.render("out.png", *fewer, "--quiet", scene=scene)

    def test_lights_with_a_size(self):
        lamp = {"type": "point", "position": [1, 1, 3]}
        flat = ("--off", "ambient-occlusion")
        self.render("point.png", *flat, scene=command.box(lights=[lamp]))
        for shape in ({"radius": 1}, {"disc": 1}, {"rectangle": [3, 0.5], "turn": 20}):
            name = next(iter(shape))
            self.render(f"{name}.png", *flat, scene=command.box(lights=[{**lamp, **shape}]))
            self.assertGreater(self.compare("point.png", f"{name}.png")["p99"], 0.005, name)
        text = "point:1,1,3,rectangle=3,0.5,turn=20"
        self.render("line.png", *flat, "--light", text, scene=command.box(lights=[]))
        self.assertEqual(self.compare("rectangle.png", "line.png")["maximum"], 0)

    def test_techniques_change_the_picture(self):
        frames = ("--frames", "8")
        self.render("on.png", *frames)
        self.render("off.png", *frames, "--preset", "off")
        self.render("again.png", *frames, "--preset", "off", "--on", "shadow-maps", "--on", "ambient-occlusion",
                    "--on", "temporal-accumulation", "--on", "anti-aliasing", "--set", "ambient-occlusion.ambient-share=0.02")
        self.assertGreater(self.compare("on.png", "off.png")["p99"], 0.1)
        self.assertLess(self.compare("on.png", "again.png")["maximum"], 1.5 / 255)

    def test_backends_agree(self):
        self.needs("osmesa")
        for backend in ("egl", "osmesa"):
            ended = self.render(f"{backend}.png", "--backend", backend, "--stats")
            self.assertEqual(json.loads(ended.stdout)["opengl"]["backend"].lower(), backend)
        self.compare("egl.png", "osmesa.png", "--tolerance", 1, "--fail-over", 0)


class Looks(command.CommandTest):
    """One argument everywhere, and a default that a scene with light of its own does not get."""

    def look(self, scene, *arguments, **more):
        return self.report("render", self.scene(scene), *command.TINY, "-o", "out.png", "--stats", *arguments, **more)["look"]

    def test_which_look_is_taken(self):
        box = command.box()
        ended = self.penumbra("render", self.scene(box), "-o", "out.png")
        self.assertIn("penumbra: note: the look 'studio' lights the scene: --look as-is ", ended.stderr)
        self.assertEqual(self.look(box), "studio")
        self.assertEqual(self.look({**box, "look": "soft"}), "soft")
        self.assertEqual(self.look({**box, "look": "soft"}, "--look", "as-is"), "as-is")
        for own in ({"lights": []}, {"lights": [{"type": "head"}]}, {"techniques": {"preset": "off"}}):
            self.assertEqual(self.look({**box, **own}), "as-is")
        for plain in ("--stock", "--preset=off", "--light=head"):
            self.assertEqual(self.look(box, plain), "as-is")

    def test_looks_differ_and_a_background_comes_after_them(self):
        for look in ("as-is", "soft", "studio"):
            self.succeeds("render", self.scene(command.box()), *command.TINY, "--look", look, "-o", f"{look}.png")
        for one, other in itertools.combinations(("as-is", "soft", "studio"), 2):
            self.assertGreater(self.compare(f"{one}.png", f"{other}.png")["relmse"], 0.001)
        self.succeeds("render", self.scene(command.box()), *command.TINY, "--background", "#ff0000", "-o", "red.png")
        with Image.open(self.folder / "red.png") as picture:
            self.assertEqual(picture.getpixel((0, 0)), (255, 0, 0))

    def test_a_look_of_ones_own(self):
        (self.folder / "mine.json").write_text('{"description": "All green.", "background": [0, 1, 0]}')
        scene = {**command.box(), "look": "mine.json"}  # beside the scene file
        self.assertTrue(self.look(scene).endswith("mine.json"))
        with Image.open(self.folder / "out.png") as picture:
            self.assertEqual(picture.getpixel((0, 0)), (0, 255, 0))
        named = {"PENUMBRA_LOOK_PATH": str(self.folder)}
        self.assertRegex(self.succeeds("info", env=named).stdout, "look mine +All green")
        self.succeeds("render", self.scene(command.box()), *command.TINY, "--look", "mine", "-o", "out.png", env=named)

    def test_mistakes(self):
        box, tiny = self.scene(command.box()), command.TINY
        (self.folder / "bad.json").write_text('{"lights": [{"azimuth": 400}]}')
        self.refused("render", box, *tiny, "--look", "stduio", "-o", "a.png", says="there are as-is, ", status=2)
        self.refused("render", box, *tiny, "--look", "bad.json", "-o", "a.png", says="'azimuth' of light 1", status=2)
        self.refused("render", box, *tiny, "--look", "studio", "--light", "head", "-o", "a.png",
                     says="--look studio replaces the scene's light: give no --light with it", status=2)


class Traced(command.CommandTest):
    def trace(self, output, spp, *arguments, notes=()):
        scene = {key: value for key, value in SCENE.items() if key != "frames"}
        return json.loads(self.succeeds("render", self.scene(scene), "-o", output, "--preset", "reference",
                                        "--spp", spp, "--stats", *arguments, notes=notes).stdout)

    def test_samples(self):
        self.assertEqual(self.trace("four.exr", 4)["frames"], 4)
        header = (self.folder / "four.exr").read_bytes()[:2000]
        for layer in (b"albedo.R", b"normal.X", b"Z", b"samples", b"error"):
            self.assertIn(layer + b"\0", header)

    def test_denoises(self):
        self.trace("noisy.exr", 4)
        self.trace("smooth.exr", 4, "--denoise")
        self.trace("guided.exr", 4, "--denoise", "--set", "denoising.method=neural", notes=["network was compiled"])
        header = (self.folder / "smooth.exr").read_bytes()[:2000]
        for layer in (b"noisy.R", b"noisy.G", b"noisy.B"):
            self.assertIn(layer + b"\0", header)
        for one, other in (("noisy", "smooth"), ("noisy", "guided"), ("smooth", "guided")):
            ended = self.succeeds("compare", one + ".exr", other + ".exr", "--json")
            self.assertGreater(json.loads(ended.stdout)["maximum"], 0)
        self.refused("render", self.scene(SCENE), "-o", "out.png", "--denoise", says="--denoise is for the path tracer", status=2)

    def test_formats_without_layers(self):
        self.trace("plain.hdr", 4)
        self.trace("layers.exr", 4)
        self.succeeds("compare", "plain.hdr", "layers.exr", "--tolerance", 2, "--fail-over", 0.01)

    def test_ends_at_an_error(self):
        stats = self.trace("rough.exr", 1000, "--error", 0.2)
        self.assertLess(stats["frames"], 1000)
        self.assertGreaterEqual(stats["frames"], 8)

    def test_goes_on_from_a_checkpoint(self):
        self.trace("whole.exr", 8)
        self.assertEqual(self.trace("part.exr", 3, "--checkpoint", "kept.vti")["frames"], 3)
        self.assertEqual(self.trace("rest.exr", 8, "--checkpoint", "kept.vti")["frames"], 5)
        self.assertEqual(self.trace("again.exr", 8, "--checkpoint", "kept.vti")["frames"], 1)
        for resumed in ("rest.exr", "again.exr"):
            ended = self.succeeds("compare", "whole.exr", resumed, "--json")
            self.assertEqual(json.loads(ended.stdout)["maximum"], 0)

    def test_refuses_other_checkpoints(self):
        self.trace("part.exr", 1, "--checkpoint", "mine.vti")
        scene = self.scene({**SCENE, "size": [48, 48]})
        again = ("render", scene, "-o", "out.png", "--preset", "reference", "--spp", 1, "--checkpoint")
        self.refused(*again, "mine.vti", says="is of another picture", status=1)
        # As large, seen from the same place, and in another colour.
        repainted = {**SCENE, "background": [0.4, 0.1, 0.1]}
        del repainted["frames"]
        self.refused("render", self.scene(repainted), *again[2:], "mine.vti", says="is of another picture",
                     status=1)
        (self.folder / "text.vti").write_text("no checkpoint")
        self.refused(*again, "text.vti", says="is not a checkpoint", status=1)
        self.refused(*again, "none/new.vti", says="cannot be written", status=1)
        self.refused("render", scene, "-o", "out.png", "--checkpoint", "new.vti",
                     says="--checkpoint is for the path tracer", status=2)


class Info(command.CommandTest):
    def test_every_technique_is_in_every_table(self):
        info = json.loads(self.succeeds("info", "--json").stdout)
        names = [technique["name"] for technique in info["techniques"]]
        self.assertLessEqual({"shadow-maps", "ambient-occlusion", "anti-aliasing"}, set(names))
        self.assertGreater(len(info["opengl"]["version"]), 0)
        parameters = json.loads(self.succeeds("info", "--json", "--parameters").stdout)["techniques"]
        for arguments in ((), ("--parameters",), ("--markdown",), ("--markdown", "--parameters")):
            table = self.succeeds("info", *arguments).stdout
            for technique in parameters:
                self.assertIn(technique["name"], table)
                for parameter in technique["parameters"] if "--parameters" in arguments else ():
                    self.assertIn(parameter["name"], table)

    def test_markdown_needs_no_opengl(self):
        nowhere = {"__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent", "PENUMBRA_BACKEND": "egl"}
        self.assertIn("shadow-maps", self.succeeds("info", "--markdown", env=nowhere).stdout)

    def test_version_and_help(self):
        self.assertRegex(self.succeeds("--version").stdout, r"^penumbra \d+\.\d+\.\d+\n$")
        for name in ("render", "info", "compare"):
            self.assertIn(name, self.succeeds("--help").stdout)
            self.assertIn("Examples:", self.succeeds(name, "--help").stdout)


class Compared(command.CommandTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        ramp = Image.new("RGB", (40, 30))
        ramp.putdata([(5 * x, 5 * x, 100) for _ in range(30) for x in range(40)])
        ramp.save(cls.folder / "ramp.png")
        ramp.save(cls.folder / "same.tif")
        spot = ramp.copy()
        for x in range(4):  # 12 of 1200 pixels are off, by 50 in one channel
            for y in range(3):
                spot.putpixel((20 + x, 10 + y), (100 + 5 * x + 50, 100 + 5 * x, 100))
        spot.save(cls.folder / "spot.png")

    def test_identical(self):
        ended = self.succeeds("compare", "ramp.png", "same.tif", "--json", "--max-relmse", 0,
                              "--min-ssim", 0.999999, "--fail-over", 0, "--tolerance", 0)
        measured = json.loads(ended.stdout)
        self.assertEqual((measured["relmse"], measured["maximum"], measured["signed-mean"]), (0, 0, 0))

    def test_different(self):
        measured = json.loads(self.succeeds("compare", "spot.png", "ramp.png", "--json").stdout)
        self.assertAlmostEqual(measured["maximum"], 50 / 255, 4)
        self.assertTrue(0 < measured["flip-mean"] < measured["flip-p95"] < 1)
        from_afar = json.loads(self.succeeds("compare", "spot.png", "ramp.png", "--json", "--pixels-per-degree", 300).stdout)
        self.assertNotAlmostEqual(from_afar["flip-mean"], measured["flip-mean"], 4)
        self.assertAlmostEqual(measured["fraction-over"], 0.01, 6)
        self.assertAlmostEqual(measured["signed-mean"], 0.01 * 0.2126 * 50 / 255, 6)
        self.assertLess(measured["ssim"], 1)

    def test_limits(self):
        pair = ("compare", "spot.png", "ramp.png")
        self.succeeds(*pair, "--fail-over", 0.011, "--max-relmse", 1, "--min-ssim", 0.5)
        self.succeeds(*pair, "--fail-over", 0, "--tolerance", 50.5)
        for limit in (("--fail-over", 0.009), ("--max-relmse", 1e-9), ("--min-ssim", 0.9999999), ("--max-flip", 0.0001)):
            with self.subTest(limit):
                self.refused(*pair, *limit, says="'spot.png' is too far from 'ramp.png'", status=1)

    def test_difference_picture(self):
        self.succeeds("compare", "spot.png", "ramp.png", "--diff", "diff.png", "--diff-gain", 2)
        with Image.open(self.folder / "diff.png") as picture:
            self.assertEqual(picture.convert("RGB").getpixel((21, 11)), (100, 0, 0))
            self.assertEqual(picture.convert("RGB").getpixel((0, 0)), (0, 0, 0))

    def test_flip_picture(self):
        self.succeeds("compare", "spot.png", "ramp.png", "--flip", "flip.png")
        with Image.open(self.folder / "flip.png") as picture:
            seen = picture.convert("RGB")
            self.assertGreater(seen.getpixel((21, 11))[0], 50)
            self.assertEqual(seen.getpixel((0, 29)), (0, 0, 0))
        self.refused("compare", "spot.png", "ramp.png", "--flip", "flip.xyz", says="flip.xyz", status=2)


if __name__ == "__main__":
    unittest.main()
