#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Error of rays per pixel against the path tracer: the Cornell box lit by its panel, with the preset high and with rays added
or left out. Exits with 1 if the error with rays exceeds its limit. Writes the pictures as PNG beside each other with --pictures."""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENE = ROOT / "examples" / "cornell.json"
LIMITS = {"relmse": 0.001, "mean": 0.003}  # the latter as a share of the picture's mean
LIGHT = "3"  # brighter pixels show the panel itself


def options():
    """Parse the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--size", default="256x256", metavar="WxH", help="size of the pictures (default %(default)s)")
    parser.add_argument("--frames", default="64", help="still frames (default %(default)s)")
    parser.add_argument("--spp", default="1024", help="paths per pixel of the reference (default %(default)s)")
    parser.add_argument("--keep", metavar="FOLDER", help="folder that keeps the reference for the next run")
    parser.add_argument("--pictures", metavar="FOLDER", help="write the pictures there")
    return parser.parse_args()


def penumbra(*arguments):
    """Run the command; returns what it prints."""
    tool = shutil.which("penumbra", path=os.pathsep.join((str(ROOT / "build" / "bin"), os.environ.get("PATH", ""))))
    if not tool:
        sys.exit("cornell_rays.py: the command penumbra was not found: build it first, by ./run build.")
    done = subprocess.run([tool, *arguments], stdout=subprocess.PIPE, text=True)
    if done.returncode != 0:
        sys.exit(done.returncode)
    return done.stdout


def difference(picture, truth):
    """What the command says about a picture, without the panel."""
    return json.loads(penumbra("compare", str(picture), str(truth), "--mask-above", LIGHT, "--json"))


def main():
    """Print a line for each way to draw."""
    args = options()
    with tempfile.TemporaryDirectory() as folder:
        for wanted in (args.keep, args.pictures):
            if wanted:
                os.makedirs(wanted, exist_ok=True)
        truth = pathlib.Path(args.keep or folder) / f"cornell_{args.size}_{args.spp}.exr"
        if not truth.exists():
            penumbra("render", str(SCENE), "--preset", "reference", "--spp", args.spp, "--size", args.size, "-o", str(truth))
        # With every technique off the box is black but for its panel.
        black = pathlib.Path(folder) / "black.exr"
        penumbra("render", str(SCENE), "-q", "--preset", "off", "--size", args.size, "--frames", "1", "-o", str(black))
        whole = -difference(black, truth)["signed-mean"]
        passed = True
        print(f"{'':12} relMSE   signed mean  FLIP")
        for name, switch in (("probes", "--off"), ("with rays", "--on")):
            drawn = pathlib.Path(folder) / "drawn.exr"
            common = ("render", str(SCENE), "-q", "--preset", "high", switch, "ray-traced-light", "--size", args.size, "--frames",
                      args.frames)
            penumbra(*common, "-o", str(drawn))
            if args.pictures:
                penumbra(*common, "-o", str(pathlib.Path(args.pictures) / (name.replace(" ", "_") + ".png")))
            found = difference(drawn, truth)
            mean = found["signed-mean"] / whole
            print(f"{name:12} {found['relmse']:.5f}  {100 * mean:+8.2f} %   {found['flip-mean']:.4f}", flush=True)
            passed = switch == "--off" or (found["relmse"] <= LIMITS["relmse"] and abs(mean) <= LIMITS["mean"])
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
