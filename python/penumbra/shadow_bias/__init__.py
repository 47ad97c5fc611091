# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""The bias laboratory: shadow maps with more and more bias, measured against rays.

    python3 -m penumbra.shadow_bias examples/shadow_bias.py -o bias

Needs SciPy, and Matplotlib for pictures.
"""
from .bench import Bench
from .measures import Judge, View, pixel_width
from .study import bias_kinds, best, coarse_enough, measure, safe_window, study, summary

__all__ = ["Bench", "Judge", "View", "best", "bias_kinds", "coarse_enough", "measure", "pixel_width", "safe_window",
           "study", "summary"]
