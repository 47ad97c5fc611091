// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Filters of pictures that are products of a row and a column.
#pragma once

#include <vector>

namespace penumbra::tool
{
/// One number for each pixel, first row at the top.
using Plane = std::vector<double>;

/// An odd number of weights, the middle one for the pixel itself.
using Weights = std::vector<double>;

/// Gaussian weights up to a distance in pixels, with a sum of 1.
Weights GaussianWeights(double deviation, int reach);

/// The plane, each pixel replaced by the weighted sum of its neighbours. Pixels at the edge are repeated beyond it.
Plane Convolved(const Plane& plane, int width, const Weights& across, const Weights& down);
}
