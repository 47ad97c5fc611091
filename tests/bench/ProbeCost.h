// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What an update of DDGI's probes costs in a Cornell box whose lamp moves: by probes and rays, and by triangles, which a
 * ball in the room is made of.
 */
#pragma once

#include <string>

namespace bench
{
struct ProbeCostOptions
{
  int Updates = 15;   ///< that are timed in each scene
  double Most = 4e6;  ///< triangles of the largest scene, at least LeastTriangles
  double Limit = 0.0; ///< milliseconds that the default update may take; 0: any
  std::string Plot;   ///< a PNG file to draw the cost by triangles to; empty: none
};

/// Of the smallest ball.
constexpr double LeastTriangles = 1e4;

/// Print tables of medians. True where the default update keeps the limit, a ray costs no more the more there are, and
/// the cost grows no faster than the logarithm of the triangles. Throws std::runtime_error where the plot cannot be written.
bool ReportProbeCost(const ProbeCostOptions& options);
}
