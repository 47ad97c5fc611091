// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Overlaps between triangles in a plane.
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace penumbra::lightmap
{
using Flat = std::array<glm::dvec2, 3>;

/// Whether two triangles overlap by more than the tolerance for rounding along an edge.
bool Overlap(const Flat& a, const Flat& b, double tolerance);

/// A set of triangles, in cells of a grid.
class FlatSet
{
public:
  /// cell: about the size of triangles. tolerance: as for Overlap().
  FlatSet(double cell, double tolerance)
    : Cell(cell)
    , Tolerance(tolerance)
  {
  }
  /// The number of triangles in the set that overlap this one.
  std::size_t CountHits(const Flat& triangle) const;
  void Add(const Flat& triangle);

private:
  template <typename Visit>
  void ForCells(const Flat& triangle, const Visit& visit) const;

  double Cell;
  double Tolerance;
  std::vector<Flat> All;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> Cells;
};
}
