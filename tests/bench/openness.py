#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Error of ambient occlusion against rays, and its cost, for Penumbra and vtkSSAOPass, on the demo's scenes in white. Exits
with 1 if Penumbra's default method has more than half of vtkSSAOPass's error, or takes longer."""
import argparse
import os
import random
import statistics
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "examples"))

import numpy as np  # noqa: E402
import openness_by_rays  # noqa: E402
import openness_scenes as drawn  # noqa: E402

RADIUS = 0.15  # in diagonals of the scene, of ours and of the reference with a radius
VTK_RADII = (0.02, 0.035, 0.05, 0.07, 0.1, 0.15)
VTK_TIMED = 0.07  # between its best radii
DEFAULT = "horizon"
OURS = {
    "horizon": {},
    "horizon, 16 samples": {"samples": 16},
    "horizon, 64 samples": {"samples": 64},
    "horizon, thickness 0.07": {"thickness": 0},
    "horizon, half": {"resolution": "half"},
    "horizon, half, 16 samples": {"resolution": "half", "samples": 16},
    "hemisphere": {"method": "hemisphere"},
    "hemisphere, half": {"method": "hemisphere", "resolution": "half"},
}


def options():
    """Parse the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenes", nargs="*", default=["head", "protein", "terrain"])
    parser.add_argument("--size", default="640x360", help="size of the compared pictures")
    parser.add_argument("--spp", type=int, default=256, help="paths per pixel of the reference")
    parser.add_argument("--points", type=int, default=1500, help="random pixels of the reference with a radius")
    parser.add_argument("--rays", type=int, default=256, help="rays from each of these pixels")
    parser.add_argument("--keep", metavar="FOLDER", help="folder that keeps traced pictures for the next run")
    parser.add_argument("--timing-size", default="1280x720", help="size of the timed pictures")
    parser.add_argument("--repetitions", type=int, default=9, help="timed pictures per method; 0: no times")
    return parser.parse_args()


def size_of(text):
    """WIDTHxHEIGHT as two numbers."""
    return tuple(int(part) for part in text.split("x"))


def times(name, size, repetitions):
    """Median milliseconds that each method adds to a picture without occlusion. Methods are drawn in random order."""
    methods = {"stock": drawn.by_vtk(name, size, 0), "pass": drawn.by_penumbra(name, size, None),
            "vtkSSAOPass": drawn.by_vtk(name, size, VTK_TIMED)}
    methods.update((label, drawn.by_penumbra(name, size, what)) for label, what in OURS.items())
    milliseconds = {label: [] for label in methods}
    for _, window in methods.values():
        window.Render()
        window.Render()
    for i in range(repetitions):
        for label, (renderer, window) in random.sample(list(methods.items()), len(methods)):
            renderer.GetActiveCamera().Azimuth(0.5 if i % 2 else -0.5)
            begin = time.perf_counter()
            window.Render()
            window.WaitForCompletion()
            milliseconds[label].append(1000 * (time.perf_counter() - begin))
    median = {label: statistics.median(values) for label, values in milliseconds.items()}
    return {label: median[label] - median["stock" if label == "vtkSSAOPass" else "pass"]
            for label in methods if label not in ("stock", "pass")}


def main():
    args = options()
    if args.keep:
        os.makedirs(args.keep, exist_ok=True)
    size, passed = size_of(args.size), True
    for name in args.scenes:
        truth, covered = drawn.traced(name, size, args.spp, args.keep)
        renderer = drawn.white(name, ambient=True)
        columns, rows, by_rays = openness_by_rays.sample(
            renderer, size, args.points, args.rays, [np.inf, RADIUS * drawn.diagonal(renderer)])
        # Only the traced picture has anti-aliased edges.
        inner = covered[rows, columns]
        columns, rows, by_rays = columns[inner], rows[inner], by_rays[:, inner]
        difference = np.abs(truth[rows, columns] - by_rays[0]).mean()
        print(f"\n{name}: mean openness {truth[covered].mean():.3f}; path tracer and VTK's locator differ "
              f"by {difference:.4f}")
        cost = times(name, size_of(args.timing_size), args.repetitions) if args.repetitions else {}

        def errors(label, method, timed):
            shown = drawn.picture(method)
            off = (shown - truth)[covered]
            within = np.abs(shown[rows, columns] - by_rays[1]).mean()
            added = f"{cost[timed]:8.1f} {cost[timed] / cost['vtkSSAOPass']:6.2f}" if timed in cost else ""
            print(f"  {label:28s} {np.abs(off).mean():.4f} {off.mean():+.4f}   {within:.4f} {added}", flush=True)
            return np.abs(off).mean(), within

        print(f"  {'mean absolute error':28s} at any distance, within {RADIUS}; added ms, relative to vtkSSAOPass")
        stock = {radius: errors(f"vtkSSAOPass, radius {radius}", drawn.by_vtk(name, size, radius),
                                "vtkSSAOPass" if radius == VTK_TIMED else None) for radius in VTK_RADII}
        ours = {label: errors(label, drawn.by_penumbra(name, size, {"radius": RADIUS, **what}), label)
                for label, what in OURS.items()}
        best = min(error for error, _ in stock.values())
        ratios = ours[DEFAULT][0] / best, ours[DEFAULT][1] / stock[RADIUS][1]
        print(f"  {DEFAULT} / vtkSSAOPass: {ratios[0]:.2f} of the error at its best radius, "
              f"{ratios[1]:.2f} of that within {RADIUS}")
        passed &= max(ratios) <= 0.5 and (not cost or cost[DEFAULT] <= cost["vtkSSAOPass"])
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
