# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads the OpenEXR files that penumbra bake writes: scan-line parts, uncompressed or with ZIP compression.

Follows the description of the format (openexr.com, "OpenEXR File Layout"). Files of other programs are read if they
use the same features.
"""
import struct
import zlib

import numpy

_TYPES = (numpy.dtype("<u4"), numpy.dtype("<f2"), numpy.dtype("<f4"))
_LINES = {0: 1, 2: 1, 3: 16}  # lines per chunk, by compression: none, ZIPS, ZIP


class Part:
    """attributes: strings by name; channels: arrays of shape (height, width) by name."""

    def __init__(self):
        self.attributes = {}
        self.channels = {}


class _Reader:
    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, form):
        values = struct.unpack_from("<" + form, self.data, self.at)
        self.at += struct.calcsize("<" + form)
        return values if len(values) > 1 else values[0]

    def text(self):
        end = self.data.index(b"\0", self.at)
        found = self.data[self.at:end]
        self.at = end + 1
        return found.decode("latin-1")


def _header(reader):
    found = {}
    while True:
        name = reader.text()
        if not name:
            return found
        kind, size = reader.text(), reader.take("i")
        found[name] = (kind, reader.data[reader.at:reader.at + size])
        reader.at += size


def _channels(data):
    reader, found = _Reader(data), []
    while True:
        name = reader.text()
        if not name:
            return found
        kind, _, x, y = reader.take("iIii")
        if (x, y) != (1, 1):
            raise ValueError("channels of another resolution")
        found.append((name, _TYPES[kind]))


def _unzip(data, size):
    """Decompress a chunk: the bytes at even positions come first, and all but the first are stored as differences."""
    if len(data) == size:
        return data
    raw = numpy.frombuffer(zlib.decompress(data), numpy.uint8).astype(numpy.int64)
    if len(raw) != size:
        raise ValueError("a chunk of another size")
    raw[1:] -= 128
    raw = numpy.cumsum(raw).astype(numpy.uint8)
    whole = numpy.empty(size, numpy.uint8)
    whole[0::2], whole[1::2] = raw[:(size + 1) // 2], raw[(size + 1) // 2:]
    return whole.tobytes()


def read(path):
    """Read the parts of a file. Raises ValueError if it is damaged or of an unsupported kind."""
    with open(path, "rb") as file:
        data = file.read()
    try:
        return _read(data)
    except (ValueError, IndexError, KeyError, struct.error, zlib.error) as error:
        raise ValueError(f"'{path}' is damaged or not an OpenEXR picture of a supported kind ({error})") from error


def _read(data):
    reader = _Reader(data)
    magic, version = reader.take("II")
    if magic != 0x01312F76 or version & 0xFF != 2 or version & 0xA00:
        raise ValueError("another format")
    several = bool(version & 0x1000)
    headers = [_header(reader)]
    while several and data[reader.at] != 0:
        headers.append(_header(reader))
    reader.at += 1 if several else 0
    parts, layouts = [], []
    for header in headers:
        low_x, low_y, high_x, high_y = struct.unpack("<4i", header["dataWindow"][1])
        part, channels = Part(), _channels(header["channels"][1])
        part.attributes = {name: value.decode("utf-8", "replace") for name, (kind, value) in header.items()
                           if kind == "string"}
        width, height, lines = high_x - low_x + 1, high_y - low_y + 1, _LINES[header["compression"][1][0]]
        part.channels = {name: numpy.zeros((height, width), kind) for name, kind in channels}
        parts.append(part)
        layouts.append((channels, low_y, width, height, lines, header["compression"][1][0]))
    counts = [-(-height // lines) for _, _, _, height, lines, _ in layouts]
    reader.at += 8 * sum(counts)
    for _ in range(sum(counts)):
        number = reader.take("i") if several else 0
        y, size = reader.take("ii")
        channels, low_y, width, height, lines, compression = layouts[number]
        lines = min(lines, height - (y - low_y))
        expected = lines * width * sum(kind.itemsize for _, kind in channels)
        chunk = reader.data[reader.at:reader.at + size]
        chunk = chunk if compression == 0 else _unzip(chunk, expected)
        if len(chunk) != expected:
            raise ValueError("it is cut off")
        reader.at += size
        at = 0
        for line in range(y - low_y, y - low_y + lines):
            for name, kind in channels:
                parts[number].channels[name][line] = numpy.frombuffer(chunk, kind, width, at)
                at += width * kind.itemsize
    return parts
