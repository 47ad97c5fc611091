# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""The whole experiment: every kind of bias swept in one view, with pictures of the worst places."""
from dataclasses import dataclass, field

import numpy as np

from .measures import EDGE_BAND, Judge, pixel_width

# The limits of a safe bias: less is invisible. Acne is a fraction of the light on lit surfaces; gaps are in texels.
LIMITS = {"acne": 0.001, "gap": 1.0}
PIXELS_PER_TEXEL = 2
SMALLEST_MAP = 64
CROP = 72  # pixels: wide enough for some twenty to forty texels


def bias_kinds(technique):
    """A technique's parameters that are numbers and end in "-bias", without that ending."""
    names = (technique.GetParameterName(i) for i in range(technique.GetNumberOfParameters())
             if technique.GetParameterType(i) == "double")
    return [name[:-len("-bias")] for name in names if name.endswith("-bias")]


def coarse_enough(width, resolution):
    """The greatest power of two, at most the resolution, at which a texel is two pixels wide, of a width in texels: what a
    picture does not resolve can be neither seen nor measured in it."""
    while resolution > SMALLEST_MAP and width * PIXELS_PER_TEXEL > 1:
        resolution, width = resolution // 2, width / 2
    return resolution


def share_of_limits(sample):
    """The greater of both errors, each as a share of its limit: at most 1 is safe."""
    return max(sample[name] / limit for name, limit in LIMITS.items())


def safe_window(samples):
    """The widest run of samples within the limits, the lower of two alike; None where there is none.

    The choice is the middle, as far from acne below as from gaps above; where the sweep has not both ends of the window,
    it is the best sample.
    """
    safe = np.array([share_of_limits(sample) <= 1 for sample in samples])
    ends = np.flatnonzero(np.diff(np.concatenate([[False], safe, [False]]).astype(int)))
    runs = list(zip(ends[::2], ends[1::2]))
    if not runs:
        return None
    first, last = max(runs, key=lambda run: samples[run[1] - 1]["bias"] - samples[run[0]]["bias"])
    run = samples[first:last]
    low, high = run[0]["bias"], run[-1]["bias"]
    bounded = first > 0 and last < len(samples)
    choice = min(run, key=(lambda s: abs(s["bias"] - (low + high) / 2)) if bounded else share_of_limits)
    return {"low": low, "high": high, "reaches-end": bool(last == len(samples)), "choice": choice["bias"]}


def best(samples):
    """The choice of the safe window; without one, the sample that comes nearest to the limits."""
    window = safe_window(samples)
    return next(s for s in samples if s["bias"] == window["choice"]) if window else min(samples, key=share_of_limits)


def _set_biases(maps, biases):
    for kind in bias_kinds(maps):
        maps.SetParameter(kind + "-bias", biases.get(kind, 0))


def measure(bench, resolution=None):
    """A Judge of the bench's view, with the map made as coarse as its texels need to be to show; biases stay."""
    if resolution is None:
        resolution = coarse_enough(pixel_width(bench.trace_truth()), int(bench.maps.GetParameter("resolution")))
    bench.maps.SetParameter("resolution", resolution)
    truth = bench.trace_truth()
    biases = {kind: bench.maps.GetParameter(kind + "-bias") for kind in bias_kinds(bench.maps)}
    _set_biases(bench.maps, {})
    unbiased = bench.draw_mask()
    _set_biases(bench.maps, biases)
    # The filter spreads every edge by its radius, on purpose.
    return Judge(truth, unbiased, EDGE_BAND + bench.maps.GetParameter("filter-radius"))


def heaviest_square(weights):
    """The square, as slices, in which the sum of the weights is greatest: the middle where there is none."""
    height, width = weights.shape
    side = min(CROP, width, height)
    sums = np.pad(weights.cumsum(0).cumsum(1), ((1, 0), (1, 0)))
    inside = sums[side:, side:] - sums[:-side, side:] - sums[side:, :-side] + sums[:-side, :-side]
    y, x = np.unravel_index(inside.argmax(), inside.shape)
    if inside[y, x] <= 1e-6:
        y, x = (height - side) // 2, (width - side) // 2
    return slice(y, y + side), slice(x, x + side)


@dataclass
class Pictures:
    """What figures show: whole views, and of every sweep a pair of crops for each sample."""
    at_defaults: np.ndarray
    by_rays: np.ndarray = None
    acne_place: tuple = ()  # where acne is worst, of all kinds together
    gap_places: list = field(default_factory=list)  # of every sweep: where most light leaks in
    strips: list = field(default_factory=list)


