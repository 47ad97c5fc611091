// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/ddgi/NestedGrids.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace penumbra
{
namespace
{
// Similar counts along all axes, but not more than fill the first grid at the smallest refinement.
glm::ivec3 FinerCounts(const ProbeGrid& first, int probes)
{
  const glm::ivec3 maximumCounts = static_cast<int>(NestedGrids::LeastRefinement) * first.Counts;
  glm::ivec3 counts(2);
  for (;;)
  {
    int smallest = -1;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool canGrow = counts[axis] < maximumCounts[axis] &&
        counts.x * counts.y * counts.z / counts[axis] * (counts[axis] + 1) <= probes;
      smallest = canGrow && (smallest < 0 || counts[axis] < counts[smallest]) ? axis : smallest;
    }
    if (smallest < 0)
    {
      return counts;
    }
    ++counts[smallest];
  }
}
}

NestedGrids::NestedGrids(const ProbeGrid& first, int count, int probes)
  : First(first)
  , Counts(FinerCounts(first, probes))
  , GridCount(count)
{
}

ProbeGrid NestedGrids::Get(int number) const
{
  ProbeGrid grid = this->First;
  if (number > 0)
  {
    // As in the first grid, the bounds, where walls are likely, lie midway between probes.
    grid.First += 0.5 * grid.Spacing;
    grid.Counts = this->Counts;
    grid.Spacing /= std::pow(this->Ratio, number);
    grid.First += grid.Spacing * (0.5 + glm::dvec3(this->Bases[number]));
    grid.Wrap = (this->Bases[number] % grid.Counts + grid.Counts) % grid.Counts;
  }
  return grid;
}

ProbeGrids NestedGrids::List() const
{
  std::vector<ProbeGrid> grids;
  for (int number = 0; number < this->GridCount; ++number)
  {
    grids.push_back(this->Get(number));
  }
  return ProbeGrids(std::move(grids));
}

bool NestedGrids::SetRefinement(double refinement)
{
  return std::exchange(this->Ratio, refinement) != refinement;
}

double NestedGrids::RefinementFor(double size) const
{
  constexpr double steps = 4.0; // per doubling
  constexpr double margin = 1.1;
  const glm::dvec3 sides = this->First.Spacing * glm::dvec3(this->Counts - 1);
  const double longest = std::max({ sides.x, sides.y, sides.z });
  const double exact =
    std::pow(longest / std::max(margin * size, 1e-30), 1.0 / std::max(this->GridCount - 1, 1));
  const bool isClose = exact > 0.96 * this->Ratio && exact < 1.3 * this->Ratio;
  const double rounded = std::exp2(std::floor(steps * std::log2(exact)) / steps);
  return isClose ? this->Ratio : std::clamp(rounded, LeastRefinement, MostRefinement);
}

glm::ivec3 NestedGrids::Follow(int number, const glm::dvec3& center, bool immediately)
{
  const ProbeGrid grid = this->Get(number);
  const glm::dvec3 cells(grid.Counts - 1);
  const glm::dvec3 bound = this->First.First + 0.5 * this->First.Spacing;
  const glm::dvec3 size = this->First.Spacing * glm::dvec3(this->First.Counts - 2);
  const glm::dvec3 lowest(-1.0);
  const glm::dvec3 highest = glm::max(glm::ceil(size / grid.Spacing - 1e-6) - cells, lowest);
  const glm::dvec3 low = (center - bound) / grid.Spacing - 0.5 - 0.5 * cells;
  const glm::ivec3 desired(glm::clamp(glm::round(low), lowest, highest));
  glm::ivec3& base = this->Bases[number];
  const glm::ivec3 shift = desired - base;
  if (!immediately && glm::all(glm::lessThanEqual(glm::abs(shift), glm::ivec3(1))))
  {
    return glm::ivec3(0);
  }
  base = desired;
  return shift;
}
}
