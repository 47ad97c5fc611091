// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/NestedGrids.h"

namespace penumbra
{
NestedGrids::NestedGrids(const ProbeGrid& first, int count, int refinement)
  : First(first)
  , Number(count)
  , Refinement(refinement)
{
  for (int number = 1; number < count; ++number)
  {
    this->Follow(number, 0.5 * (first.First + first.Last()), true);
  }
}

int NestedGrids::Scale(int number) const
{
  int scale = 1;
  for (int i = 0; i < number; ++i)
  {
    scale *= this->Refinement;
  }
  return scale;
}

ProbeGrid NestedGrids::Get(int number) const
{
  ProbeGrid grid = this->First;
  grid.Spacing /= this->Scale(number);
  grid.First += grid.Spacing * (this->Shift(number) + glm::dvec3(this->Bases[number]));
  return grid;
}

// The first grid has the scene's bounds, where walls are likely, in the middle between probes; so do all.
double NestedGrids::Shift(int number) const
{
  return this->Scale(number) % 2 == 0 ? -0.5 : 0.0;
}

glm::ivec3 NestedGrids::Wrap(int number) const
{
  return this->Bases[number] % this->First.Counts;
}

glm::ivec3 NestedGrids::Follow(int number, const glm::dvec3& center, bool atOnce)
{
  const int scale = this->Scale(number);
  const glm::dvec3 spacing = this->First.Spacing / static_cast<double>(scale);
  const glm::ivec3 cells = this->First.Counts - 1;
  const double shift = this->Shift(number);
  const glm::dvec3 most = glm::dvec3(cells * (scale - 1)) - 2.0 * shift;
  const glm::dvec3 low = (center - this->First.First) / spacing - shift - 0.5 * glm::dvec3(cells);
  const glm::ivec3 wanted(glm::clamp(glm::round(low), glm::dvec3(0.0), most));
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
