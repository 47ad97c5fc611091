# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the denoiser's network is trained with: parts of rendered pictures as tensors, with what the loss needs."""
import functools
import hashlib
import os

import data
import network
import numpy as np
import reference
import torch

CROP = 64                # pixels
COVERED, TRIES = 0.3, 4  # share of a crop that shows surfaces, if one is found in so many tries
# Channels of a sample's arrays, and its numbers; see sample_of() and with_filtered().
ARRAYS = {"light": 3, "error": 1, "frames": 1, "normal": 2, "depth": 1, "concavity": 1, "slope": 12, "ray": 2, "target": 3,
          "measure": 3, "direct": 3, "known": 1, "smooth": 3}
NUMBERS = "angle", "fits", "filtered", "least"


@functools.lru_cache
def origin():
    """A name for the code that samples follow from."""
    texts = []
    for module in (data, network, reference):
        with open(module.__file__, "rb") as file:
            texts.append(file.read())
    with open(__file__, "rb") as file:
        texts.append(file.read())
    return hashlib.sha256(b"".join(texts)).hexdigest()[:8]


def sample_of(signal, truth):
    """A signal and its target as tensors."""
    fits = truth["count"] > 1  # as the pass does without a network from the second still frame
    surfaces = reference.Surfaces(signal)
    sample = network.tensors(signal, surfaces.concavity, reference.slopes(signal, surfaces), fits)
    for name in ("target", "measure", "direct"):
        sample[name] = torch.from_numpy(np.ascontiguousarray(np.nan_to_num(truth[name]).transpose(2, 0, 1)))
    sample["target_error"] = torch.from_numpy(np.ascontiguousarray(truth["target_error"][None]))
    sample["known"] = torch.from_numpy((truth["known"] & (signal.frames > 0)).astype(np.float32)[None])
    return sample


def finer(signal, truth):
    """Every second pixel of each second row: what changes less from pixel to pixel in the whole picture."""
    fields = {name: getattr(signal, name) for name in data.Signal.FIELDS}
    signal = data.Signal(**{name: value[::2, ::2] if value.ndim > 1 else value for name, value in fields.items()})
    return signal, {name: value[::2, ::2] if value.ndim > 1 else value for name, value in truth.items()}


def with_filtered(sample):
    """The sample with what the loss needs. filtered: relMSE of the filter without a network; least: what relMSE adds to squared
    light, so that dark pixels do not count more than they are visible; smooth: the target after the first level of the filter."""
    exists = sample["known"]
    many = {**sample, "light": sample["target"], "error": sample["target_error"] * exists, "frames": exists * data.TARGET_FRAMES,
            "slope": torch.zeros_like(sample["slope"])}
    with torch.no_grad():
        smooth = network.plain_filter(batch_of([many]), 1)
        batch = batch_of([sample])
        shown = network.luminance(batch["measure"] + batch["direct"])
        batch["least"] = 0.01 * network.mean_of(shown, batch)[:, None, None, None] ** 2 + 1e-30
        filtered = network.relative_error(network.plain_filter(batch), batch)
    return {**sample, "filtered": filtered.clamp(min=1e-5).reshape(1, 1, 1), "least": batch["least"][0], "smooth": smooth[0]}


def crop(sample, random):
    """A part of a picture that shows enough surfaces, turned or mirrored."""
    height, width = sample["frames"].shape[-2:]
    for _ in range(TRIES):
        y, x = (2 * random.integers(0, (size - CROP) // 2 + 1) for size in (height, width))
        part = {name: value if value.shape[-1] == 1 else value[:, y:y + CROP, x:x + CROP] for name, value in sample.items()}
        if part["known"].mean() > COVERED:
            break
    *mirrors, turn = random.random(3) < 0.5
    for axis, mirror in enumerate(mirrors):  # x, y
        if mirror:
            part = {name: value.flip(2 - axis) for name, value in part.items()}
            ray, normal, slope = (part[name].clone() for name in ("ray", "normal", "slope"))
            ray[axis], normal[axis] = -ray[axis], 1 - normal[axis]
            slope[3 * axis:3 * axis + 3] *= -1
            part.update(ray=ray, normal=normal, slope=slope)
    if turn:
        part = {name: value.transpose(1, 2) for name, value in part.items()}
        part["ray"], part["normal"] = part["ray"].flip(0), part["normal"].flip(0)
        part["slope"] = torch.cat((part["slope"][3:6], part["slope"][:3], part["slope"][6:]))
    return part


def batch_of(parts):
    """A batch with its surfaces."""
    return network.surfaces({name: torch.stack([part[name] for part in parts]) for name in parts[0]})


class Samples:
    """Samples of scenes, see with_filtered(), with the family and the count of frames of each. They are prepared once, in files
    that need not fit into memory."""

    def __init__(self, folder, pairs, progress, halved=False):
        """folder: of the results; pairs: of family and seed; progress: called with the share that is done. halved: whether
        there is also every second pixel of each picture."""
        self.folder, self.places = folder, []  # path, index in the file, family, numbers
        for done, (family, seed) in enumerate(pairs):
            progress(done / len(pairs))
            for name in ("whole", "halved") if halved else ("whole",):
                path = self.ensure(family, seed, name)
                with np.load(path + ".npz") as file:
                    rows = zip(*(file[key] for key in (*NUMBERS, "count")))
                    self.places += [(path + ".npy", index, family, row) for index, row in enumerate(rows)]
        progress(1.0)

    def ensure(self, family, seed, name):
        """Prepare the samples of a scene unless they are there: arrays in PATH.npy, numbers in PATH.npz. Returns PATH."""
        folder = os.path.join(self.folder, f"samples-{origin()}")
        path = os.path.join(folder, f"{family}_{seed:04d}_{name}")
        if not os.path.exists(path + ".npz"):
            os.makedirs(folder, exist_ok=True)
            pairs = data.load(data.path_of(os.path.join(self.folder, data.FOLDER), family, seed))
            if name == "halved":
                pairs = [finer(*pair) for pair in pairs if min(pair[0].frames.shape) >= 2 * CROP]
            found = [with_filtered(sample_of(*pair)) for pair in pairs]
            np.save(path + ".npy", np.array([np.concatenate([sample[key].numpy() for key in ARRAYS]) for sample in found]))
            np.savez(path + ".part.npz", count=[int(truth["count"]) for _, truth in pairs],
                     **{key: [sample[key].item() for sample in found] for key in NUMBERS})
            os.replace(path + ".part.npz", path + ".npz")
        return path

    def __len__(self):
        return len(self.places)

    def __getitem__(self, number):
        path, index, family, (*numbers, count) = self.places[number]
        values = torch.from_numpy(np.load(path, mmap_mode="c")[index]).split(list(ARRAYS.values()))
        sample = dict(zip(ARRAYS, values))
        sample.update({key: torch.full((1, 1, 1), float(value)) for key, value in zip(NUMBERS, numbers)})
        return sample, family, int(count)
