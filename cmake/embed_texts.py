#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Write files to a C++ source with a function that returns a table of their names and texts.

usage: embed_texts.py OUTPUT.cxx HEADER FUNCTION FOLDER FILE...

Names are relative to a folder of this name; there may be several, such as one with generated files.
"""
import pathlib
import sys


def relative(path, folder):
    """The path below the innermost folder of this name."""
    return "/".join(path.parts[len(path.parts) - path.parts[::-1].index(folder):])


def main():
    output, header, function, folder = pathlib.Path(sys.argv[1]), *sys.argv[2:5]
    rows = []
    for path in map(pathlib.Path, sys.argv[5:]):
        text = path.read_text()
        # Compilers limit the length of a string literal, but concatenate adjacent ones.
        pieces = "".join(f'R"text({text[i:i + 8000]})text"\n' for i in range(0, len(text), 8000))
        rows.append(f'    {{ "{relative(path, folder)}",\n{pieces} }},')
    output.write_text(
        f"// Generated from {folder}/: edit its files instead.\n#include \"{header}\"\n\n"
        f"namespace penumbra\n{{\nconst std::map<std::string, const char*>& {function}()\n{{\n"
        "  static const std::map<std::string, const char*> texts = {\n" + "\n".join(rows) +
        "\n  };\n  return texts;\n}\n}\n")


main()