def study(bench, biases, kinds=None, resolution=None):
    """Sweeps each kind of bias by itself, the others at 0: the numbers, as numbers.json has them, and Pictures."""
    maps = bench.maps
    kinds = kinds or bias_kinds(maps)
    judge = measure(bench, resolution)
    view = judge.view
    defaults = {kind + "-bias": maps.GetParameter(kind + "-bias") for kind in bias_kinds(maps)}
    numbers = {
        "resolution": int(maps.GetParameter("resolution")), "filter-radius": maps.GetParameter("filter-radius"),
        "texel-world": bench.texel, "pixel-texels": pixel_width(view), "limits": LIMITS, "lost": judge.lost,
        "pixels": {"lit": judge.lit_pixels, "dark": judge.dark_pixels},
        "edge-points": {"contact": judge.contact_points, "outline": judge.outline_points},
        "defaults": {**defaults, **judge.measure(bench.draw_mask())}, "sweeps": []}
    pictures = Pictures(bench.shown())
    # Acne at the smallest bias, in one place so that kinds can be compared; gaps at the greatest.
    acne = np.zeros(view.light.shape)
    for kind in kinds:
        _set_biases(maps, {kind: biases[0]})
        acne += view.light * np.maximum(judge.error(bench.draw_mask()), 0)
        _set_biases(maps, {kind: biases[-1]})
        leak = np.where(view.receiver, bench.draw_mask() - view.truth, 0)
        pictures.gap_places.append(heaviest_square(view.light * np.maximum(leak, 0)))
    pictures.acne_place = heaviest_square(acne)
    for kind, place in zip(kinds, pictures.gap_places):
        samples, strip = [], []
        for bias in biases:
            _set_biases(maps, {kind: bias})
            samples.append({"bias": bias, **judge.measure(bench.draw_mask())})
            shown = bench.shown()
            strip.append((shown[pictures.acne_place], shown[place]))
        numbers["sweeps"].append({"kind": kind, "parameter": kind + "-bias", "window": safe_window(samples),
                                  "best": best(samples)["bias"], "samples": samples})
        pictures.strips.append(strip)
    bench.draw_truth()
    pictures.by_rays = bench.shown()
    return numbers, pictures


def percent(share):
    """A share in words."""
    value = 100 * share
    return "under 0.001 %" if 0 < value < 0.001 else f"{value:.2g} %" if value < 10 else f"{value:.0f} %"


def window_in_words(sweep):
    """What is safe of a sweep, and what to take."""
    window, samples = sweep["window"], sweep["samples"]
    if not window:
        return f"none safe from {samples[0]['bias']:g} to {samples[-1]['bias']:g} texels; nearest {sweep['best']:g}"
    if window["high"] == window["low"] and not window["reaches-end"]:
        return f"safe at {window['choice']:g} texels only; take that"
    end = " at least" if window["reaches-end"] else ""
    return f"safe from {window['low']:g} to {window['high']:g} texels{end}; take {window['choice']:g}"


def defaults_in_words(numbers):
    """Whether the biases as they were set are safe."""
    defaults = numbers["defaults"]
    values = ", ".join(f"{name[:-len('-bias')]} {value:g}" for name, value in defaults.items() if name.endswith("-bias"))
    return f"as set ({values}): {'safe' if share_of_limits(defaults) <= 1 else 'not safe here'}"


def summary(numbers):
    """The numbers in words, a line for each kind of bias."""
    def errors(sample):
        return (f"acne {percent(sample['acne'])}, gap {sample['gap']:.2f} texels (in world units "
                f"{sample['contact-gap']['world']:.2g} at contact, {sample['outline-gap']['world']:.2g} at outlines)")

    lines = [f"{sweep['kind']} bias: {window_in_words(sweep)}: {errors(best(sweep['samples']))}"
             for sweep in numbers["sweeps"]]
    return "\n".join([*lines, f"{defaults_in_words(numbers)}: {errors(numbers['defaults'])}"])


def notes(bench, numbers):
    """What a reader of the numbers ought to know."""
    if bench.other_lights:
        yield f"of {bench.other_lights + 1} lights that cast shadows the strongest is studied"
    if bench.left_out:
        yield "what is translucent is left out: how dark its shadow is, is no matter of a bias"
    if numbers["pixel-texels"] > 1 / PIXELS_PER_TEXEL:
        yield (f"a pixel is {numbers['pixel-texels']:.2g} texels wide, so that gaps narrower than that cannot be told: come "
               "nearer with the camera, or give a larger --size or a smaller --resolution")
    if not numbers["pixels"]["lit"]:
        yield "the light reaches nothing in view but edges, so that no acne can be seen"
    if not any(numbers["edge-points"].values()):
        yield "no shadow is in view, so that no gap can be seen"
