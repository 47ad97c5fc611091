// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Grids of probes within each other: the first around the scene, each later one of as many probes and smaller cells,
 * around what is looked at. They follow it by whole cells, so that probes stay where they are (Majercik et al. 2021,
 * Scaling Probe-Based Real-Time Dynamic Global Illumination for Production, JCGT 10:2).
 */
#pragma once

#include "private/ProbeGrid.h"

#include <array>

namespace penumbra
{
class NestedGrids
{
public:
  static constexpr int Most = 6; ///< as GI_FIELD_GRIDS in glsl/probes/field.glsl

  NestedGrids() = default;
  /// refinement: by how much the cells of each are smaller than those of the one before. The finer grids stand in
  /// the first one's middle.
  explicit NestedGrids(const ProbeGrid& first, int count = 1, int refinement = 2);

  int Count() const { return this->Number; }
  int SizeOfOne() const { return this->First.Size(); }
  int Size() const { return this->Number * this->First.Size(); }
  ProbeGrid Get(int number) const;
  /// Place of a grid's first probe in storage, where probes lie by their places modulo the grid's counts.
  glm::ivec3 Wrap(int number) const;
  /// The finest grid's ProbeGrid::Detail().
  double Detail() const { return this->Get(this->Number - 1).Detail(); }

  /// Have a finer grid stand around a point, as far as it stays within the first one or half a cell outside, where it is more than a cell
  /// off or at once. Returns by how many of its cells it moved.
  glm::ivec3 Follow(int number, const glm::dvec3& center, bool atOnce);

private:
  int Scale(int number) const;
  double Shift(int number) const;

  ProbeGrid First;
  int Number = 1;
  int Refinement = 2;
  std::array<glm::ivec3, Most>
    Bases{}; ///< of their first probes, in their own cells from the first grid's, and Shift()
};
}
