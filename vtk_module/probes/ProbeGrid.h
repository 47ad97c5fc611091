// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where probes stand: a grid of nearly cubic cells around a box.
 */
#pragma once

#include <glm/glm.hpp>

#include <array>

namespace penumbra
{
struct ProbeGrid
{
  glm::dvec3 First{ 0.0 };   ///< place of the first probe, world
  glm::dvec3 Spacing{ 1.0 }; ///< between neighbours
  glm::ivec3 Counts{ 0 };
  /// Place of the first probe in storage, where probes lie by their places modulo Counts.
  glm::ivec3 Wrap{ 0 };

  int Size() const { return this->Counts.x * this->Counts.y * this->Counts.z; }
  double CellSize() const
  {
    return glm::min(this->Spacing.x, glm::min(this->Spacing.y, this->Spacing.z));
  }
  /// Occlusion nearer than this is not in the light that probes know (measured, see docs/indirect-light.md).
  double Detail() const { return 0.125 * this->CellSize(); }
  /// The place of a probe among the others, and back. Not for probes that Wrap moves in storage.
  glm::ivec3 Cell(int probe) const
  {
    return { probe % this->Counts.x, probe / this->Counts.x % this->Counts.y,
      probe / this->Counts.x / this->Counts.y };
  }
  int Probe(const glm::ivec3& cell) const
  {
    return cell.x + this->Counts.x * (cell.y + this->Counts.y * cell.z);
  }
  bool IsEmpty() const { return this->Size() == 0; }

  static constexpr int LeastAround = 27; ///< probes: one within, and the outermost
  static constexpr int LeastPart = 64;   ///< two along each axis, and the outermost
  glm::dvec3 Last() const { return this->First + this->Spacing * glm::dvec3(this->Counts - 1); }

  /// Around bounds (as VTK's), with at most so many probes, or LeastAround. The outermost stand half a cell outside, so
  /// that surfaces at the bounds have probes on both sides.
  static ProbeGrid Around(const std::array<double, 6>& bounds, int probes);

  /// Likewise, with at most such distances between neighbours; empty where that takes more probes than most.
  static ProbeGrid Spaced(const std::array<double, 6>& bounds, double spacing, int most);

  /// Finer, with at most so many probes, or LeastPart, around a box within the bounds that this one is around. The outermost stand a
  /// cell outside, over which the light of a part fades, but not farther out of the bounds than half a cell.
  ProbeGrid Part(const glm::dvec3& low, const glm::dvec3& high, int probes) const;

  /// Whether the bounds lie within, and fill enough of it that a grid of their own would not be much finer.
  bool Suits(const std::array<double, 6>& bounds) const;
};
}
