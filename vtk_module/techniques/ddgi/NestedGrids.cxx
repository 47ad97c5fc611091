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
// About as many along each axis, but no more than fill the first grid at the least refinement.
glm::ivec3 FinerCounts(const ProbeGrid& first, int probes)
{
  const glm::ivec3 filling = static_cast<int>(NestedGrids::LeastRefinement) * first.Counts;
  glm::ivec3 counts(2);
  for (;;)
  {
    int least = -1;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool grows = counts[axis] < filling[axis] &&
        counts.x * counts.y * counts.z / counts[axis] * (counts[axis] + 1) <= probes;
      least = grows && (least < 0 || counts[axis] < counts[least]) ? axis : least;
    }
    if (least < 0)
    {
      return counts;
    }
    ++counts[least];
  }
}
}

NestedGrids::NestedGrids(const ProbeGrid& first, int count, int probes)
  : First(first)
  , Counts(FinerCounts(first, probes))
  , Number(count)
{
}

ProbeGrid NestedGrids::Get(int number) const
{
  ProbeGrid grid = this->First;
  if (number > 0)
  {
    // As the first, with the bounds, where walls are likely, in the middle between probes.
    grid.First += 0.5 * grid.Spacing;
    grid.Counts = this->Counts;
    grid.Spacing /= std::pow(this->Finer, number);
    grid.First += grid.Spacing * (0.5 + glm::dvec3(this->Bases[number]));
    grid.Wrap = (this->Bases[number] % grid.Counts + grid.Counts) % grid.Counts;
  }
  return grid;
}

ProbeGrids NestedGrids::List() const
{
  std::vector<ProbeGrid> grids;
  for (int number = 0; number < this->Number; ++number)
  {
    grids.push_back(this->Get(number));
  }
  return ProbeGrids(std::move(grids));
}

bool NestedGrids::Refine(double refinement)
{
  return std::exchange(this->Finer, refinement) != refinement;
}

double NestedGrids::RefinementFor(double size) const
{
  constexpr double steps = 4.0; // in a doubling
  constexpr double larger = 1.1;
  const glm::dvec3 sides = this->First.Spacing * glm::dvec3(this->Counts - 1);
  const double longest = std::max({ sides.x, sides.y, sides.z });
  const double suits =
    std::pow(longest / std::max(larger * size, 1e-30), 1.0 / std::max(this->Number - 1, 1));
  const bool nearly = suits > 0.96 * this->Finer && suits < 1.3 * this->Finer;
  const double step = std::exp2(std::floor(steps * std::log2(suits)) / steps);
  return nearly ? this->Finer : std::clamp(step, LeastRefinement, MostRefinement);
}

glm::ivec3 NestedGrids::Follow(int number, const glm::dvec3& center, bool atOnce)
{
  const ProbeGrid grid = this->Get(number);
  const glm::dvec3 cells(grid.Counts - 1);
  const glm::dvec3 bound = this->First.First + 0.5 * this->First.Spacing;
  const glm::dvec3 size = this->First.Spacing * glm::dvec3(this->First.Counts - 2);
  const glm::dvec3 least(-1.0);
  const glm::dvec3 most = glm::max(glm::ceil(size / grid.Spacing - 1e-6) - cells, least);
  const glm::dvec3 low = (center - bound) / grid.Spacing - 0.5 - 0.5 * cells;
  const glm::ivec3 wanted(glm::clamp(glm::round(low), least, most));
  glm::ivec3& base = this->Bases[number];
  const glm::ivec3 off = wanted - base;
  if (!atOnce && glm::all(glm::lessThanEqual(glm::abs(off), glm::ivec3(1))))
  {
    return glm::ivec3(0);
  }
  base = wanted;
  return off;
}
}
