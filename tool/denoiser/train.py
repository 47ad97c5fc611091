#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Train the denoiser's network: make scenes, render them with few rays and with many, and learn to filter the former.

Writes to a folder: data/ with the rendered pictures, samples-*/ with what follows from them, network.txt (copy it to
glsl/denoising/ to use it), report.json, loss.svg.
Goes on where it was interrupted; the same seed, scenes and steps give the same network to the last digit.
"""
import argparse
import json
import os
import subprocess
import sys
import time

import numpy as np
from matplotlib.figure import Figure

try:
    import torch
except ImportError:
    sys.exit("PyTorch is missing: install the package python3-torch, or call ./run train-denoiser, which does.")

import data
import network
import training_scenes as scenes
from training_samples import CROP, Samples, batch_of, crop

CROPS = 6                     # pictures of a step
RATE, LAST_RATE = 1e-3, 1e-5
FILTERED = 0.75               # share of the steps whose targets have less noise, but also less detail
FROM_RATE, FROM_FILTERED = 1e-3, 1.0  # of a training that starts from a network
SAVED = 200                   # steps between checkpoints
HELD_SEED = 1000              # scenes of families that are trained on, with other seeds from here on
SHORT = {"families": ["metaballs", "room"], "scenes": 1, "held": 0, "cameras": 1, "size": 64, "steps": 500}


class Progress:
    """Shows how far a task is, and how long it will take: on a terminal in one line, else once a minute."""

    def __init__(self, title):
        self.title, self.shown = title, 0.0
        self.first = None

    def __call__(self, share, more=""):
        now = time.monotonic()
        if self.first is None:
            self.first = (share, now)
        terminal = sys.stderr.isatty()
        if share < 1 and now - self.shown < (0.5 if terminal else 60):
            return
        self.shown = now
        done, since = share - self.first[0], now - self.first[1]
        left = f", {since / done * (1 - share) / 60:.0f} min left" if 0 < done and share < 1 else ""
        end = "\n" if share >= 1 or not terminal else ""
        print(f"{chr(13) if terminal else ''}{self.title}: {100 * share:.0f} %{left} {more}".ljust(78), end=end, file=sys.stderr,
              flush=True)


def whole(text, least=1):
    """A whole number from 1."""
    value = int(text)
    if value < least:
        raise argparse.ArgumentTypeError(f"{text} is not a number from {least}")
    return value


def count(text):
    """A whole number from 0."""
    return whole(text, 0)


def options():
    """Parse the command line."""
    parser = argparse.ArgumentParser(prog="train-denoiser", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--folder", default="out/denoiser", help="folder of the results (default %(default)s)")
    parser.add_argument("--seed", type=int, default=0, help="of all random numbers (default %(default)s)")
    parser.add_argument("--scenes", type=whole, default=8, help="of each family (default %(default)s)")
    parser.add_argument("--families", nargs="+", metavar="FAMILY", help="of scenes to train on (default all)")
    parser.add_argument("--held", type=count, default=2,
                        help="scenes of each family that are only for the report (default %(default)s)")
    parser.add_argument("--cameras", type=whole, default=4, help="in each scene (default %(default)s)")
    parser.add_argument("--size", type=whole, default=128,
                        help="width and height of pictures, a multiple of 32 (default %(default)s)")
    parser.add_argument("--steps", type=whole, default=20000, help="of the training (default %(default)s)")
    parser.add_argument("--from", dest="start", metavar="NETWORK", help="go on from the network of this file, with smaller steps")
    parser.add_argument("--short", action="store_true", help="a few small scenes and steps, to see whether all works")
    parser.add_argument("--data-only", action="store_true", help="render the pictures, and stop")
    args = parser.parse_args()
    if args.short:
        for name, value in SHORT.items():
            setattr(args, name, value)
    if args.size % 32 or args.size < CROP:
        parser.error(f"--size {args.size}: must be a multiple of 32 from {CROP}")
    return args


def revision():
    """The commit of this generator."""
    found = subprocess.run(["git", "-C", os.path.dirname(os.path.abspath(__file__)), "rev-parse", "HEAD"], stdout=subprocess.PIPE,
                           stderr=subprocess.DEVNULL, text=True, check=False)
    return found.stdout.strip() or "unknown"


def scene_lists(args):
    """Pairs of family and seed: to train on, and to report about."""
    families = args.families or list(scenes.TRAINED)
    unknown = set(families) - set(scenes.TRAINED)
    if unknown:
        sys.exit(f"there is no family {unknown.pop()}: there are {', '.join(scenes.TRAINED)}")
    first = 10000 * args.seed
    trained = [(family, first + i) for i in range(args.scenes) for family in families]
    held = [(family, first + HELD_SEED + i) for i in range(args.held) for family in (*families, *scenes.HELD_OUT)]
    return trained, held


class Training:
    """A network with the state of its optimization, which a checkpoint holds."""

    def __init__(self, args):
        torch.set_num_threads(1)
        torch.manual_seed(args.seed)
        self.args, self.net, self.step, self.losses = args, network.Denoiser(), 0, []
        self.rate, self.filtered = (FROM_RATE, FROM_FILTERED) if args.start else (RATE, FILTERED)
        self.origin = self.started(args.start) if args.start else "nothing"
        self.optimizer = torch.optim.Adam(self.net.parameters(), self.rate)
        self.path = os.path.join(args.folder, "checkpoint.pt")
        form = [list(value.shape) for value in self.net.parameters()]
        self.key = [self.origin, args.seed, args.families, args.scenes, args.cameras, args.size, args.steps, form]

    def started(self, path):
        """Take the weights of a network. Returns the commit of its generator."""
        try:
            return self.net.restore(path)["generator"]
        except OSError as error:
            sys.exit(f"{path} cannot be read: {error.strerror}.")
        except ValueError as error:
            sys.exit(str(error))
        except (KeyError, RuntimeError):
            sys.exit(f"{path} is a network of another form: take one that this command wrote.")

    def resume(self):
        """Go on from the checkpoint of a training with the same options, if there is one."""
        if os.path.exists(self.path):
            kept = torch.load(self.path)
            if kept["key"] == self.key:
                self.net.load_state_dict(kept["net"])
                self.optimizer.load_state_dict(kept["optimizer"])
                self.step, self.losses = kept["step"], kept["losses"]

    def save(self):
        """Write the checkpoint."""
        torch.save({"key": self.key, "net": self.net.state_dict(), "optimizer": self.optimizer.state_dict(),
                    "step": self.step, "losses": self.losses}, self.path + ".part")
        os.replace(self.path + ".part", self.path)

    def learn(self, samples):
        """One step. Its random numbers depend on its number only, so that a resumed training is the same."""
        random = np.random.default_rng((self.args.seed, self.step))
        rate = LAST_RATE + (self.rate - LAST_RATE) * 0.5 * (1 + np.cos(np.pi * self.step / self.args.steps))
        for group in self.optimizer.param_groups:
            group["lr"] = float(rate)
        batch = batch_of([crop(samples[i][0], random) for i in random.integers(0, len(samples), CROPS)])
        loss = network.loss_of(self.net(batch), batch, "smooth" if self.step < self.filtered * self.args.steps else "target")
        self.optimizer.zero_grad()
        loss.backward()
        torch.nn.utils.clip_grad_norm_(self.net.parameters(), 1.0)
        self.optimizer.step()
        self.step += 1
        self.losses.append(loss.item())

    def run(self, samples):
        """All steps that are left."""
        progress = Progress("training")
        while self.step < self.args.steps:
            self.learn(samples)
            recent = self.losses[-SAVED:]
            progress(self.step / self.args.steps, f"loss {sum(recent) / len(recent):.4f}")
            if self.step % SAVED == 0 or self.step == self.args.steps:
                self.save()


def errors(net, samples):
    """relMSE of each sample, by family and count of frames: raw, filtered, by the network."""
    found = []
    with torch.no_grad():
        for sample, family, frames in samples:
            batch = batch_of([sample])
            pictures = batch["light"], network.plain_filter(batch), net(batch)
            found.append((family, frames, [network.relative_error(picture, batch).item() for picture in pictures]))
    return found


def report(found, select):
    """Ratios of the network's relMSE to the filter's and to the raw signal's, geometric means over what select() gives alike."""
    groups = {}
    for family, count, (raw, plain, neural) in found:
        groups.setdefault(select(family, count), []).append((np.log(neural / plain), np.log(neural / raw)))
    return {key: [float(value) for value in np.exp(np.mean(values, axis=0))] for key, values in sorted(groups.items())}


