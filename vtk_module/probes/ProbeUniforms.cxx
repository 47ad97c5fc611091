// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "probes/ProbeUniforms.h"

#include <cmath>

namespace penumbra
{
int ProbeUniforms::Columns(int probes)
{
  return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(probes))));
}

int ProbeUniforms::Rows(int maps, int columns)
{
  return (maps + columns - 1) / columns;
}

Defines ProbeUniforms::Variant() const
{
  return this->Grids.Count() > 1 ? Defines{ { "GI_FIELD_NESTED", "1" } } : Defines{};
}

Arguments ProbeUniforms::ShaderArguments() const
{
  std::vector<glm::vec3> origins;
  std::vector<glm::vec3> spacings;
  std::vector<glm::ivec3> counts;
  std::vector<glm::ivec3> wraps;
  std::vector<int> begins;
  for (int i = 0; i < this->Grids.Count(); ++i)
  {
    const ProbeGrid& grid = this->Grids.Get(i);
    origins.emplace_back(grid.First - this->Origin);
    spacings.emplace_back(grid.Spacing);
    counts.push_back(grid.Counts);
    wraps.push_back(grid.Wrap);
    begins.push_back(this->Grids.Begin(i));
  }
  begins.push_back(this->Grids.Size());
  return Arguments()
    .Set("fieldGrids", this->Grids.Count())
    .Set("fieldOrigins", origins)
    .Set("fieldSpacings", spacings)
    .Set("fieldWraps", wraps)
    .Set("fieldCounts", counts)
    .Set("fieldBegins", begins)
    .Set("fieldColumns", Columns(this->Grids.Size()))
    .Set("fieldBias", this->Bias);
}
}
