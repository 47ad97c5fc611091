#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Still pictures of the path tracer with few paths per pixel, denoised: how many paths without denoising have the same error, and
how far the mean over many seeds is from the truth. Exits with 1 if a limit is exceeded.

relMSE against the mean of many paths of another seed.
"""
import argparse
import statistics
import sys

import numpy as np
import penumbra
from denoiser import SCENES, named  # finds tool/denoiser too
from data import LUMINANCE  # noqa: E402
from indirect_light import kept, write
from ray_scenes import Film, Report

ALSO = ("tubes-1000",)
METHODS = ("filter", "neural")
PATHS = 16
EQUAL = (16, 32, 64, 96, 128, 192, 256, 512)  # numbers of paths whose error is measured
WANTED, SCENES_WANTED = 96, 4                 # paths of equal error; number of scenes with that, for the better method
BIAS = 0.005                                  # of the mean over the seeds
TRUTH_SEED = 1000


def tracer(name, size, seed, method=None):
    """A film that traces paths."""
    parameters = {"path-tracing.samples": 1000000, "path-tracing.seed": seed}
    if method:
        parameters["denoising.method"] = method
    return Film(named(name), size, "reference", on=["denoising"] if method else [], **parameters)


def equal_paths(error, plain):
    """Number of paths without denoising that have the same error; between measured ones along a line in logarithms."""
    counts, errors = np.log(list(plain)), np.log(list(plain.values()))
    return float(np.exp(np.interp(-np.log(error), -errors, counts)))


def bias(name, args, method, expected, report):
    """Relative difference of the mean luminance over many seeds from the truth's. Not from that of as few paths without a denoiser:
    all seeds have the same points of the pixels, and so the same rough edges."""
    total, shot = 0, tracer(name, args.size, 0, method)
    for seed in range(args.seeds):
        report.going_on(f"{name}: seed {seed}, {method}")
        shot.gi.GetTechnique("path-tracing").SetParameter("seed", seed)
        total += shot.picture(args.paths)
    return float((total @ LUMINANCE).mean() / (expected @ LUMINANCE).mean()) / args.seeds - 1


def slower(denoised, plain):
    """How many times as long a path takes, with the filter of each frame."""
    times = [[sum(film.frame() for _ in range(4)) for film in (denoised, plain)] for _ in range(5)]
    return statistics.median(one / other for one, other in times)


def compare(name, args, report):
    """The truth; relMSE of plain paths; and by method that of denoised ones, the equal number of plain ones, the times' ratio."""
    def truth():
        report.going_on(f"{name}: truth")
        return tracer(name, args.size, TRUTH_SEED).picture(args.truth)
    expected = kept(args.keep, f"stills_{name}_{args.size[0]}x{args.size[1]}_{args.truth}", truth)

    def error(picture):
        return penumbra.relative_error(picture, expected)[0]
    report.going_on(f"{name}: without a denoiser")
    shot, plain, drawn, pictures = tracer(name, args.size, 0), {}, 0, {}
    for count in EQUAL:
        picture = shot.picture(count - drawn)
        drawn, plain[count] = count, error(picture)
        pictures.setdefault("none", picture)
    found = {}
    for method in METHODS:
        report.going_on(f"{name}: {method}")
        film = tracer(name, args.size, 0, method)
        pictures[method] = film.picture(args.paths)
        found[method] = error(pictures[method]), equal_paths(error(pictures[method]), plain), slower(film, shot)
    write(args.pictures, f"stills_{name}.png", pictures["none"], *(pictures[method] for method in METHODS), expected)
    return expected, plain[PATHS], found


def main():
    """Print a line for each scene, then what is wanted."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", default=[*SCENES, *ALSO], metavar="SCENE",
                        help=f"any of {', '.join(SCENES)}, or FAMILY-SEED (default: those and {', '.join(ALSO)})")
    parser.add_argument("--size", default="128x128", metavar="WxH", help="size of the pictures (default %(default)s)")
    parser.add_argument("--truth", type=int, default=4096, help="paths per pixel of the truth (default %(default)s)")
    parser.add_argument("--seeds", type=int, default=0, metavar="N", help="measure the mean over N seeds too (default: no)")
    parser.add_argument("--keep", metavar="FOLDER", help="folder that keeps the truths for the next run")
    parser.add_argument("--pictures", metavar="FOLDER", help="write pictures there: 16 paths, filter, network, truth")
    args = parser.parse_args()
    args.size, args.paths = tuple(map(int, args.size.split("x"))), PATHS
    report, reached = Report(), {method: 0 for method in METHODS}
    for name in args.scenes:
        expected, noisy, found = compare(name, args, report)
        for method, (error, paths, time) in found.items():
            reached[method] += paths >= WANTED
            report.figure(f"{name}: relMSE of {PATHS} paths, {method} / none", error / noisy, 1,
                          more=f"as {paths:.0f} paths; each takes {time:.1f} times as long")
        if args.seeds:
            for method in METHODS:
                difference = abs(bias(name, args, method, expected, report))
                report.figure(f"{name}: mean over {args.seeds} seeds, {method} / truth - 1", difference, BIAS)
    if len(args.scenes) > SCENES_WANTED:
        report.figure(f"scenes where {PATHS} paths are not as good as {WANTED}", len(args.scenes) - max(reached.values()),
                      len(args.scenes) - SCENES_WANTED)
    return 0 if report.passed else 1


if __name__ == "__main__":
    sys.exit(main())
