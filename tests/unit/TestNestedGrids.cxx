// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where grids of probes stand within each other, and that probes stay where they are when grids move.
 */
#include "private/NestedGrids.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

using namespace penumbra;

namespace
{
const ProbeGrid Around = ProbeGrid::Around({ { -4.0, 4.0, -2.0, 2.0, 0.0, 3.0 } }, 300);

// As glsl/probes/field.glsl has it.
glm::ivec3 Stored(const NestedGrids& grids, int number, const glm::ivec3& cell)
{
  return (cell + grids.Wrap(number)) % Around.Counts;
}

template <typename Visit>
void ForCells(Visit visit)
{
  for (int i = 0; i < Around.Size(); ++i)
  {
    const glm::ivec3& n = Around.Counts;
    visit(glm::ivec3(i % n.x, i / n.x % n.y, i / n.x / n.y));
  }
}
}

TEST(NestedGrids, FinerOnesStayWithinTheFirst)
{
  for (const int refinement : { 2, 3, 8 })
  {
    NestedGrids grids(Around, 4, refinement);
    EXPECT_EQ(grids.Size(), 4 * Around.Size());
    double scale = 1.0;
    for (int number = 0; number < 4; ++number, scale *= refinement)
    {
      for (const double at : { -100.0, 0.3, 100.0 })
      {
        if (number > 0)
        {
          grids.Follow(number, glm::dvec3(at), false);
        }
        const ProbeGrid grid = grids.Get(number);
        EXPECT_EQ(grid.Counts, Around.Counts);
        for (int axis = 0; axis < 3; ++axis)
        {
          EXPECT_NEAR(grid.Spacing[axis], Around.Spacing[axis] / scale, 1e-12);
          const double outside = number > 0 ? 0.5001 * grid.Spacing[axis] : 1e-9;
          EXPECT_GE(grid.First[axis], Around.First[axis] - outside);
          EXPECT_LE(grid.Last()[axis], Around.Last()[axis] + outside);
        }
      }
    }
  }
}

TEST(NestedGrids, FollowAPointByWholeCells)
{
  NestedGrids grids(Around, 2, 4);
  const glm::dvec3 spacing = grids.Get(1).Spacing;
  const glm::dvec3 start = 0.5 * (grids.Get(1).First + grids.Get(1).Last());
  EXPECT_EQ(grids.Follow(1, start + 1.2 * spacing, false), glm::ivec3(0)); // near enough
  EXPECT_EQ(grids.Follow(1, start + 1.2 * spacing, true), glm::ivec3(1));
  const glm::dvec3 before = grids.Get(1).First;
  EXPECT_EQ(
    grids.Follow(1, start + spacing * glm::dvec3(4.1, 0.9, -2.1), false), glm::ivec3(3, 0, -3));
  const glm::dvec3 moved = (grids.Get(1).First - before) / spacing;
  EXPECT_NEAR(glm::length(moved - glm::dvec3(3.0, 0.0, -3.0)), 0.0, 1e-9);
}

TEST(NestedGrids, ProbesStayInTheirStorage)
{
  NestedGrids grids(Around, 3, 2);
  std::map<std::tuple<long, long, long>, glm::ivec3> places; // by storage
  const auto place = [&](const glm::ivec3& cell) {
    const ProbeGrid grid = grids.Get(2);
    return glm::ivec3(glm::round((grid.First - Around.First) / grid.Spacing)) + cell;
  };
  const auto key = [](const glm::ivec3& at) { return std::make_tuple(at.x, at.y, at.z); };
  ForCells([&](const glm::ivec3& cell) { places[key(Stored(grids, 2, cell))] = place(cell); });
  EXPECT_EQ(static_cast<int>(places.size()), Around.Size()); // one for each
  const ProbeGrid before = grids.Get(2);
  const glm::dvec3 middle = 0.5 * (before.First + before.Last());
  const glm::ivec3 moved =
    grids.Follow(2, middle + glm::dvec3(3.0, -1.0, 1.0) * before.Spacing, false);
  EXPECT_NE(moved, glm::ivec3(0));
  int kept = 0;
  ForCells([&](const glm::ivec3& cell) {
    const glm::ivec3 old = cell + moved;
    if (glm::all(glm::greaterThanEqual(old, glm::ivec3(0))) &&
      glm::all(glm::lessThan(old, Around.Counts)))
    {
      ++kept;
      EXPECT_EQ(places[key(Stored(grids, 2, cell))], place(cell));
    }
  });
  EXPECT_GT(kept, 0);
  EXPECT_LT(kept, Around.Size());
}
