#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Write the files of a folder to a C++ source with a function that returns a table of their names and texts.

usage: embed_texts.py OUTPUT.cxx HEADER FUNCTION ROOT FILE...
"""
import pathlib
import sys


def main():
    output, header, function, root = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3], pathlib.Path(sys.argv[4])
    rows = []
    for path in map(pathlib.Path, sys.argv[5:]):
        text = path.read_text()
        # Compilers limit the length of a string literal, but concatenate adjacent ones.
        pieces = "".join(f'R"text({text[i:i + 8000]})text"\n' for i in range(0, len(text), 8000))
        rows.append(f'    {{ "{path.relative_to(root).as_posix()}",\n{pieces} }},')
    output.write_text(
        f"// Generated from {root.name}/: edit its files instead.\n#include \"{header}\"\n\n"
        f"namespace penumbra\n{{\nconst std::map<std::string, const char*>& {function}()\n{{\n"
        "  static const std::map<std::string, const char*> texts = {\n" + "\n".join(rows) +
        "\n  };\n  return texts;\n}\n}\n")


main()
