#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""The residual of a radiosity bake over its work, as a chart:

    penumbra bake radiosity examples/cornell.json --solver both --stats -o cornell.vtp > statistics.json
    python3 examples/radiosity_convergence.py statistics.json residual.png
"""
import json
import sys

from matplotlib.figure import Figure


def draw(statistics, picture):
    figure = Figure((6.4, 4), layout="constrained")
    chart = figure.subplots()
    for solver, name in (("gathering", "gathering (Gauss-Seidel)"), ("shooting", "shooting (progressive refinement)")):
        if solver in statistics:
            chart.semilogy(*zip((0, 1), *statistics[solver]), linewidth=2, label=name)
    chart.set(xlabel="form factors used, in matrices' worth", ylabel="residual, of the power first reflected")
    chart.grid(alpha=0.3)
    chart.legend()
    figure.savefig(picture)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: radiosity_convergence.py STATISTICS.json PICTURE")
    with open(sys.argv[1], encoding="utf-8") as file:
        draw(json.load(file), sys.argv[2])
