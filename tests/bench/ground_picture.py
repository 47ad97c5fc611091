#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of docs/techniques/ground.md: a protein over a gradient, and on a transparent background over a checkerboard."""
import argparse
import pathlib
import subprocess
import tempfile

import numpy as np
from PIL import Image

LOOK = ["--preset", "balanced", "--on", "ground", "--set", "ground.up=y", "--light", "directional:-2,5,3",
        "--set", "shadow-maps.light-angle=8", "--set", "ambient-occlusion.ambient-share=0.35",
        "--camera", "azimuth=20,elevation=25,zoom=0.8", "--size", "480x360", "--frames", "16"]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("data", help="a file to show, such as 1tii.pdb")
    parser.add_argument("output", help="the picture")
    parser.add_argument("--tool", default="penumbra", help="the command")
    options = parser.parse_args()
    pictures = []
    with tempfile.TemporaryDirectory() as folder:
        for background in ("bottom=white,top=#5078b0", "transparent"):
            path = pathlib.Path(folder, "picture.png")
            subprocess.run([options.tool, "render", options.data, *LOOK, "--background", background, "-o", path], check=True)
            pictures.append(Image.open(path).convert("RGBA"))
    height, width = pictures[0].size[::-1]
    checkers = np.indices((height, width)) // 24
    slide = Image.fromarray((checkers.sum(0) % 2 * 40 + 200).astype(np.uint8)).convert("RGBA")
    slide.alpha_composite(pictures[1])
    both = Image.new("RGB", (2 * width, height))
    for place, picture in enumerate((pictures[0], slide)):
        both.paste(picture.convert("RGB"), (place * width, 0))
    both.save(options.output, quality=88)


if __name__ == "__main__":
    main()