def plot(losses, path):
    """Draw the loss over the steps, a mean over some of them."""
    width = max(1, len(losses) // 200)
    means = [np.mean(losses[i:i + width]) for i in range(0, len(losses) - width + 1, width)]
    figure = Figure(figsize=(6, 3))
    axes = figure.subplots()
    axes.plot(np.arange(len(means)) * width, means)
    axes.set_yscale("log")
    axes.set_xlabel("step")
    axes.set_ylabel("loss, relative squared error")
    figure.tight_layout()
    figure.savefig(path)


def main():
    """Render, train, report."""
    args = options()
    os.makedirs(args.folder, exist_ok=True)
    trained, held = scene_lists(args)
    training = Training(args)
    data.ensure(os.path.join(args.folder, data.FOLDER), trained + held, args.size, args.cameras, Progress("rendering"))
    learned = Samples(args.folder, trained, Progress("preparing"), halved=True)
    reported = Samples(args.folder, held, Progress("preparing")) if held else learned
    if args.data_only:
        return
    training.resume()
    training.run(learned)
    facts = {"generator": revision(), "from": training.origin, "seed": args.seed, "scenes": len(trained), "cameras": args.cameras,
             "size": args.size, "steps": args.steps}
    path = os.path.join(args.folder, "network.txt")
    training.net.save(path, facts)
    training.net.restore(path)  # the report is about the rounded weights
    found = errors(training.net, reported)
    tables = {"frames": report(found, lambda family, count: count), "family": report(found, lambda family, count: family),
              "all": report(found, lambda family, count: "all")}
    plot(training.losses, os.path.join(args.folder, "loss.svg"))
    with open(os.path.join(args.folder, "report.json"), "w", encoding="utf-8") as file:
        json.dump({"facts": facts, "relMSE of the network / filter, / raw": tables, "loss": training.losses}, file)
    print("relMSE of the network, geometric means    / filter     / raw")
    for title, table in tables.items():
        for key, (plain, raw) in table.items():
            name = f"{key} still frames" if title == "frames" and key else "orbit of 8 frames" if title == "frames" else key
            print(f"  {name:36} {plain:10.3f} {raw:10.3f}")
    print(f"Wrote {path}.")


if __name__ == "__main__":
    main()
