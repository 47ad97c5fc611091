// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Chooses where finer grids of probes reduce the error most.
 */
#pragma once

#include "probes/ProbeGrids.h"

#include <array>
#include <vector>

namespace penumbra
{
/// A point's share of the squared error of the light from a grid of probes.
struct PointError
{
  glm::dvec3 Position{ 0.0 };
  double Error = 0.0; ///< an unbiased estimate, which may be negative
};

/// Grids that share a number of probes: one around bounds (in VTK's order), and finer ones around boxes in which the
/// errors are concentrated. errors: those of a single grid with all the probes. That grid is the result if finer grids
/// make no difference.
ProbeGrids AdaptiveGrids(
  const std::array<double, 6>& bounds, int probes, const std::vector<PointError>& errors);

/// Number of probes below which AdaptiveGrids() returns a single grid.
constexpr int MinimumForSeveralGrids = ProbeGrid::MinimumAround + ProbeGrid::MinimumPart;

/// Whether others are less than errors by at least a tenth, and by more than a standard deviation. Both are for the
/// same points in the same order.
bool AreClearlyLess(const std::vector<PointError>& others, const std::vector<PointError>& errors);
}
