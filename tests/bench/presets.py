#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""What each preset comes to on the demo's scenes: how far its finished picture is from the path tracer, and what
it costs. Exit code 1 where a preset errs more than the one before it."""
import argparse
import os
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "examples"))

import penumbra  # noqa: E402
import scenes  # noqa: E402
from indirect_light import FINER, kept, smaller, write  # noqa: E402

PRESETS = ("off", "fast", "balanced", "high")
STILL = 16  # frames of a still picture, where no technique asks for more


def options():
    """From the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenes", nargs="*", default=list(scenes.SCENES), help="of " + ", ".join(scenes.SCENES))
    parser.add_argument("--size", default="320x180", help="of the pictures")
    parser.add_argument("--spp", type=int, default=256, help="paths through each pixel of the path tracer's")
    parser.add_argument("--presets", nargs="+", default=PRESETS, choices=PRESETS)
    parser.add_argument("--set", action="append", default=[], metavar="TECHNIQUE.PARAMETER=VALUE",
                        help="for all presets")
    parser.add_argument("--keep", metavar="FOLDER", help="where traced pictures are kept for the next run")
    parser.add_argument("--pictures", metavar="FOLDER", help="write what is compared")
    return parser.parse_args()


class Drawn:
    """A scene drawn by one preset until that has nothing more to add."""

    def __init__(self, name, size, preset, parameters):
        self.renderer = scenes.SCENES[name][1]()
        self.renderer.GradientBackgroundOff()
        self.renderer.SetBackground(0, 0, 0)
        self.gi = penumbra.enable(self.renderer, preset, **parameters)
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
    """A line for each scene and preset."""
    args = options()
    size = tuple(int(part) for part in args.size.split("x"))
    parameters = dict(item.split("=", 1) for item in args.set)
    falls = True
    print(f"{'scene':10} {'preset':10} relMSE  signed mean  frames  s of processor time")
    for name in args.scenes:
        truth = kept(args.keep, f"{name}_{args.size}_{args.spp}", lambda: Drawn(
            name, size, "reference", {"path-tracing.samples": str(args.spp)}).radiance)
        worst = float("inf")
        for preset in args.presets:
            known = {item: value for item, value in parameters.items() if preset != "off"}
            drawn = Drawn(name, [FINER * side for side in size], preset, known)
            picture = smaller(drawn.radiance)
            error, mean = penumbra.relative_error(picture, truth)
            write(args.pictures, f"{name}_{preset}.png", picture, truth)
            print(f"{name:10} {preset:10} {error:6.4f}  {100 * mean:+10.2f} %  {drawn.frames:6d}  {drawn.seconds:.1f}", flush=True)
            falls = falls and error <= worst
            worst = error
    return 0 if falls else 1


if __name__ == "__main__":
    sys.exit(main())
