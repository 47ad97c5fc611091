// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/Overlap.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace penumbra::lightmap
{
bool Overlap(const Flat& a, const Flat& b, double tolerance)
{
  // Two convex shapes are separate if a line along an edge of either lies between them (separating axes).
  for (const Flat* shape : { &a, &b })
  {
    for (int k = 0; k < 3; ++k)
    {
      const glm::dvec2 edge = (*shape)[(k + 1) % 3] - (*shape)[k];
      const double length = glm::length(edge);
      if (!(length > 0.0))
      {
        return false; // no area
      }
      const glm::dvec2 across = glm::dvec2(-edge.y, edge.x) / length;
      double range[2][2] = { { 1e300, -1e300 }, { 1e300, -1e300 } };
      for (int i = 0; i < 3; ++i)
      {
        const double there[2] = { glm::dot(across, a[i]), glm::dot(across, b[i]) };
        for (int s = 0; s < 2; ++s)
        {
          range[s][0] = std::min(range[s][0], there[s]);
          range[s][1] = std::max(range[s][1], there[s]);
        }
      }
      if (std::min(range[0][1], range[1][1]) - std::max(range[0][0], range[1][0]) <= tolerance)
      {
        return false;
      }
    }
  }
  return true;
}

template <typename Visit>
void FlatSet::ForCells(const Flat& triangle, const Visit& visit) const
{
  const glm::dvec2 low = glm::min(glm::min(triangle[0], triangle[1]), triangle[2]) / this->Cell;
  const glm::dvec2 high = glm::max(glm::max(triangle[0], triangle[1]), triangle[2]) / this->Cell;
  for (auto y = static_cast<std::int64_t>(std::floor(low.y)); double(y) <= high.y; ++y)
  {
    for (auto x = static_cast<std::int64_t>(std::floor(low.x)); double(x) <= high.x; ++x)
    {
      visit(static_cast<std::uint64_t>(y) << 32 ^ (static_cast<std::uint64_t>(x) & 0xffffffffu));
    }
  }
}

std::size_t FlatSet::CountHits(const Flat& triangle) const
{
  std::set<std::uint32_t> hits;
  this->ForCells(triangle, [&](std::uint64_t cell) {
    const auto found = this->Cells.find(cell);
    if (found == this->Cells.end())
    {
      return;
    }
    for (const std::uint32_t other : found->second)
    {
      if (Overlap(triangle, this->All[other], this->Tolerance))
      {
        hits.insert(other);
      }
    }
  });
  return hits.size();
}

void FlatSet::Add(const Flat& triangle)
{
  const auto index = static_cast<std::uint32_t>(this->All.size());
  this->All.push_back(triangle);
  this->ForCells(triangle, [&](std::uint64_t cell) { this->Cells[cell].push_back(index); });
}
}
