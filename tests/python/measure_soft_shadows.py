#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measure errors of shadow maps against ray-traced shadows for lights with a size, with and without soft shadows.

usage: measure_soft_shadows.py [--size WxH] [--frames N] [SCENE...]
"""
import argparse
import os
import pathlib

import numpy as np
import penumbra
import shadow_masks
from PIL import Image

EPSILON = 1e-2  # of relMSE, in units of squared radiance
ANGLE = 6.0  # degrees
RADIUS = 0.04  # in diagonals of the scene


def measure(name, kind, options):
    renderer = shadow_masks.scenes.SCENES[name][1]()
    window = penumbra.window(
        renderer, size=tuple(map(int, options.size.split("x"))), multisamples=0)
    shadow_masks.one_light(renderer, kind)
    bounds = np.reshape(renderer.ComputeVisiblePropBounds(), (3, 2))
    size = {"light_angle": ANGLE, "light_radius": RADIUS * np.linalg.norm(bounds[:, 1] - bounds[:, 0])}
    pictures = [shadow_masks.Shot(renderer, window, technique, frames=options.frames, **values).radiance
                for technique, values in (
                    ("ray-traced-shadows", {**size, "samples": 16}),
                    ("shadow-maps", {}),
                    ("shadow-maps", size))]
    reference = pictures[0]
    errors = [((p - reference) ** 2 / (reference ** 2 + EPSILON)).mean() for p in pictures[1:]]
    print(f"{name:8} {kind:16} {errors[0]:12.5f} {errors[1]:12.5f} {errors[1] / errors[0]:8.3f}",
          flush=True)
    folder = os.environ.get("PENUMBRA_TEST_OUTPUT") or options.pictures
    if folder:
        row = np.concatenate(pictures, axis=1)
        Image.fromarray((255 * np.clip(row / np.percentile(row, 99.5), 0, 1)).astype(np.uint8)).save(
            pathlib.Path(folder) / f"soft-{name}-{kind}.png")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("scenes", nargs="*", default=list(shadow_masks.scenes.SCENES))
    parser.add_argument("--size", default="480x270")
    parser.add_argument("--frames", type=int, default=8, help="number of averaged frames")
    parser.add_argument("--lights", nargs="*", default=["directional", "omnidirectional"])
    parser.add_argument("--pictures", help="folder for pictures: rays, maps without and with the light's size")
    options = parser.parse_args()
    print(f"relMSE (epsilon {EPSILON}) of shadow maps without and with the light's size, against rays:")
    print(f"{'scene':8} {'light':16} {'plain':>12} {'with size':>12} {'ratio':>8}")
    for name in options.scenes:
        for kind in options.lights:
            measure(name, kind, options)


if __name__ == "__main__":
    main()
