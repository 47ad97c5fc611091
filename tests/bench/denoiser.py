#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""The denoiser's network against the filter alone: one ray per pixel, on scenes that the network was not trained on. relMSE and
FLIP against the same light by many rays, and the time of the pass. Exits with 1 if a limit is exceeded.

Columns: after an orbit of 8 frames; after 1, 4, 8, 16 and 64 still frames.
"""
import argparse
import json
import os
import pathlib
import statistics
import sys
import tempfile

import numpy as np
import penumbra
from cornell_rays import penumbra as command
from indirect_light import kept, write
from penumbra.images import relative_squares
from PIL import Image
from ray_scenes import Film, Report, scene

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tool" / "denoiser"))
import training_scenes  # noqa: E402

SCENES = ("cornell", "isosurface", "head", "protein", "terrain")
SEEDS = (1000, 1001)       # of the families that are not trained on
STILL = (1, 4, 8, 16, 64)
ORBIT = 8                  # frames
GATED = ("orbit", 8)       # the columns with limits
ERROR, FLIP, WORST, UNSEEN, TIME = 0.7, 0.85, 1.05, 0.85, 2.5
METHODS = ("filter", "neural")
FEW = 0.01                 # of the pixels, whose share of the error is printed


def named(name):
    """A scene by name: of the bench, or family-seed."""
    family, _, seed = name.partition("-")
    return training_scenes.make(family, int(seed))[0] if seed else scene(name)


def film(name, size, method=None, **parameters):
    """A film that shows light by one ray per pixel, and direct light without shadows, which would add noise of their own.
    method: of the denoiser; None for no denoiser."""
    on = ["ray-traced-light", "temporal-accumulation"]
    if method:
        parameters["denoising.method"] = method
        on.append("denoising")
    made = Film(named(name), size, "off", on=on, **parameters)
    made.gi.CollectStatisticsOn()
    return made


def pass_time(shot):
    """Milliseconds of the filter of light in the last frame."""
    passes = penumbra.statistics(shot.gi)["passes"]
    return sum(entry["milliseconds"] for entry in passes if entry["name"] == "denoising.irradiance.rays")


def display(picture):
    """A picture in 8 bits."""
    return (255 * np.clip(picture, 0, 1) ** (1 / 2.2) + 0.5).astype(np.uint8)


def flip(picture, truth):
    """Mean FLIP of two pictures."""
    with tempfile.TemporaryDirectory() as folder:
        paths = [os.path.join(folder, name + ".png") for name in ("picture", "truth")]
        for path, shown in zip(paths, (picture, truth)):
            Image.fromarray(display(shown)).save(path)
        return json.loads(command("compare", *paths, "--json"))["flip-mean"]


def share_of_few(picture, truth):
    """Share of the pixels with the greatest errors, FEW of all, in relMSE."""
    found = np.sort(relative_squares(picture, truth).mean(-1), axis=None)
    return float(found[-max(1, round(FEW * found.size)):].sum() / found.sum())


def states(shot, turn):
    """Pictures after an orbit that ends where it began, and after numbers of still frames; and the times of the pass."""
    found, times = {}, []
    shot.camera.Azimuth(-turn * ORBIT)
    shot.cut()
    for _ in range(ORBIT):
        shot.camera.Azimuth(turn)
        shot.frame()
    found["orbit"] = shot.picture()
    shot.cut()
    for frame in range(1, max(STILL) + 1):
        shot.frame()
        times.append(pass_time(shot))
        if frame in STILL:
            found[frame] = shot.picture()
    return found, times


def compare(name, args, report):
    """Ratios of relMSE and FLIP of a scene by column, that of the times, and with the network share_of_few() by column."""
    report.going_on(f"{name}: truth")
    truth = kept(args.keep, f"denoiser_{name}_{args.size[0]}x{args.size[1]}",
                 lambda: film(name, args.size, **{"ray-traced-light.rays": 8}).picture(args.frames))
    errors, flips, times, pictures = {}, {}, {}, {}
    for method in METHODS:
        report.going_on(f"{name}: {method}")
        pictures[method], times[method] = states(film(name, args.size, method), args.turn)
        errors[method] = {key: penumbra.relative_error(picture, truth)[0] for key, picture in pictures[method].items()}
        flips[method] = {key: flip(pictures[method][key], truth) for key in GATED}
    for key in pictures["neural"]:
        write(args.pictures, f"denoiser_{name}_{key}.png", *(pictures[method][key] for method in METHODS), truth)
    ratios = {key: errors["neural"][key] / errors["filter"][key] for key in errors["filter"]}
    return ratios, {key: flips["neural"][key] / flips["filter"][key] for key in GATED}, \
        statistics.median(times["neural"]) / statistics.median(times["filter"]), \
        {key: share_of_few(pictures["neural"][key], truth) for key in GATED}


def main():
    """Print a line for each scene, then the means."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    unseen = [f"{family}-{seed}" for family in training_scenes.HELD_OUT for seed in SEEDS]
    parser.add_argument("scenes", nargs="*", default=[*SCENES, *unseen], metavar="SCENE",
                        help="any of " + ", ".join(SCENES) + ", or FAMILY-SEED (default: those, " + ", ".join(unseen) + ")")
    parser.add_argument("--size", default="160x160", metavar="WxH", help="size of the pictures (default %(default)s)")
    parser.add_argument("--frames", type=int, default=128, help="of the truth, with 8 rays each (default %(default)s)")
    parser.add_argument("--turn", type=float, default=2, help="degrees per frame of the orbit (default %(default)s)")
    parser.add_argument("--keep", metavar="FOLDER", help="folder that keeps the truths for the next run")
    parser.add_argument("--pictures", metavar="FOLDER", help="write pictures there: filter, network, truth")
    args = parser.parse_args()
    args.size = tuple(map(int, args.size.split("x")))
    report, found = Report(), {}
    for name in args.scenes:
        found[name] = ratios, flips, time, few = compare(name, args, report)
        text = ", ".join(f"{key} {value:.2f}" for key, value in ratios.items())
        report.figure(f"{name}: relMSE network / filter, worst of orbit and 8 frames", max(ratios[key] for key in GATED), WORST,
                      more=f"{text}; FLIP " + ", ".join(f"{value:.2f}" for value in flips.values()) + f"; time {time:.2f}; "
                      f"{FEW:.0%} of the pixels have " + ", ".join(f"{value:.2f}" for value in few.values()) + " of the error")

    def mean(values):
        return float(np.exp(np.mean(np.log(list(values)))))
    for key in GATED:
        report.figure(f"relMSE network / filter, {key}, geometric mean", mean(found[name][0][key] for name in found), ERROR)
        report.figure(f"FLIP network / filter, {key}, geometric mean", mean(found[name][1][key] for name in found), FLIP)
    rest = [name for name in found if "-" in name]
    if rest:
        report.figure("relMSE network / filter, families never trained on",
                      mean(found[name][0][key] for name in rest for key in GATED), UNSEEN)
    report.figure("time of the pass, network / filter, median", statistics.median(found[name][2] for name in found), TIME)
    return 0 if report.passed else 1


if __name__ == "__main__":
    sys.exit(main())
