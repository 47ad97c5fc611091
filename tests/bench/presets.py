#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Error of each preset against the path tracer, and its cost, on the demo's scenes and the example's isosurface. Exits with 1
if a preset has a larger error than the one before it."""
import sys
import time

import penumbra
from bench_scenes import SCENES, Parser
from indirect_light import FINER, kept, smaller, write

PRESETS = ("off", "fast", "balanced", "high")
STILL = 16  # frames of a still picture, unless a technique requires more


def options():
    """Parse the command line."""
    parser = Parser(__doc__, "320x180")
    parser.add_argument("--look", default="as-is", help="default %(default)s")
    parser.add_argument("--spp", type=int, default=256, help="paths per pixel of the reference")
    parser.add_argument("--presets", nargs="+", default=PRESETS, choices=PRESETS)
    parser.add_argument("--keep", metavar="FOLDER", help="folder that keeps traced pictures for the next run")
    parser.add_argument("--pictures", metavar="FOLDER", help="write the compared pictures there")
    return parser.parse()


class FinishedPicture:
    """A scene drawn with one preset until all techniques are finished."""

    def __init__(self, name, size, preset, look, parameters):
        self.renderer = SCENES[name]()
        self.renderer.GradientBackgroundOff()
        self.renderer.SetBackground(0, 0, 0)
        self.gi = penumbra.enable(self.renderer, preset, look=look, **parameters)
        self.gi.KeepRadianceOn()
        window = penumbra.window(self.renderer, size=size, multisamples=0)
        on = [t for t in map(self.gi.GetTechnique, range(self.gi.GetNumberOfTechniques())) if t.GetEnabled()]
        frames = max([STILL] + [t.GetRequiredFrames() for t in on])
        started = time.process_time()
        for frame in range(frames):
            window.Render()
            if frame + 1 >= STILL and all(t.IsFinished(self.renderer) for t in on):
                break
        window.WaitForCompletion()
        self.seconds = time.process_time() - started
        self.frames = frame + 1
        self.radiance = penumbra.radiance(self.gi, self.renderer)[..., :3].astype(float)


def main():
    """Print a line for each scene and preset."""
    args = options()
    passed = True
    print(f"{'scene':10} {'preset':10} relMSE  signed mean  frames  s of processor time")
    for name in args.scenes:
        truth = kept(args.keep, f"{name}_{args.look}_{args.size[0]}x{args.size[1]}_{args.spp}", lambda: FinishedPicture(
            name, args.size, "reference", args.look, {"path-tracing.samples": str(args.spp)}).radiance)
        previous = float("inf")
        for preset in args.presets:
            known = args.set if preset != "off" else {}
            finished = FinishedPicture(name, [FINER * side for side in args.size], preset, args.look, known)
            picture = smaller(finished.radiance)
            error, mean = penumbra.relative_error(picture, truth)
            write(args.pictures, f"{name}_{preset}.png", picture, truth)
            print(f"{name:10} {preset:10} {error:6.4f}  {100 * mean:+10.2f} %  {finished.frames:6d}  {finished.seconds:.1f}", flush=True)
            passed = passed and error <= previous
            previous = error
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
