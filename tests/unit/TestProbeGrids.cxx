// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Probe grids, parts of them, and the layout of their maps in textures.
 */
#include "probes/ProbeUniforms.h"

#include "vtkGIProbeBaker.h"

#include <gtest/gtest.h>

using namespace penumbra;

TEST(ProbeGrids, FindTheGridOfAProbe)
{
  ProbeGrid grid;
  grid.Counts = { 2, 3, 4 };
  ProbeGrid other;
  other.Counts = { 2, 2, 2 };
  const ProbeGrids grids(std::vector<ProbeGrid>{ grid, other });
  EXPECT_EQ(grids.Size(), 32);
  EXPECT_EQ(grids.Of(0), 0);
  EXPECT_EQ(grids.Of(23), 0);
  EXPECT_EQ(grids.Of(24), 1);
  EXPECT_EQ(grids.Of(31), 1);
  for (int probe = 0; probe < grid.Size(); ++probe)
  {
    EXPECT_EQ(grid.Probe(grid.Cell(probe)), probe);
  }
}

// The outermost probes of a part lie one cell outside its box, or half a cell outside the scene.
TEST(ProbeGrids, APartEndsWhereTheSceneDoes)
{
  const std::array<double, 6> scene = { -3.0, 5.0, 0.0, 7.0, 10.0, 16.0 };
  const glm::dvec3 low(scene[0], scene[2], scene[4]);
  const glm::dvec3 high(scene[1], scene[3], scene[5]);
  const ProbeGrid grid = ProbeGrid::Around(scene, 200);
  const glm::dvec3 size = high - low;
  constexpr double off = 0.06; // tolerance of positions in cells
  for (int side = 0; side < 27; ++side)
  {
    const glm::ivec3 where(side % 3, side / 3 % 3, side / 9);
    const glm::dvec3 from = low + size * glm::dvec3(where) * 0.3;
    const glm::dvec3 to = glm::mix(from + 0.4 * size, high, glm::equal(where, glm::ivec3(2)));
    const ProbeGrid part = grid.Part(from, to, 500);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double before = (from[axis] - part.First[axis]) / part.Spacing[axis];
      const double after = (part.Last()[axis] - to[axis]) / part.Spacing[axis];
      EXPECT_NEAR(before, (where[axis] == 0 ? 0.5 : 1.0) - 0.5 * off, 0.5 * off) << side;
      // At the scene's upper sides the tolerance is that of the grid's larger cells.
      const double farther = where[axis] == 2 ? off * grid.Spacing[axis] / part.Spacing[axis] : 0.0;
      EXPECT_GT(after, where[axis] == 2 ? 0.5 : 1.0) << side;
      EXPECT_LT(after, (where[axis] == 2 ? 0.5 : 1.0) + off + farther) << side;
      // The same test as in glsl/probes/field.glsl.
      EXPECT_EQ(part.First[axis] <= grid.First[axis] + 0.5 * grid.Spacing[axis], where[axis] == 0);
      EXPECT_EQ(
        part.Last()[axis] >= grid.Last()[axis] - 0.5 * grid.Spacing[axis], where[axis] == 2);
    }
  }
}

TEST(ProbeLayout, EveryMapFitsIntoATextureOfTheGuaranteedSize)
{
  constexpr int texels = 18; // across a map of distances
  constexpr int widest = 16384;
  for (const int probes : { 1, 2, 27, 64, 65, 58240, 58241, 60000, 828099, 828100 })
  {
    for (const int maps :
      { probes, 2 * probes }) // live probes also keep the maps of their vacated grid points
    {
      const int columns = ProbeUniforms::Columns(probes);
      const int rows = ProbeUniforms::Rows(maps, columns);
      EXPECT_GE(static_cast<long long>(columns) * rows, maps);
      EXPECT_LT(static_cast<long long>(columns) * (rows - 1), maps) << "an empty row";
      EXPECT_LE(columns * texels, widest) << probes;
      if (maps == probes)
      {
        EXPECT_LE(rows * texels, widest) << probes;
      }
    }
  }
  EXPECT_EQ(vtkGIProbeBaker::MostProbes, 828100);
  EXPECT_GT(ProbeUniforms::Columns(vtkGIProbeBaker::MostProbes + 1) * texels, widest);
}
