// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Positions of nested probe grids, and that probes keep their storage when grids move.
 */
#include "techniques/ddgi/NestedGrids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

using namespace penumbra;

namespace
{
const ProbeGrid Around = ProbeGrid::Around({ { -4.0, 4.0, -2.0, 2.0, 0.0, 3.0 } }, 300);

// As in glsl/probes/field.glsl.
glm::ivec3 Stored(const NestedGrids& grids, int number, const glm::ivec3& cell)
{
  return (cell + grids.Get(number).Wrap) % grids.Get(number).Counts;
}

template <typename Visit>
void ForCells(const ProbeGrid& grid, Visit visit)
{
  for (int i = 0; i < grid.Size(); ++i)
  {
    const glm::ivec3& n = grid.Counts;
    visit(glm::ivec3(i % n.x, i / n.x % n.y, i / n.x / n.y));
  }
}
}

TEST(NestedGrids, FinerGridsStayWithinTheFirst)
{
  for (const double refinement : { 2.0, 2.8, 8.0 })
  {
    NestedGrids grids(Around, 4, 280);
    grids.SetRefinement(refinement);
    EXPECT_LE(grids.List().Size(), Around.Size() + 3 * 280);
    EXPECT_GT(grids.List().Size(), Around.Size() + 3 * 200);
    int begin = 0;
    double scale = 1.0;
    for (int number = 0; number < 4; ++number, scale *= refinement)
    {
      EXPECT_EQ(grids.List().Begin(number), begin);
      EXPECT_EQ(grids.List().Of(begin), number);
      begin += grids.Get(number).Size();
      for (const double at : { -100.0, 0.3, 100.0 })
      {
        if (number > 0)
        {
          grids.Follow(number, glm::dvec3(at), false);
        }
        const ProbeGrid grid = grids.Get(number);
        for (int axis = 0; axis < 3; ++axis)
        {
          EXPECT_NEAR(grid.Spacing[axis], Around.Spacing[axis] / scale, 1e-12);
          // The first grid ends half a cell outside the scene, each other grid at most one and a half of its own cells.
          const double scene = 0.5 * Around.Spacing[axis];
          const double outside = number > 0 ? 1.5001 * grid.Spacing[axis] - scene : 1e-9;
          EXPECT_GE(grid.First[axis], Around.First[axis] - outside);
          EXPECT_LE(grid.Last()[axis], Around.Last()[axis] + outside);
        }
      }
    }
  }
}

TEST(NestedGrids, FollowAPointByWholeCells)
{
  NestedGrids grids(Around, 2, 280);
  grids.SetRefinement(4);
  grids.Follow(1, 0.5 * (Around.First + Around.Last()), true);
  const glm::dvec3 spacing = grids.Get(1).Spacing;
  const glm::dvec3 start = 0.5 * (grids.Get(1).First + grids.Get(1).Last());
  EXPECT_EQ(grids.Follow(1, start + 1.2 * spacing, false), glm::ivec3(0)); // still close enough
  EXPECT_EQ(grids.Follow(1, start + 1.2 * spacing, true), glm::ivec3(1));
  const glm::dvec3 before = grids.Get(1).First;
  EXPECT_EQ(
    grids.Follow(1, start + spacing * glm::dvec3(4.1, 0.9, -2.1), false), glm::ivec3(3, 0, -3));
  const glm::dvec3 moved = (grids.Get(1).First - before) / spacing;
  EXPECT_NEAR(glm::length(moved - glm::dvec3(3.0, 0.0, -3.0)), 0.0, 1e-9);
}

TEST(NestedGrids, ProbesStayInTheirStorage)
{
  NestedGrids grids(Around, 3, 280);
  grids.SetRefinement(3);
  const ProbeGrid before = grids.Get(2);
  grids.Follow(2, 0.5 * (Around.First + Around.Last()), true);
  std::map<std::tuple<long, long, long>, glm::ivec3> gridPoints; // by storage
  const auto gridPoint = [&](const glm::ivec3& cell) {
    const ProbeGrid grid = grids.Get(2);
    return glm::ivec3(glm::round((grid.First - Around.First) / grid.Spacing)) + cell;
  };
  const auto key = [](const glm::ivec3& at) { return std::make_tuple(at.x, at.y, at.z); };
  ForCells(before,
    [&](const glm::ivec3& cell) { gridPoints[key(Stored(grids, 2, cell))] = gridPoint(cell); });
  EXPECT_EQ(static_cast<int>(gridPoints.size()), before.Size()); // no two share storage
  const glm::dvec3 middle = 0.5 * (Around.First + Around.Last());
  const glm::ivec3 moved =
    grids.Follow(2, middle + glm::dvec3(3.0, -1.0, 1.0) * before.Spacing, false);
  EXPECT_NE(moved, glm::ivec3(0));
  int kept = 0;
  ForCells(before, [&](const glm::ivec3& cell) {
    const glm::ivec3 previous = cell + moved;
    if (glm::all(glm::greaterThanEqual(previous, glm::ivec3(0))) &&
      glm::all(glm::lessThan(previous, before.Counts)))
    {
      ++kept;
      EXPECT_EQ(gridPoints[key(Stored(grids, 2, cell))], gridPoint(cell));
    }
  });
  EXPECT_GT(kept, 0);
  EXPECT_LT(kept, before.Size());
}

// In a long scene the finer grids are about as wide as they are long.
TEST(NestedGrids, FinerGridsAreNotAsLongAsTheScene)
{
  const ProbeGrid first = ProbeGrid::Around({ { 0.0, 1.0, -20.0, 0.0, 0.0, 1.0 } }, 500);
  const NestedGrids grids(first, 2, 500);
  const glm::dvec3 size = grids.Get(1).Last() - grids.Get(1).First;
  EXPECT_GE(size.x, 1.0);
  EXPECT_GE(size.z, 1.0);
  EXPECT_LT(size.y, 15.0);
}

TEST(NestedGrids, RefinementFollowsTheSizeOfTheView)
{
  NestedGrids grids(Around, 3, 280);
  for (const double size : { 1.2, 0.5, 0.2 })
  {
    grids.SetRefinement(grids.RefinementFor(size));
    const ProbeGrid finest = grids.Get(2);
    const glm::dvec3 sides = finest.Last() - finest.First;
    const double longest = std::max({ sides.x, sides.y, sides.z });
    EXPECT_GT(longest, 0.8 * size);
    EXPECT_LT(longest, 3.0 * size);
  }
  // Hysteresis: slightly smaller and larger views do not change the refinement.
  grids.SetRefinement(3.0);
  const ProbeGrid finest = grids.Get(2);
  const glm::dvec3 sides = finest.Last() - finest.First;
  const double longest = std::max({ sides.x, sides.y, sides.z });
  EXPECT_EQ(grids.RefinementFor(longest / 1.1 * 0.8), 3.0);
  EXPECT_EQ(grids.RefinementFor(longest / 1.1 * 1.05), 3.0);
  EXPECT_GT(grids.RefinementFor(longest / 1.1 * 0.5), 3.5);
  EXPECT_LT(grids.RefinementFor(longest / 1.1 * 1.3), 3.0);
}
