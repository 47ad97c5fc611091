#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Write the shaders of the denoiser's network, whose weights are literals, and a C++ source with its layers and weights.

usage: export.py NETWORK.txt FOLDER SOURCE.cxx

A shader computes a part of a layer that is small enough for compilers: FOLDER/LAYER_PART.comp, which includes
denoising/layer.glsl. FOLDER/fine.glsl has the layers that see single pixels. The build calls this.
"""
import pathlib
import sys

import weights

LARGEST = 6000  # multiplications of a shader for each texel
ABOVE = {"d0": "e3", "d1": "d0", "d2": "d1"}  # layers that are joined, at half the size
ORIGIN = "// Generated from glsl/denoising/network.txt."


def number(value):
    """A literal."""
    text = f"{value:.7g}"
    return text if "." in text or "e" in text else text + ".0"


def literal(kind, values):
    """A vector or a matrix."""
    return f"{kind}({', '.join(map(number, values))})"


def matrix(layer, target, source, tap):
    """Weights of four outputs for four inputs, by input."""
    return [layer.values[((4 * target + row) * layer.inputs + 4 * source + column) * layer.kernel ** 2 + tap]
            for column in range(4) for row in range(4)]


def biases(layer, target):
    """Biases of four outputs."""
    first = layer.weight_count() + 4 * target
    return layer.values[first:first + 4]


def parts(layer):
    """Ranges of the outputs, in fours, that each shader computes."""
    fours = layer.outputs // 4
    most = max(1, LARGEST // (4 * layer.inputs * layer.kernel ** 2))
    count = -(-fours // most)
    ends = [fours * i // count for i in range(count + 1)]
    return list(zip(ends, ends[1:]))


def shader(layer, above, rectified, first, last):
    """Text of the shader of a part. above: the joined layer, or None. rectified: whether sums below 0 become 0."""
    joined = [f"#define GI_ABOVE {above.outputs // 4}"] if above else []
    ends = [] if rectified else ["#define GI_LAST 1"]
    lines = ["#version 430 core", ORIGIN, f"#define GI_INPUTS {layer.inputs // 4}", f"#define GI_OUTPUTS {last - first}",
             f"#define GI_FIRST {first}", *joined, *ends, '#include "denoising/layer.glsl"', "#ifndef GI_WEIGHTS_BUFFER",
             "void giSums(ivec2 at, inout vec4 sums[GI_OUTPUTS])", "{"]
    targets = range(first, last)
    lines += [f"  sums[{target - first}] = {literal('vec4', biases(layer, target))};" for target in targets]
    lines.append("  vec4 v;")
    for tap in range(9):
        for source in range(layer.inputs // 4):
            lines.append(f"  v = giActivation(at + ivec2({tap % 3 - 1}, {tap // 3 - 1}), {source});")
            lines += [f"  sums[{target - first}] += {literal('mat4', matrix(layer, target, source, tap))} * v;"
                      for target in targets]
    return "\n".join(lines + ["}", "#endif", ""])


def products(layer, target, values):
    """Four outputs of a layer of single pixels for an array of this name."""
    return " +\n    ".join(f"{literal('mat4', matrix(layer, target, source, 0))} * {values}[{source}]"
                           for source in range(layer.inputs // 4))


def fine(first, last):
    """Text of the functions of the layers that see single pixels: hidden activations, and what they add to the outputs."""
    fours, hidden, outputs = first.inputs // 4, first.outputs // 4, last.outputs // 4
    lines = [ORIGIN, f"#define GI_FINE {hidden}", f"void giFine(vec4 v[{fours}], out vec4 hidden[{hidden}])", "{"]
    lines += [f"  hidden[{target}] = max({products(first, target, 'v')}, 0.0);" for target in range(hidden)]
    lines += ["}", f"void giAddFine(vec4 hidden[{hidden}], inout vec4 sums[{outputs}])", "{"]
    lines += [f"  sums[{target}] += {products(last, target, 'hidden')};" for target in range(outputs)]
    return "\n".join(lines + ["}", ""])


def part_values(layer, first, last):
    """Values of a part in the order of the block in denoising/layer.glsl."""
    values = [value for target in range(first, last) for value in biases(layer, target)]
    for tap in range(9):
        for source in range(layer.inputs // 4):
            for target in range(first, last):
                values += matrix(layer, target, source, tap)
    return values


def rows(values):
    """Values of a C++ array."""
    texts = [number(value) + "f" for value in values]
    return ",\n      ".join(", ".join(texts[i:i + 8]) for i in range(0, len(texts), 8))


def table(layers):
    """Text of the C++ source."""
    lines = [ORIGIN, '#include "techniques/denoising/NetworkWeights.h"', "", "namespace penumbra", "{",
             "const std::map<std::string, NetworkLayer>& NetworkLayers()", "{",
             "  static const std::map<std::string, NetworkLayer> layers = {"]
    for name, layer in layers.items():
        shares = parts(layer) if layer.kernel > 1 else []
        pieces = [f"      {{ {rows(part_values(layer, first, last))} }}" for first, last in shares]
        lines.append(f'    {{ "{name}", {{ {layer.inputs}, {layer.outputs}, {{\n' + ",\n".join(pieces) + " } } },")
    return "\n".join(lines + ["  };", "  return layers;", "}", "}", ""])


def write(path, text):
    """Write a file unless it has this text already, so that a build does not compile it again."""
    if not path.exists() or path.read_text(encoding="ascii") != text:
        path.write_text(text, encoding="ascii")


def main():
    """Write the files, and remove those of another network."""
    network, folder, output = map(pathlib.Path, sys.argv[1:])
    try:
        _, layers = weights.read(network)
    except (OSError, ValueError) as error:
        sys.exit(str(error))
    texts = {"fine.glsl": fine(layers["fine"], layers["fine_out"])}
    for name, layer in layers.items():
        if layer.kernel == 1:
            continue
        for index, (first, last) in enumerate(parts(layer)):
            texts[f"{name}_{index}.comp"] = shader(layer, layers.get(ABOVE.get(name)), name != "out", first, last)
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*"):
        if old.name not in texts and ORIGIN in old.read_text(encoding="utf-8"):
            old.unlink()
    for name, text in texts.items():
        write(folder / name, text)
    write(output, table(layers))


if __name__ == "__main__":
    main()
