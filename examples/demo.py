#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw real data with stock VTK and with two presets of Penumbra, side by side.

usage: PYTHONPATH=build/python python3 examples/demo.py [--output FOLDER] [--size WxH] [SCENE...]
"""
import argparse
import pathlib
import statistics
import sys
import time

import penumbra
import scenes
from PIL import Image, ImageDraw, ImageFont
from vtkmodules.vtkCommonCore import vtkVersion

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"


def progress(text):
    """Print what is being done, if the output is a terminal."""
    if sys.stdout.isatty():
        print(f"  {text}", flush=True)


def milliseconds(window, renderer, frames):
    """Return the median time of a frame while the camera moves, so that nothing can be reused."""
    times = []
    camera = renderer.GetActiveCamera()
    for step in [0.2] * (frames + 1) + [-0.2] * (frames + 1):
        camera.Azimuth(step)
        started = time.perf_counter()
        window.Render()
        window.WaitForCompletion()
        times.append(1000 * (time.perf_counter() - started))
    return statistics.median(times[1:])


def draw(name, size, frames, still):
    """Draw a scene. Returns columns of (picture, label, frame time), the title, and the window's description."""
    title, build = scenes.SCENES[name]
    progress(f"{name}: reading")
    renderer = build()
    # Use VTK's cheap anti-aliasing for all, because multisampling makes stock VTK slow on a CPU.
    renderer.UseFXAAOn()
    window = penumbra.window(renderer, size=size, multisamples=0)
    progress(f"{name}: stock VTK")
    stock = penumbra.render(window)
    columns = [(stock, f"VTK {vtkVersion.GetVTKVersion()}", f"FXAA: {milliseconds(window, renderer, frames):.0f} ms a frame")]
    for preset, label, what in (("balanced", "Penumbra, balanced", "shadows, ambient occlusion"),
                                ("high", "high", "and indirect light")):
        progress(f"{name}: the preset {preset}")
        # Still frames are averaged.
        penumbra.enable(renderer, preset, anti_aliasing__mode="accumulate")
        penumbra.render(window)
        lit_time = milliseconds(window, renderer, frames)
        columns.append((penumbra.render(window, frames=still), label, f"{what}: {lit_time:.0f} ms a frame"))
    where = window.GetDescription() if hasattr(window, "GetDescription") else ""
    return columns, title, where


def sheet(columns, title, where):
    """Place the pictures of a scene side by side, with labels."""
    height, width, _ = columns[0][0].shape
    unit = max(7, round(width / 40))
    large, small = (ImageFont.truetype(FONT, n) for n in (unit, round(0.72 * unit)))
    top, bottom, gap = 2 * unit, round(2.6 * unit), max(2, unit // 4)
    page = Image.new("RGB", (len(columns) * (width + gap) - gap, height + top + bottom), (250, 250, 250))
    pen = ImageDraw.Draw(page)
    pen.text((unit, top / 2), title, (20, 20, 20), large, "lm")
    if where:
        pen.text((page.width - unit, top / 2), where, (120, 120, 120), small, "rm")
    y = top + height + bottom / 2
    for number, (picture, label, note) in enumerate(columns):
        x = number * (width + gap)
        page.paste(Image.fromarray(picture), (x, top))
        pen.text((x + unit, y), label, (20, 20, 20), large, "lm")
        pen.text((x + width - unit, y), note, (90, 90, 90), small, "rm")
    return page


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help=", ".join(scenes.SCENES))
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("out/demo"))
    parser.add_argument("--size", default="800x600", help="size of each picture (default %(default)s)")
    parser.add_argument("--frames", type=int, default=2, help="number of timed frames in each direction")
    parser.add_argument("--still", type=int, default=32, help="number of still frames to average")
    options = parser.parse_args()
    for name in options.scenes:
        if name not in scenes.SCENES:
            parser.error(f"there is no scene '{name}': there are {', '.join(scenes.SCENES)}")
    try:
        width, height = (int(n) for n in options.size.split("x"))
        if not (16 <= width <= 8192 and 16 <= height <= 8192):
            raise ValueError
    except ValueError:
        parser.error(f"--size {options.size}: write it as 800x600, from 16x16 to 8192x8192")
    if options.frames < 1 or options.still < 1:
        parser.error("--frames and --still must be at least 1")
    try:
        options.output.mkdir(parents=True, exist_ok=True)
        pages = []
        for name in options.scenes or scenes.SCENES:
            pages.append(sheet(*draw(name, (width, height), options.frames, options.still)))
            pages[-1].save(options.output / f"{name}.png")
            print(f"{options.output / name}.png")
    except (OSError, RuntimeError) as error:
        sys.exit(f"demo: {error}")
    whole = Image.new("RGB", (pages[0].width, sum(page.height for page in pages)))
    for index, page in enumerate(pages):
        whole.paste(page, (0, sum(p.height for p in pages[:index])))
    whole.save(options.output / "contact-sheet.png")
    print(f"{options.output}/contact-sheet.png")


if __name__ == "__main__":
    main()
