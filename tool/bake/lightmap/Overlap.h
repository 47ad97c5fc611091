// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Triangles in a plane, and which of them overlap.
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace penumbra::lightmap
{
using Flat = std::array<glm::dvec2, 3>;

/// Whether two triangles have more in common than what rounding leaves along an edge.
bool Overlap(const Flat& a, const Flat& b, double tolerance);

/// Triangles that were put down, found again by where they lie.
class FlatSet
{
public:
  /// cell: about the size of triangles; tolerance: as Overlap()'s.
  FlatSet(double cell, double tolerance)
    : Cell(cell)
    , Tolerance(tolerance)
  {
  }
  /// How many of those put down overlap this one.
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
