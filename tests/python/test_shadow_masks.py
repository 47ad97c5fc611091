#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shadow maps against hard ray-traced shadows in the demo's scenes, each with four kinds of light.

usage: test_shadow_masks.py [--size WxH] [--resolution N] [--filter-radius R] [SCENE...]
"""
import argparse
import os
import pathlib
import sys

import numpy as np
import penumbra
import shadow_masks
from PIL import Image

LIMIT = 0.3  # percent of the pixels


def measure(name, kind, options):
    renderer = shadow_masks.scenes.SCENES[name][1]()
    width, height = map(int, options.size.split("x"))
    window = penumbra.window(renderer, size=(width, height), multisamples=0)
    light = shadow_masks.one_light(renderer, kind)
    bare = shadow_masks.Shot(renderer, window).radiance
    world = shadow_masks.positions(renderer, window)
    lit = (bare > 0.02 * bare.max()) & ~np.isnan(world[..., 0])
    masks = []
    for technique, values in (
            ("ray-traced-shadows", {"light_angle": 0}),
            ("shadow-maps", {"resolution": options.resolution, "cascades": 1,
                             "filter_radius": options.filter_radius, **options.set})):
        shot = shadow_masks.Shot(renderer, window, technique, **values).radiance
        masks.append(np.where(lit, shot / np.maximum(bare, 1e-9), 0.0))
    bounds = np.reshape(renderer.ComputeVisiblePropBounds(), (3, 2))
    count, differ, outside, shadow = shadow_masks.compare(
        masks[0], masks[1], lit, world, light, bounds, options.resolution, options.band)
    dark = sum(masks[0][tuple(p)] > 0.5 for p in outside)
    share = 100 * len(outside) / max(count, 1)
    print(f"{name:8} {kind:16} {count:8} {100 * (lit & shadow).sum() / count:9.1f} "
          f"{100 * differ / count:9.2f} {share:9.3f} {100 * dark / count:9.3f}", flush=True)
    folder = os.environ.get("PENUMBRA_TEST_OUTPUT") or options.pictures
    if folder:
        picture = np.stack([255 * masks[0], 255 * masks[1], 255 * masks[1]], axis=2)
        for y, x in outside:
            picture[y, x] = (255, 255, 0)
        Image.fromarray(np.clip(picture, 0, 255).astype(np.uint8)).save(
            pathlib.Path(folder) / f"mask-{name}-{kind}.png")
    return share


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("scenes", nargs="*", default=list(shadow_masks.scenes.SCENES))
    parser.add_argument("--size", default="640x360")
    parser.add_argument("--resolution", type=int, default=2048)
    parser.add_argument("--filter-radius", type=float, default=0.0)
    parser.add_argument("--band", type=float, default=1.5, help="texels or pixels along edges that are left out")
    parser.add_argument("--lights", nargs="*", default=shadow_masks.LIGHTS)
    parser.add_argument("--pictures", help="folder for pictures of the masks")
    parser.add_argument("--set", nargs="*", default=[], metavar="NAME=VALUE")
    options = parser.parse_args()
    options.set = {k: float(v) for k, v in (pair.split("=") for pair in options.set)}
    print("percent of the pixels that face the light:")
    print(f"{'scene':8} {'light':16} {'pixels':>8} {'shadowed':>9} {'differ':>9} {'outside':>9} {'too dark':>9}")
    worst = max(measure(name, kind, options) for name in options.scenes for kind in options.lights)
    print(f"worst outside of {options.band} texels or pixels at edges: {worst:.3f} %, at most {LIMIT} %")
    return 0 if worst <= LIMIT else 1


if __name__ == "__main__":
    sys.exit(main())
