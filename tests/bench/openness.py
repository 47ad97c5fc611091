#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ambient occlusion beside vtkSSAOPass, on the demo's scenes in white: how far it is from openness by
rays, and what it costs. Exit code 1 where a method of Penumbra's that is held to it has more than half of
vtkSSAOPass's error, or takes longer."""
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

RADIUS = 0.15  # in diagonals of the scene, of ours and of the truth that is cut off
VTK_RADII = (0.02, 0.035, 0.05, 0.07, 0.1, 0.15)
VTK_TIMED = 0.07  # between those that are its best
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
    """From the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenes", nargs="*", default=["head", "protein", "terrain"])
    parser.add_argument("--size", default="640x360", help="of the pictures that are compared")
    parser.add_argument("--spp", type=int, default=256, help="paths through each pixel")
    parser.add_argument("--points", type=int, default=1500, help="pixels by chance for the truth within a radius")
    parser.add_argument("--rays", type=int, default=256, help="from each of those")
    parser.add_argument("--keep", metavar="FOLDER", help="where traced pictures are kept for the next run")
    parser.add_argument("--timing-size", default="1280x720", help="of the pictures that are timed")
    parser.add_argument("--repetitions", type=int, default=9, help="pictures of each way; 0: no times")
    return parser.parse_args()


def size_of(text):
    """WIDTHxHEIGHT as two numbers."""
    return tuple(int(part) for part in text.split("x"))


def times(name, size, repetitions):
    """Median milliseconds that each way adds to a picture without it, drawn in turn by chance."""
    ways = {"stock": drawn.by_vtk(name, size, 0), "pass": drawn.by_penumbra(name, size, None),
            "vtkSSAOPass": drawn.by_vtk(name, size, VTK_TIMED)}
    ways.update((label, drawn.by_penumbra(name, size, what)) for label, what in OURS.items())
    taken = {label: [] for label in ways}
    for _, window in ways.values():
        window.Render()
        window.Render()
    for i in range(repetitions):
        for label, (renderer, window) in random.sample(list(ways.items()), len(ways)):
            renderer.GetActiveCamera().Azimuth(0.5 if i % 2 else -0.5)
            begin = time.perf_counter()
            window.Render()
            window.WaitForCompletion()
            taken[label].append(1000 * (time.perf_counter() - begin))
    median = {label: statistics.median(values) for label, values in taken.items()}
    return {label: median[label] - median["stock" if label == "vtkSSAOPass" else "pass"]
            for label in ways if label not in ("stock", "pass")}


def main():
    given = options()
    if given.keep:
        os.makedirs(given.keep, exist_ok=True)
    size, fine = size_of(given.size), True
    for name in given.scenes:
        truth, covered = drawn.traced(name, size, given.spp, given.keep)
        renderer = drawn.white(name, ambient=True)
        columns, rows, by_rays = openness_by_rays.sample(
            renderer, size, given.points, given.rays, [np.inf, RADIUS * drawn.diagonal(renderer)])
        # Edges are smoothed in the traced picture only.
        inner = covered[rows, columns]
        columns, rows, by_rays = columns[inner], rows[inner], by_rays[:, inner]
        apart = np.abs(truth[rows, columns] - by_rays[0]).mean()
        print(f"\n{name}: mean openness {truth[covered].mean():.3f}; path traced and by VTK's locator: "
              f"{apart:.4f} apart")
        cost = times(name, size_of(given.timing_size), given.repetitions) if given.repetitions else {}

        def errors(label, way, timed):
            seen = drawn.picture(way)
            off = (seen - truth)[covered]
            within = np.abs(seen[rows, columns] - by_rays[1]).mean()
            spent = f"{cost[timed]:8.1f} {cost[timed] / cost['vtkSSAOPass']:6.2f}" if timed in cost else ""
            print(f"  {label:28s} {np.abs(off).mean():.4f} {off.mean():+.4f}   {within:.4f} {spent}", flush=True)
            return np.abs(off).mean(), within

        print(f"  {'mean absolute error':28s} to any distance, within {RADIUS}; added ms, of vtkSSAOPass's")
        stock = {radius: errors(f"vtkSSAOPass, radius {radius}", drawn.by_vtk(name, size, radius),
                                "vtkSSAOPass" if radius == VTK_TIMED else None) for radius in VTK_RADII}
        ours = {label: errors(label, drawn.by_penumbra(name, size, {"radius": RADIUS, **what}), label)
                for label, what in OURS.items()}
        best = min(error for error, _ in stock.values())
        ratios = ours[DEFAULT][0] / best, ours[DEFAULT][1] / stock[RADIUS][1]
        print(f"  {DEFAULT} / vtkSSAOPass: {ratios[0]:.2f} of the error at its best radius, "
              f"{ratios[1]:.2f} of that within {RADIUS}")
        fine &= max(ratios) <= 0.5 and (not cost or cost[DEFAULT] <= cost["vtkSSAOPass"])
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main())
