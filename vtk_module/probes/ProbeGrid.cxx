// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "probes/ProbeGrid.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// Offset in cells from a centred grid. Scenes are made of round numbers, and a probe must not lie exactly on a surface.
const glm::dvec3 GridOffset(0.047, 0.053, 0.059);

glm::dvec3 CenterOf(const std::array<double, 6>& bounds)
{
  return 0.5 * glm::dvec3(bounds[0] + bounds[1], bounds[2] + bounds[3], bounds[4] + bounds[5]);
}

// A flat scene still gets a volume.
glm::dvec3 SizeOf(const std::array<double, 6>& bounds)
{
  const glm::dvec3 size(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  const double diagonal = std::max(glm::length(size), 1e-30);
  return glm::max(size, glm::dvec3(1e-3 * diagonal));
}

glm::dvec3 CellsOf(const glm::dvec3& size, double cell)
{
  return glm::max(glm::ceil(size / cell - 1e-9), glm::dvec3(1.0));
}

ProbeGrid FromCells(const std::array<double, 6>& bounds, const glm::dvec3& cells)
{
  ProbeGrid grid;
  grid.Counts = glm::ivec3(cells + 2.0);
  grid.Spacing = SizeOf(bounds) / cells;
  // Cells along a thin side of the scene are not much shorter than along the others.
  const double longest = std::max({ grid.Spacing.x, grid.Spacing.y, grid.Spacing.z });
  grid.Spacing = glm::max(grid.Spacing, glm::dvec3(0.5 * longest));
  grid.First = CenterOf(bounds) + grid.Spacing * (GridOffset - 0.5 * glm::dvec3(grid.Counts - 1));
  return grid;
}
}

ProbeGrid ProbeGrid::Around(const std::array<double, 6>& bounds, int probes)
{
  const glm::dvec3 size = SizeOf(bounds);
  double cell = std::cbrt(size.x * size.y * size.z / probes);
  for (;;)
  {
    const glm::dvec3 cells = CellsOf(size, cell);
    const glm::dvec3 counts = cells + 2.0;
    if (counts.x * counts.y * counts.z <= std::max(probes, MinimumAround))
    {
      return FromCells(bounds, cells);
    }
    cell *= 1.02;
  }
}

ProbeGrid ProbeGrid::Spaced(const std::array<double, 6>& bounds, double spacing, int maximum)
{
  const glm::dvec3 cells = CellsOf(SizeOf(bounds), spacing);
  const glm::dvec3 counts = cells + 2.0;
  return counts.x * counts.y * counts.z <= maximum ? FromCells(bounds, cells) : ProbeGrid();
}

ProbeGrid ProbeGrid::Part(const glm::dvec3& low, const glm::dvec3& high, int probes) const
{
  // glsl/probes/field.glsl decides in the same way which sides of a part lie outside of the scene.
  const glm::dvec3 lowest = this->First + 0.5 * this->Spacing;
  const glm::dvec3 highest = this->Last() - 0.5 * this->Spacing;
  const glm::dvec3 slack = 0.02 * this->Spacing;
  const glm::bvec3 first = glm::lessThan(low, lowest + slack);
  const glm::bvec3 last = glm::greaterThan(high, highest - GridOffset * this->Spacing - slack);
  const glm::dvec3 from = glm::mix(low, glm::min(low, lowest), first);
  const glm::dvec3 to = glm::mix(high, glm::max(high, highest), last);
  const glm::dvec3 before = glm::mix(glm::dvec3(1.0), glm::dvec3(0.5), first);
  const glm::dvec3 after = glm::mix(glm::dvec3(1.0), glm::dvec3(0.5), last);
  const glm::dvec3 size = to - from;
  double cell = std::cbrt(std::max(size.x * size.y * size.z, 1e-300) / probes);
  for (;;)
  {
    const glm::dvec3 cells = CellsOf(size, cell);
    const glm::dvec3 counts = cells + glm::ceil(before + after) + 1.0;
    if (counts.x * counts.y * counts.z <= std::max(probes, MinimumPart))
    {
      ProbeGrid grid;
      grid.Counts = glm::ivec3(counts);
      grid.Spacing = glm::max(size / (counts - 1.0 - before - after), glm::dvec3(0.5 * cell));
      grid.First = 0.5 *
        (from - before * grid.Spacing + to + after * grid.Spacing - grid.Spacing * (counts - 1.0));
      grid.First += grid.Spacing * GridOffset;
      return grid;
    }
    cell *= 1.02;
  }
}

bool ProbeGrid::Suits(const std::array<double, 6>& bounds) const
{
  constexpr double minimumFill = 0.7; // along each side
  const glm::dvec3 low(bounds[0], bounds[2], bounds[4]);
  const glm::dvec3 high(bounds[1], bounds[3], bounds[5]);
  const glm::dvec3 from = this->First;
  const glm::dvec3 to = this->Last();
  const glm::dvec3 slack = 1e-6 * (to - from);
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool inside =
      low[axis] >= from[axis] - slack[axis] && high[axis] <= to[axis] + slack[axis];
    const double fitted = this->Counts[axis] > 3 ? (to - from)[axis] - this->Spacing[axis] : 0.0;
    if (!inside || high[axis] - low[axis] < minimumFill * fitted)
    {
      return false;
    }
  }
  return true;
}
}
