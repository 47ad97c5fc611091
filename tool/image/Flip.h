// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// FLIP: how much people notice when two pictures alternate in the same place.
#pragma once

#include "image/Convolution.h"
#include "image/Picture.h"

namespace penumbra::tool
{
/// Pixels per degree of a display 0.7 m wide with 3840 pixels, seen from 0.7 m: the authors' default.
constexpr double DefaultPixelsPerDegree = 67.02;

/// FLIP of each pixel, from 0 (not seen) to 1, of values taken as sRGB; it does not matter which picture is the reference.
/// Values outside 0..1 are clamped, those that are not finite count as 0. Andersson, Nilsson, Akenine-Möller, Oskarsson,
/// Åström and Fairchild 2020, FLIP: A Difference Evaluator for Alternating Images (for pictures of low dynamic range).
Plane Flip(const Picture& a, const Picture& b, double pixelsPerDegree = DefaultPixelsPerDegree);
}
