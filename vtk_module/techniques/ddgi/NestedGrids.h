// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Grids of probes within each other: the first around the scene, each later one of smaller cells, around what is looked
 * at. They follow it by whole cells, so that probes stay where they are (Majercik et al. 2021, Scaling Probe-Based
 * Real-Time Dynamic Global Illumination for Production, JCGT 10:2).
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
  /// The finer ones have at most so many probes each, about as many along each axis.
  NestedGrids(const ProbeGrid& first, int count, int probes);

  int Count() const { return this->Number; }
  ProbeGrid Get(int number) const;
  /// As they stand now.
  ProbeGrids List() const;

  /// By how much the cells of each grid are smaller than those of the one before.
  double Refinement() const { return this->Finer; }
  /// Returns whether it is another than before: then no probe of the finer grids is where it was.
  bool Refine(double refinement);
  /// The refinement with which the finest grid's longest side is a little longer than that, in steps of 19 %. Stays as
  /// it is where it nearly suits.
  double RefinementFor(double size) const;

  /// Have a finer grid stand around a point, no farther out of the scene than half a cell, where it is more than a
  /// cell off or at once. Returns by how many of its cells it moved.
  glm::ivec3 Follow(int number, const glm::dvec3& center, bool atOnce);

private:
  ProbeGrid First;
  glm::ivec3 Counts{ 0 }; ///< of the finer ones
  int Number = 1;
  double Finer = LeastRefinement;
  /// Of their first probes, in their own cells: zero is half a cell within the bounds that the first grid is around.
  std::array<glm::ivec3, ProbeGrids::Most> Bases{};
};
}
