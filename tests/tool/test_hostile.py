# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""What cannot be done ends in one sentence that names the thing, and never in a signal."""
import json
import os
import struct
import unittest

import numpy as np

import command
import seeds

TINY = command.TINY


def mesh(points, polygons, **more):
    return {"size": [32, 24], "frames": 1,
            "objects": [{"name": "piece", "mesh": {"points": points, "polygons": polygons, **more}}]}


def write_polydata(path, points, triangles):
    """Without VTK's own writer, which would not write a corner that does not exist."""
    arrays = [np.asarray(points, "<f4"), np.asarray(triangles, "<i8"),
              3 * np.arange(1, len(triangles) + 1, dtype="<i8")]
    blocks = [struct.pack("<Q", array.nbytes) + array.tobytes() for array in arrays]
    starts = np.cumsum([0] + [len(block) for block in blocks])
    head = f"""<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<PolyData><Piece NumberOfPoints="{len(points)}" NumberOfPolys="{len(triangles)}"><Points>
<DataArray type="Float32" NumberOfComponents="3" format="appended" offset="{starts[0]}"/></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="appended" offset="{starts[1]}"/>
<DataArray type="Int64" Name="offsets" format="appended" offset="{starts[2]}"/></Polys>
</Piece></PolyData><AppendedData encoding="raw">
_"""
    path.write_bytes(head.encode() + b"".join(blocks) + b"\n</AppendedData></VTKFile>\n")


CORNERS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)]
NAN = (np.nan,) * 3


