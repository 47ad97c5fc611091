// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Positions of probes: a grid of nearly cubic cells around a box.
 */
#pragma once

#include <glm/glm.hpp>

#include <array>

namespace penumbra
{
struct ProbeGrid
{
  glm::dvec3 First{ 0.0 };   ///< position of the first probe, world
  glm::dvec3 Spacing{ 1.0 }; ///< between neighbours
  glm::ivec3 Counts{ 0 };
  /// Storage cell of the first probe. Probes are stored by their cells modulo Counts.
  glm::ivec3 Wrap{ 0 };

  int Size() const { return this->Counts.x * this->Counts.y * this->Counts.z; }
  double CellSize() const
  {
    return glm::min(this->Spacing.x, glm::min(this->Spacing.y, this->Spacing.z));
  }
  /// Distance below which probe light does not resolve occluders (measured, see docs/indirect-light.md).
  double Detail() const { return 0.125 * this->CellSize(); }
  /// Convert between a probe's number and its cell. Not valid for grids with Wrap.
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

  static constexpr int MinimumAround = 27; ///< probes: one inside, and the outermost
  static constexpr int MinimumPart = 64;   ///< two inside along each axis, and the outermost
  /// Position of the last probe.
  glm::dvec3 Last() const { return this->First + this->Spacing * glm::dvec3(this->Counts - 1); }

  /// A grid around bounds (in VTK's order) with a maximum number of probes, at least MinimumAround. The outermost
  /// probes lie half a cell outside, so that surfaces at the bounds have probes on both sides.
  static ProbeGrid Around(const std::array<double, 6>& bounds, int probes);

  /// A grid around bounds with a maximum spacing; empty if it would need more than the maximum number of probes.
  static ProbeGrid Spaced(const std::array<double, 6>& bounds, double spacing, int maximum);

  /// A finer grid around a box inside the bounds of this one, with a maximum number of probes, at least MinimumPart.
  /// The outermost probes lie one cell outside of the box, over which the part's light fades, but at most half a cell
  /// outside of the bounds.
  ProbeGrid Part(const glm::dvec3& low, const glm::dvec3& high, int probes) const;

  /// Whether the bounds lie inside the grid, and fill enough of it that a new grid would not be much finer.
  bool Suits(const std::array<double, 6>& bounds) const;
};
}
