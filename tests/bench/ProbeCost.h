// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cost of updating DDGI's probes in a Cornell box with a moving lamp, as a function of probes, rays, and triangles of a
 * ball in the room.
 */
#pragma once

#include <string>

namespace bench
{
struct ProbeCostOptions
{
  int Updates = 15;   ///< number of updates timed in each scene
  double Most = 4e6;  ///< triangles of the largest ball, at least LeastTriangles
  double Limit = 0.0; ///< maximum milliseconds of the default update; 0: no limit
  std::string Plot;   ///< PNG file for a plot of cost over triangles; empty: none
};

/// Triangles of the smallest ball.
constexpr double LeastTriangles = 1e4;

/// Print tables of medians. Returns whether the default update keeps the limit, the cost per ray does not grow with
/// their number, and the cost grows no faster than the logarithm of the triangles. Throws std::runtime_error if the
/// plot cannot be written.
bool ReportProbeCost(const ProbeCostOptions& options);
}
