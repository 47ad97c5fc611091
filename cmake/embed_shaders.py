#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Write the shaders of a folder to a C++ source with a table of their names and texts.

usage: embed_shaders.py OUTPUT.cxx ROOT FILE...
"""
import pathlib
import sys


def main():
    output, root = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    rows = []
    for path in map(pathlib.Path, sys.argv[3:]):
        text = path.read_text()
        # Compilers limit the length of a string literal, but concatenate adjacent ones.
        pieces = "".join(f'R"glsl({text[i:i + 8000]})glsl"\n' for i in range(0, len(text), 8000))
        rows.append(f'    {{ "{path.relative_to(root).as_posix()}",\n{pieces} }},')
    output.write_text(
        "// Generated from glsl/: edit the shaders instead.\n#include \"gpu/ShaderLibrary.h\"\n\n"
        "namespace penumbra\n{\nconst std::map<std::string, const char*>& EmbeddedShaders()\n{\n"
        "  static const std::map<std::string, const char*> shaders = {\n" + "\n".join(rows) +
        "\n  };\n  return shaders;\n}\n}\n")


main()
