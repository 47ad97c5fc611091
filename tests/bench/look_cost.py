#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Time of a frame of an orbit with a preset and a look, as a multiple of stock VTK's, on the demo's scenes. Both are drawn in
turn, and ratios are of medians. Exits with 1 if a ratio exceeds --limit."""
import statistics
import sys
import time

import penumbra
from bench_scenes import DEMO, SCENES, Parser

SETTLING_FRAMES = 20  # still frames before the orbit, in which the sky's maps are drawn


class Orbit:
    """A scene in a window, whose camera goes around it."""

    def __init__(self, scene, size, preset=None, look=None, **settings):
        self.renderer = SCENES[scene]()
        self.gi = penumbra.enable(self.renderer, preset, look=look, **settings) if preset else None
        self.window = penumbra.window(self.renderer, size=size, multisamples=0)
        for _ in range(SETTLING_FRAMES if preset else 1):
            self.window.Render()

    def frame(self):
        """Seconds of a frame after a step of the camera."""
        self.renderer.GetActiveCamera().Azimuth(1)
        started = time.perf_counter()
        self.window.Render()
        self.window.WaitForCompletion()
        return time.perf_counter() - started

    def statistics(self):
        """Statistics of one more frame, with the milliseconds of each pass."""
        self.gi.CollectStatisticsOn()
        self.frame()
        return self.gi.GetStatistics()


def options():
    """Parse the command line."""
    parser = Parser(__doc__, "1280x720", DEMO)
    parser.add_argument("--preset", default="balanced", help="default %(default)s")
    parser.add_argument("--look", default="studio", help="default %(default)s")
    parser.add_argument("--frames", type=int, default=9, help="number of timed frames (default %(default)s)")
    parser.add_argument("--limit", type=float, default=2.5, help="largest ratio (default %(default)s)")
    parser.add_argument("--statistics", action="store_true", help="print the time of each pass, too, as JSON")
    return parser.parse()


def main():
    """Print a line for each scene."""
    args = options()
    passed = True
    print(f"{'scene':11} {'stock':>9} {args.preset + ', ' + args.look:>20} ratio")
    for scene in args.scenes:
        orbits = (Orbit(scene, args.size), Orbit(scene, args.size, args.preset, args.look, **args.set))
        for orbit in orbits:
            orbit.frame()
        times = [[orbit.frame() for orbit in orbits] for _ in range(args.frames)]
        stock, ours = (statistics.median(column) for column in zip(*times))
        print(f"{scene:11} {1000 * stock:6.0f} ms {1000 * ours:17.0f} ms {ours / stock:5.2f}", flush=True)
        if args.statistics:
            print(orbits[1].statistics())
        passed = passed and ours <= args.limit * stock
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
