# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads and writes the file of the denoiser's network, glsl/denoising/network.txt. Needs no other packages.

The file is text: a line that names the format; lines with facts of the training; for each layer a line "layer NAME INPUTS OUTPUTS
KERNEL" and base64 of 16-bit floats, little-endian: weights by output, input, y and x, where y grows upward in the picture, then
biases by output (none if the kernel is 1); at last the SHA-256 of all before.
"""
import base64
import hashlib
import struct
from dataclasses import dataclass, field

MAGIC = "penumbra denoiser 1"
COLUMNS = 120


@dataclass
class Layer:
    """A convolution. values: weights, then biases, in the order of the file."""
    inputs: int
    outputs: int
    kernel: int
    values: list = field(default_factory=list)

    def weight_count(self):
        """Number of values that are no biases."""
        return self.inputs * self.outputs * self.kernel ** 2

    def count(self):
        """Number of values."""
        return self.weight_count() + (0 if self.kernel == 1 else self.outputs)


def checksum(text):
    """SHA-256 of a text."""
    return hashlib.sha256(text.encode("ascii")).hexdigest()


def read(path):
    """The facts, a dictionary of texts, and the layers by name. Raises ValueError, in one sentence, for any other file."""
    try:
        with open(path, encoding="ascii") as file:
            text = file.read()
    except UnicodeDecodeError:
        text = ""
    body, _, digest = text.rpartition("sha256 ")
    if not body.startswith(MAGIC + "\n") or checksum(body) != digest.strip():
        raise ValueError(f"{path} is not a denoiser's network, or is damaged: restore it, or write it with ./run train-denoiser.")
    facts, layers, letters = {}, {}, {}
    name = None
    for line in body.splitlines()[1:]:
        key, _, rest = line.partition(" ")
        if key == "layer":
            name, *numbers = rest.split()
            layers[name], letters[name] = Layer(*map(int, numbers)), []
        elif name:
            letters[name].append(line)
        else:
            facts[key] = rest
    for name, layer in layers.items():
        layer.values = [value for value, in struct.iter_unpack("<e", base64.b64decode("".join(letters[name])))]
        if len(layer.values) != layer.count():
            raise ValueError(f"{path} has {len(layer.values)} values for the layer {name}, not {layer.count()}: restore it.")
    return facts, layers


def write(path, facts, layers):
    """Write a network. Values are rounded to 16 bits."""
    lines = [MAGIC] + [f"{key} {value}" for key, value in facts.items()]
    for name, layer in layers.items():
        lines.append(f"layer {name} {layer.inputs} {layer.outputs} {layer.kernel}")
        letters = base64.b64encode(struct.pack(f"<{len(layer.values)}e", *layer.values)).decode("ascii")
        lines += [letters[i:i + COLUMNS] for i in range(0, len(letters), COLUMNS)]
    text = "\n".join(lines) + "\n"
    with open(path, "w", encoding="ascii") as file:
        file.write(f"{text}sha256 {checksum(text)}\n")
