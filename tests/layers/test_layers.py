#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Includes of the module and of the command go down only: each room includes its own headers and those of rooms below."""
import pathlib
import re
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Rooms from bottom to top. Subfolders of a room belong to it. Rooms in one tuple do not include each other.
MODULE = (("base", "budget", "instrument"), ("gpu",), ("graph", "headless"), ("rays",), ("capture",), ("light",), ("technique", "sky"), ("pass",),
          ("bake",), ("probes", "shadows"), ("techniques/*",), ("looks",))
TOOL = (("common",), ("image",), ("scene/model",), ("scene/readers",), ("scene/build",), ("scene/file",),
        ("bake/*",), ("console",), ("commands",))
MOST_FILES = 30  # per folder

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)


def sources(folder):
    return sorted(path for path in folder.rglob("*") if path.suffix in (".h", ".cxx"))


def rooms(folder, layers):
    """The level of each room. "name/*" stands for all folders in name."""
    found = {}
    for level, names in enumerate(layers):
        for name in names:
            paths = folder.glob(name) if "*" in name else [folder / name]
            found.update({path.relative_to(folder).as_posix(): level for path in paths if path.is_dir()})
    return found


def room_of(path, levels):
    """The room of a file; "" for a file in the top folder or in no room."""
    room = path.parent
    while room.as_posix() not in (".", *levels):
        room = room.parent
    return "" if room.as_posix() == "." else room.as_posix()


def violations(folder, layers):
    levels = rooms(folder, layers)
    files = {path.relative_to(folder) for path in sources(folder)}
    by_name = {path.name: path for path in files}  # headers of VTK classes are included without their folder
    found = []
    for path in sorted(files):
        room = room_of(path, levels)
        if not room and len(path.parts) > 1:
            found.append(f"{path} is in no room")
        for name in INCLUDE.findall((folder / path).read_text()):
            target = pathlib.Path(name)
            if ".." in target.parts:
                found.append(f"{path} includes {name}: name the room instead")
            if target not in files:
                target = by_name.get(name) if name.startswith("vtk") else None
            if not target or not room:
                continue
            other = room_of(target, levels)
            if other and other != room and levels[other] >= levels[room]:
                found.append(f"{path} includes {name}: {room} is not above {other}")
    return found


GL_CALL = re.compile(r"\bgl(?:Program)?Uniform\w*\(|\bgl(?:BindImageTexture|DispatchCompute|MemoryBarrier)\w*\(")


def undeclared(folder):
    """OpenGL calls that set shader inputs, dispatch or set barriers outside the rooms that do so for all passes."""
    return [f"{path.relative_to(folder)}: {call}" for path in sources(folder)
            if path.relative_to(folder).parts[0] not in ("gpu", "graph") for call in GL_CALL.findall(path.read_text())]


class Layers(unittest.TestCase):
    def test_the_module(self):
        self.assertEqual(violations(ROOT / "vtk_module", MODULE), [])

    def test_the_command(self):
        self.assertEqual(violations(ROOT / "tool", TOOL), [])

    def test_shader_inputs_and_dispatches_are_declared(self):
        self.assertEqual(undeclared(ROOT / "vtk_module"), [])
        with tempfile.TemporaryDirectory() as name:
            for room in ("gpu", "light"):
                folder = pathlib.Path(name) / room
                folder.mkdir()
                (folder / "A.cxx").write_text("glUniform3fv(1);\nglProgramUniform1i(2);\nglDispatchCompute(3);\n"
                                              "glMemoryBarrier(4);\nglGetUniformLocation(5);\n")
            self.assertEqual(undeclared(pathlib.Path(name)), [
                "light/A.cxx: glUniform3fv(", "light/A.cxx: glProgramUniform1i(",
                "light/A.cxx: glDispatchCompute(", "light/A.cxx: glMemoryBarrier("])

    def test_no_folder_has_too_many_files(self):
        for top in ("vtk_module", "tool"):
            for folder in (ROOT / top, *(path for path in (ROOT / top).rglob("*") if path.is_dir())):
                count = sum(path.is_file() for path in folder.iterdir())
                self.assertLessEqual(count, MOST_FILES, folder.relative_to(ROOT).as_posix())

    def test_upward_includes_are_found(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for path, text in (("gpu/Texture.h", '#include "pass/Frame.h"\n'), ("pass/Frame.h", ""),
                               ("pass/vtkPass.h", ""), ("gpu/Buffer.cxx", '#include "vtkPass.h"\n'),
                               ("techniques/a/A.h", '#include "techniques/b/B.h"\n'), ("techniques/b/B.h", ""),
                               ("pass/Pass.cxx", '#include "gpu/Texture.h"\n'), ("attic/Old.h", "")):
                (folder / path).parent.mkdir(parents=True, exist_ok=True)
                (folder / path).write_text(text)
            self.assertEqual(violations(folder, MODULE), [
                "attic/Old.h is in no room",
                "gpu/Buffer.cxx includes vtkPass.h: gpu is not above pass",
                "gpu/Texture.h includes pass/Frame.h: gpu is not above pass",
                "techniques/a/A.h includes techniques/b/B.h: techniques/a is not above techniques/b"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
