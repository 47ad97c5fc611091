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

void ProbeUniforms::Set(const Program& program) const
{
  std::array<glm::vec3, ProbeGrids::Most> origins;
  std::array<glm::vec3, ProbeGrids::Most> spacings;
  std::array<glm::ivec3, ProbeGrids::Most> counts;
  std::array<glm::ivec3, ProbeGrids::Most> wraps;
  std::array<GLint, ProbeGrids::Most + 1> begins;
  const int count = this->Grids.Count();
  for (int i = 0; i < count; ++i)
  {
    const ProbeGrid& grid = this->Grids.Get(i);
    origins[i] = glm::vec3(grid.First - this->Origin);
    spacings[i] = glm::vec3(grid.Spacing);
    counts[i] = grid.Counts;
    wraps[i] = grid.Wrap;
    begins[i] = this->Grids.Begin(i);
  }
  begins[count] = this->Grids.Size();
  glUniform1i(program.Location("fieldGrids"), count);
  glUniform3fv(program.Location("fieldOrigins"), count, &origins[0][0]);
  glUniform3fv(program.Location("fieldSpacings"), count, &spacings[0][0]);
  glUniform3iv(program.Location("fieldWraps"), count, &wraps[0][0]);
  glUniform3iv(program.Location("fieldCounts"), count, &counts[0][0]);
  glUniform1iv(program.Location("fieldBegins"), count + 1, begins.data());
  glUniform1i(program.Location("fieldColumns"), Columns(this->Grids.Size()));
  glUniform1f(program.Location("fieldBias"), static_cast<GLfloat>(this->Bias));
}
}
