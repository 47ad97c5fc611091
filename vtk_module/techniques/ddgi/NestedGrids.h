// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Nested grids of probes: the first encloses the scene, each further one has smaller cells and surrounds the point that
 * the camera looks at. They follow that point by whole cells, so that probes keep their positions (Majercik et al.
 * 2021, Scaling Probe-Based Real-Time Dynamic Global Illumination for Production, JCGT 10:2).
 */
#pragma once

#include "probes/ProbeGrids.h"

#include <array>

namespace penumbra
{
class NestedGrids
{
public:
  static constexpr double LeastRefinement = 2.0;
  static constexpr double MostRefinement = 8.0;

  NestedGrids() = default;
  /// count: number of grids. probes: maximum number in each finer grid, similar along each axis.
  NestedGrids(const ProbeGrid& first, int count, int probes);

  int Count() const { return this->GridCount; }
  ProbeGrid Get(int number) const;
  /// All grids at their current positions.
  ProbeGrids List() const;

  /// Ratio of cell sizes between each grid and the next finer one.
  double Refinement() const { return this->Ratio; }
  /// Returns whether the refinement changed, which moves all probes of the finer grids.
  bool SetRefinement(double refinement);
  /// The refinement that makes the longest side of the finest grid a little longer than size, in steps of 19 %.
  /// The current one is kept while it is close enough.
  double RefinementFor(double size) const;

  /// Center a finer grid around a point, at most half a cell outside the scene, if it is more than one cell off or
  /// if immediately is true. Returns the number of its cells by which it moved.
  glm::ivec3 Follow(int number, const glm::dvec3& center, bool immediately);

private:
  ProbeGrid First;
  glm::ivec3 Counts{ 0 }; ///< counts of the finer grids
  int GridCount = 1;
  double Ratio = LeastRefinement;
  /// Position of each grid's first probe in its own cells; zero is half a cell inside the bounds of the scene.
  std::array<glm::ivec3, ProbeGrids::Most> Bases{};
};
}
