// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where finer grids of probes are worth most.
 */
#pragma once

#include "probes/ProbeGrids.h"

#include <array>
#include <vector>

namespace penumbra
{
/// A place's share in the squared error of the light that a grid of probes gives.
struct ErrorAt
{
  glm::dvec3 Place{ 0.0 };
  double Error = 0.0; ///< below zero by chance
};

/// Grids that share so many probes at most: one around bounds (as VTK's), and finer ones around the boxes in which errors
/// of that grid alone, with as many probes, are concentrated. That grid alone where others would not make a difference.
ProbeGrids AdaptiveGrids(
  const std::array<double, 6>& bounds, int probes, const std::vector<ErrorAt>& errors);

/// With fewer probes AdaptiveGrids() knows but one grid.
constexpr int LeastOfSeveral = ProbeGrid::LeastAround + ProbeGrid::LeastPart;

/// Whether others are clearly less than errors, at the same places in the same order: by a tenth, and not by chance.
bool AreClearlyLess(const std::vector<ErrorAt>& others, const std::vector<ErrorAt>& errors);
}
