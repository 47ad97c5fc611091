#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw real and generated data with stock VTK and with each look, as single pictures and on one sheet.

usage: PYTHONPATH=build/python python3 examples/gallery.py [--output FOLDER] [--size WxH] [--look LOOK]... [SCENE...]
"""
import argparse
import pathlib
import sys

import gallery_scenes
import penumbra
import scenes
from PIL import Image, ImageDraw, ImageFont

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
SCENES = {**scenes.SCENES, **gallery_scenes.SCENES}
STOCK = "stock VTK"


def draw(name, looks, preset, size, frames):
    """Draw a scene with stock VTK and with each look. Returns pictures by name, STOCK first."""
    renderer = SCENES[name][1]()
    renderer.UseFXAAOn()
    window = penumbra.window(renderer, size=size, multisamples=0)
    pictures = {STOCK: penumbra.render(window)}
    for look in looks:
        penumbra.enable(renderer, preset, look=look, anti_aliasing__mode="accumulate")
        pictures[look] = penumbra.render(window, frames=frames)
    penumbra.disable(renderer)
    return pictures


def sheet(rows):
    """Place rows of pictures, (title, pictures by name), on one page with labels."""
    height, width, _ = next(iter(rows[0][1].values())).shape
    unit = max(9, width // 24)
    font = ImageFont.truetype(FONT, unit)
    line, gap = round(1.8 * unit), max(2, unit // 4)
    columns = list(rows[0][1])
    page = Image.new("RGB", (len(columns) * (width + gap) - gap, line + len(rows) * (height + gap)), (250, 250, 250))
    pen = ImageDraw.Draw(page)
    for column, name in enumerate(columns):
        x = column * (width + gap)
        pen.text((x + unit / 2, line / 2), name, (20, 20, 20), font, "lm")
        for row, (_, pictures) in enumerate(rows):
            page.paste(Image.fromarray(pictures[name]), (x, line + row * (height + gap)))
    return page


def main():
    names = [look.name for look in penumbra.looks()]
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help=", ".join(SCENES))
    parser.add_argument("--look", action="append", help=f"a name or a file; may be repeated (default: {', '.join(names)})")
    parser.add_argument("--preset", default="balanced", help="default %(default)s")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("out/gallery"))
    parser.add_argument("--size", default="480x360", help="size of each picture (default %(default)s)")
    parser.add_argument("--frames", type=int, default=16, help="number of averaged frames (default %(default)s)")
    options = parser.parse_args()
    unknown = sorted(set(options.scenes) - set(SCENES))
    if unknown:
        parser.error(f"unknown scene {unknown[0]}: choose from {', '.join(SCENES)}")
    size = tuple(int(n) for n in options.size.split("x"))
    options.output.mkdir(parents=True, exist_ok=True)
    rows = []
    for name in options.scenes or SCENES:
        try:
            pictures = draw(name, options.look or names, options.preset, size, options.frames)
        except OSError as error:
            sys.exit(f"gallery: the scene '{name}' cannot be drawn: {error} (packages/demo.txt lists what it needs)")
        rows.append((SCENES[name][0], pictures))
        for look, picture in pictures.items():
            stem = pathlib.Path(look).stem.replace(" ", "-").lower()
            Image.fromarray(picture).save(options.output / f"{name}-{stem}.png")
        print(f"{name}: {len(pictures)} pictures", flush=True)
    page = sheet(rows)
    page.save(options.output / "sheet.png")
    print(f"wrote {options.output / 'sheet.png'} ({page.width} x {page.height})")


if __name__ == "__main__":
    main()
