# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""The study's pictures: strips of crops, a plot of the errors, and a sheet with everything."""
import math

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from .study import LIMITS, best, defaults_in_words, percent, share_of_limits, window_in_words

ACNE, GAP, SAFE, TRUE = "#c43c34", "#2660b0", "#56a860", "#8c8c8c"
MOST_COLUMNS = 8
LEAST_PERCENT = 1e-4  # less acne than this is none
MOST_GAP = 6  # texels: wider gaps are drawn as if they were that wide
TILE = 1.6  # inches


def _columns(samples):
    """Of many samples some, evenly, but the best one of all."""
    chosen = np.linspace(0, len(samples) - 1, min(len(samples), MOST_COLUMNS)).round().astype(int)
    favourite = samples.index(best(samples))
    chosen[np.abs(chosen - favourite).argmin()] = favourite
    return chosen


def _verdict(sample):
    if share_of_limits(sample) <= 1:
        return SAFE
    return ACNE if sample["acne"] / LIMITS["acne"] > sample["gap"] / LIMITS["gap"] else GAP


def draw_strip(figure, sweep, strip, by_rays, places):
    """Above, the place with the worst acne, below, the one with the widest gap; at the right end, by rays."""
    samples = sweep["samples"]
    tiles = [(strip[i], _verdict(samples[i]), f"{samples[i]['bias']:.3g} texels\nacne {percent(samples[i]['acne'])}\n"
              f"gap {samples[i]['gap']:.2f} texels") for i in _columns(samples)]
    tiles.append(([by_rays[place] for place in places], TRUE, "by rays\n\n"))
    figure.suptitle(f"{sweep['kind']} bias: {window_in_words(sweep)}", fontsize=11, ha="left", x=0.02)
    rows = figure.subplots(2, len(tiles), squeeze=False, gridspec_kw={"wspace": 0.06, "hspace": 0.06})
    figure.subplots_adjust(0.02, 0.2, 0.98, 0.9)
    for column, (crops, color, words) in enumerate(tiles):
        for row, crop in zip(rows, crops):
            row[column].imshow(crop, interpolation="nearest")
            row[column].set(xticks=[], yticks=[])
            for spine in row[column].spines.values():
                spine.set(color=color, linewidth=3)
        rows[1][column].set_xlabel(words, fontsize=8, loc="left")


def draw_plot(figure, sweeps):
    """Acne and gap over the bias, one chart for each kind."""
    widest = max(s["gap"] for sweep in sweeps for s in sweep["samples"])
    most = min(max(math.ceil(widest), 2 * LIMITS["gap"]), MOST_GAP)
    label = "gap, texels of the map" + (f"; {most:g} or more at the top" if widest > most else "")
    for chart, sweep in zip(figure.subplots(1, len(sweeps), squeeze=False)[0], sweeps):
        biases = [s["bias"] for s in sweep["samples"]]
        window = sweep["window"]
        if window:
            half = 0 if window["high"] > window["low"] else 0.004 * (biases[-1] - biases[0])
            chart.axvspan(window["low"] - half, window["high"] + half, color=SAFE, alpha=0.25)
            chart.axvline(window["choice"], color=SAFE)
        chart.set(title=f"{sweep['kind']} bias: {window_in_words(sweep)}", xlim=(biases[0], biases[-1]),
                  xlabel="bias, texels of the map", yscale="log", ylim=(LEAST_PERCENT, 100))
        chart.title.set_fontsize(9)
        chart.plot(biases, [max(100 * s["acne"], LEAST_PERCENT) for s in sweep["samples"]], color=ACNE, linewidth=2)
        chart.axhline(100 * LIMITS["acne"], color=ACNE, linestyle="--", linewidth=1)
        chart.set_ylabel("acne, % of the light on lit surfaces", color=ACNE)
        gaps = chart.twinx()
        gaps.plot(biases, [min(s["gap"], most) for s in sweep["samples"]], color=GAP, linewidth=2)
        gaps.axhline(LIMITS["gap"], color=GAP, linestyle="--", linewidth=1)
        gaps.set_ylim(0, most)
        gaps.set_ylabel(label, color=GAP)
    figure.subplots_adjust(0.06, 0.14, 0.94, 0.9, wspace=0.45)


def draw_overviews(figure, numbers, pictures):
    """The whole view by rays, with the places of the strips, and by the map as it was set."""
    figure.suptitle(f"Shadow map of {numbers['resolution']} x {numbers['resolution']} texels, filter radius "
                    f"{numbers['filter-radius']:g}; a texel is {numbers['texel-world']:.3g} wide", fontsize=11)
    axes = figure.subplots(1, 2)
    for axis, picture, title in ((axes[0], pictures.by_rays, "by rays; red: worst acne, blue: widest gap"),
                                 (axes[1], pictures.at_defaults, "by the map, " + defaults_in_words(numbers))):
        axis.imshow(picture)
        axis.set_title(title, fontsize=9)
        axis.axis("off")
        for (y, x), color in ((pictures.acne_place, ACNE), *((place, GAP) for place in pictures.gap_places)):
            axis.add_patch(Rectangle((x.start, y.start), x.stop - x.start, y.stop - y.start, fill=False, edgecolor=color))


def write(folder, numbers, pictures):
    """plot.png and plot.svg, a strip-KIND.png for each kind of bias, and sheet.png with all of them."""
    sweeps = numbers["sweeps"]
    columns = 1 + max(len(_columns(sweep["samples"])) for sweep in sweeps)
    strip_size, plot_size = (columns * TILE, 2 * TILE + 1), (5.2 * len(sweeps), 3.6)
    plot = Figure(plot_size)
    draw_plot(plot, sweeps)
    plot.savefig(folder / "plot.png", dpi=100)
    plot.savefig(folder / "plot.svg")
    strips = [(sweep, strip, pictures.by_rays, (pictures.acne_place, place))
              for sweep, strip, place in zip(sweeps, pictures.strips, pictures.gap_places)]
    for strip in strips:
        figure = Figure(strip_size)
        draw_strip(figure, *strip)
        figure.savefig(folder / f"strip-{strip[0]['kind']}.png", dpi=100)
    heights = [4.5, *(strip_size[1] for _ in strips), plot_size[1]]
    sheet = Figure((max(strip_size[0], plot_size[0], 12), sum(heights)))
    parts = sheet.subfigures(len(heights), 1, height_ratios=heights)
    draw_overviews(parts[0], numbers, pictures)
    for part, strip in zip(parts[1:], strips):
        draw_strip(part, *strip)
    draw_plot(parts[-1], sweeps)
    sheet.savefig(folder / "sheet.png", dpi=100)