class Hostile(command.CommandTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / "good").mkdir()
        cls.good = seeds.make(cls.folder / "good")
        (cls.folder / "box.json").write_text(json.dumps(command.box()))

    def file(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return name

    def polydata(self, name, points, triangles):
        write_polydata(self.folder / name, points, triangles)
        return name

    def render_refused(self, source, *arguments, says, output="out.png", **more):
        picture = self.folder / output
        if picture.is_file():
            picture.unlink()  # of a test that failed
        ended = self.refused("render", source, "-o", output, *TINY, *arguments, says=says, **more)
        self.assertFalse(picture.is_file(), "a picture was left behind")
        return ended

    def render(self, source, *arguments, **more):
        ended = self.succeeds("render", source, "-o", "out.png", *TINY, *arguments, **more)
        (self.folder / "out.png").unlink()
        return ended

    def wrong_use(self, *arguments, says):
        self.render_refused("box.json", *arguments, says=says, status=2)


class Files(Hostile):
    def test_empty(self):
        for name in sorted({"".join(path.suffixes) for path in self.good}) + [".json"]:
            with self.subTest(name):
                self.render_refused(self.file(f"empty{name}", b""), says=f"empty{name}")

    def test_truncated(self):
        for path in self.good:
            content = path.read_bytes()
            half = len(content) // 2
            if path.suffix == ".pdb":  # whole lines would be a smaller molecule: cut one
                half = content.index(b"\n", half) - 50
            with self.subTest(path.name):
                name = self.file(f"cut_{path.name}", content[:half])
                self.render_refused(name, says=name)

    def test_of_another_kind(self):
        for path in self.good:
            with self.subTest(path.name):
                name = self.file(f"noise_{path.name}", bytes(range(256)) * 8)
                self.render_refused(name, says=name)

    def test_without_end(self):
        for name in ("/dev/zero", "/dev/null"):
            self.render_refused(name, says=name)

    def test_missing_or_no_file(self):
        self.render_refused("absent.vtp", says="absent.vtp")
        (self.folder / "folder.vtp").mkdir()
        self.render_refused("folder.vtp", says="folder.vtp")
        self.render_refused(self.file("a.xyz", "1 2 3"), says="a.xyz")

    def test_no_triangles(self):
        self.render_refused(self.polydata("points.vtp", CORNERS, []), says="points.vtp")
        self.render_refused(self.polydata("nothing.vtp", [], []), says="nothing.vtp")
        self.render_refused(self.scene(mesh([], [])), says="piece")

    def test_one_triangle(self):
        self.render(self.polydata("one.vtp", CORNERS, [(0, 1, 2)]))
        self.render(self.scene(mesh(CORNERS, [[0, 1, 2]])))

    def test_triangle_without_area(self):
        self.render(self.polydata("line.vtp", [(0, 0, 0)] * 3, [(0, 1, 2)]))

    def test_points_that_are_nan(self):
        self.render(self.polydata("some.vtp", [*CORNERS, NAN], [(0, 1, 2), (1, 3, 4)]),
                    notes=["'some.vtp': left out 1 points that are not finite and 1 cells"])
        self.render_refused(
            self.polydata("all.vtp", [NAN] * 3, [(0, 1, 2)]), says="all.vtp")

    def test_points_far_away_or_absent(self):
        self.render(self.polydata("far.vtp", [*CORNERS, (1e30, 0, 0)], [(0, 1, 2), (1, 3, 4)]),
                    notes=["'far.vtp': left out 1 points"])
        for corner in (77, 10 ** 12):  # the second is far from the memory of the points
            self.render_refused(
                self.polydata("outside.vtp", CORNERS, [(0, 1, corner)]), says="outside.vtp")
        self.render_refused(self.scene(mesh(CORNERS, [[0, 1, 77]])), says="77", status=2)

    def test_heights_that_are_nan(self):
        heights = np.zeros((6, 6), "f4")
        heights[2, 3] = np.nan
        np.save(self.folder / "hole.npy", heights)
        self.render("hole.npy", notes=["'hole.npy': left out 1 points"])
        np.save(self.folder / "void.npy", np.full((6, 6), np.nan, "f4"))
        self.render_refused("void.npy", says="void.npy")

    def test_more_than_ten_million_triangles(self):
        np.save(self.folder / "wide.npy", np.zeros((2300, 2300), "u1"))
        self.render_refused("wide.npy", says="'wide.npy' brings the scene to 10570802 triangles "
                            "and the limit is 10000000")
        # The same where it shows only after points were left out.
        heights = np.zeros((20, 20), "f4")
        heights[2, 3] = np.nan
        np.save(self.folder / "hole.npy", heights)
        self.render_refused("hole.npy", "--max-triangles", 500, says="714 triangles")
        self.render("hole.npy", "--max-triangles", 714, notes=["left out"])


class Wishes(Hostile):
    def test_unknown_names_are_named_with_the_nearest(self):
        for arguments, says in (
                (("--on", "shadow-mapz"), "'shadow-mapz': did you mean 'shadow-maps'"),
                (("--off", "nonsense"), "'nonsense'"),
                (("--set", "shadow-mapz.resolution=512"), "'shadow-mapz'"),
                (("--set", "shadow-maps.resolutoin=512"), "did you mean 'resolution'"),
                (("--preset", "hihg"), "did you mean 'high'"),
                (("--backend", "elg"), "did you mean 'egl'"),
                (("--light", "kei"), "did you mean 'key'"),
                (("--light", "key:azimut=3"), "did you mean 'azimuth'"),
                (("--camera", "zom=2"), "did you mean 'zoom'"),
                (("--isoval", "3"), "did you mean '--isovalue'"),
                (("--color", "blurple"), "blurple"),
                (("--background", "blurple"), "blurple")):
            with self.subTest(arguments):
                self.wrong_use(*arguments, says=says)

    def test_values_out_of_range(self):
        for arguments, says in (
                (("--set", "shadow-maps.resolution=3"), "shadow-maps.resolution cannot be 3"),
                (("--set", "shadow-maps.resolution=1e99"), "shadow-maps.resolution"),
                (("--set", "shadow-maps.filter-radius=nan"), "shadow-maps.filter-radius"),
                (("--set", "shadow-maps.filter-radius=abc"), "'abc'"),
                (("--set", "shadow-maps"), "'shadow-maps'"),
                (("--opacity", "2"), "--opacity is 2"),
                (("--smooth", "-1"), "--smooth is -1"),
                (("--light", "point:1,2"), "position"),
                (("--light", "cone:angle=90"), "angle"),
                (("--light", "key:angle=91"), "angle"),
                (("--light", "directional:radius=1"), "type point or cone"),
                (("--light", "point:radius=1,disc=1"), "one of 'radius', 'disc' and 'rectangle'"),
                (("--light", "point:disc=-1"), "disc"),
                (("--light", "point:rectangle=1,-1"), "a width and a height"),
                (("--camera", "zoom=0"), "zoom"),
                (("--camera", "angle=nan"), "angle"),
                (("--max-triangles", "0"), "--max-triangles is 0")):
            with self.subTest(arguments):
                self.wrong_use(*arguments, says=says)
        for size in ("0x5", "5", "99999x2", "-3x4", "axb", ""):
            with self.subTest(size=size):
                self.refused("render", "box.json", "-o", "out.png", "--size", size, says="--size")
        for frames in ("0", "-1", "70000", "many"):
            with self.subTest(frames=frames):
                self.refused("render", "box.json", "-o", "out.png", "--frames", frames, says="--frames")

    def test_pictures_too_big(self):
        self.refused("render", "box.json", "-o", "out.png", "--size", "32768x32768", says="too big")
        self.assertFalse((self.folder / "out.png").exists())

    def test_arrays_and_isovalues(self):
        good = self.folder / "good"
        self.render_refused(good / "a.vtp", "--color-by", "Elevatoin", says="did you mean 'Elevation'")
        self.render_refused(good / "a.vtp", "--color-by", "Elevation", "--color-range", "2,1",
                            says="--color-range")
        self.render_refused(good / "a.vti", "--isovalue", "1e9", says="1e+09")
        self.render_refused("box.json", "--env", "absent.hdr", says="absent.hdr")

    def test_scene_files(self):
        for described, says in (
                ({"objects": []}, "objects"), ({}, "objects"), ([], "scene"), (7, "scene"),
                ({**command.box(), "lihgts": []}, "did you mean 'lights'"),
                (command.box(size=[0, 5]), "size"), (command.box(frames=0), "frames"),
                (command.box(techniques={"on": ["nonsense"]}), "nonsense"),
                ({"objects": [{"sphere": {"radios": 1}}]}, "did you mean 'radius'"),
                ({"objects": [{"sphere": {"radius": -1}}]}, "radius"),
                ({"objects": [{"sphere": {"resolution": 10 ** 9}}]}, "resolution"),
                ({"objects": [{"file": "absent.vtp"}]}, "absent.vtp"),
                (command.box(environment={}), "'file' and 'sky'"),
                (command.box(environment={"sky": "daylihgt"}), "did you mean 'daylight'"),
                (command.box(environment={"sky": "uniform", "zenith": "red"}), "'zenith'"),
                (command.box(environment={"sky": "daylight", "turbidity": 0}), "at least 1"),
                (command.box(environment={"sky": "daylight", "sun": {"time": "2026-06-21T12:00Z"}}), "together"),
                (command.box(environment={"sky": "daylight", "sun": {"latitude": 0, "longitude": 0, "time": "noon"}}),
                 "'noon'"),
                (command.box(environment={"sky": "uniform", "boxes": [{"width": 0}]}), "'width' of box 1"),
                ({"objects": [{"box": {}, "material": {"opacity": "thick"}}]}, "opacity")):
            with self.subTest(says):
                self.render_refused(self.scene(described), says=says)
        self.render_refused(self.file("broken.json", '{"objects": [{'), says="broken.json")
        self.render_refused(self.file("deep.json", "[" * 100000), says="deep.json")

    def test_wrong_use(self):
        for arguments in ((), ("rendr",), ("render",), ("render", "box.json"), ("compare",),
                          ("compare", "a.png"), ("info", "extra"), ("info", "--json", "--markdown"),
                          ("info", "--backend", "elg")):
            with self.subTest(arguments):
                self.refused(*arguments, says="", status=2)


class Outputs(Hostile):
    def test_unwritable(self):
        (self.folder / "taken.png").mkdir(exist_ok=True)
        for output in ("absent/out.png", "/proc/out.png", "taken.png"):
            with self.subTest(output):
                self.render_refused("box.json", says=output, output=output)
        self.render_refused("box.json", says="out.xyz", output="out.xyz", status=2)
        self.refused("render", "box.json", "-o", "", *TINY, says="after '-o' is empty", status=2)

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs a device that is always full")
    def test_full_disk(self):
        for name in ("full.png", "full.exr", "full.jpg", "full.tif"):
            os.symlink("/dev/full", self.folder / name)
            with self.subTest(name):
                self.refused("render", "box.json", "-o", name, *TINY, says=name, status=1)
                self.assertTrue((self.folder / name).is_symlink())


class Compared(Hostile):
    def test_pictures_that_cannot_be_compared(self):
        good = self.folder / "good" / "a.png"
        content = good.read_bytes()
        self.file("cut.png", content[:len(content) // 2])
        self.file("empty.png", b"")
        self.file("noise.png", bytes(range(256)))
        self.file("noise.exr", b"\x76\x2f\x31\x01" + bytes(range(256)))
        self.succeeds("render", "box.json", "-o", "box.png", *TINY)
        for name in ("cut.png", "empty.png", "noise.png", "noise.exr", "absent.png", ".", "box.png"):
            with self.subTest(name):
                self.refused("compare", good, name, says=f"'{name}'", status=1)
                self.refused("compare", name, good, says=f"'{name}'", status=1)

    def test_wishes(self):
        good = self.folder / "good" / "a.png"
        self.refused("compare", good, good, "--diff", "absent/d.png", says="absent/d.png", status=1)
        self.refused("compare", good, good, "--max-relms", "1", says="did you mean '--max-relmse'")
        for option in ("--epsilon", "--tolerance", "--diff-gain"):
            self.refused("compare", good, good, option, "-1", says=option, status=2)


class Graphics(Hostile):
    def without(self, backend, says, **env):
        self.render_refused("box.json", "--backend", backend, says=says, env=env)
        self.refused("info", "--backend", backend, says=says, env=env, status=1)
        ended = self.refused("info", "--json", "--backend", backend, says=says, env=env)
        self.assertIsNone(json.loads(ended.stdout)["opengl"])

    def test_no_opengl(self):
        self.without("egl", "OpenGL", __EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent")

    def test_opengl_too_old(self):
        self.needs("osmesa")
        self.without("osmesa", "4.3", MESA_GL_VERSION_OVERRIDE="3.0")

    def test_no_display(self):
        self.without("x11", "DISPLAY", DISPLAY=None)
        # VTK ends the process here, so that the rest of the information is lost.
        self.render_refused("box.json", "--backend", "x11", says="x11", env={"DISPLAY": ":98765"})

    def test_unknown_backend_in_the_environment(self):
        self.render_refused("box.json", says="'elg'", env={"PENUMBRA_BACKEND": "elg"})

    def test_shaders_that_do_not_compile(self):
        folder = self.folder / "shaders" / "direct_light"
        folder.mkdir(parents=True)
        for broken in ("this is no shader\n", "", "#version 430\n#include \"absent.glsl\"\n"):
            (folder / "resolve.frag").write_text(broken)
            for output in ("out.png", "out.exr"):
                with self.subTest(broken, output=output):
                    self.render_refused("box.json", says="resolve.frag", output=output,
                                        env={"PENUMBRA_SHADER_PATH": str(folder.parent)}, status=1)


if __name__ == "__main__":
    unittest.main()
