// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where finer grids of probes go, by where errors are.
 */
#include "techniques/sh_probes/AdaptiveGrids.h"

#include <gtest/gtest.h>

#include <random>

using namespace penumbra;

namespace
{
using Bounds = std::array<double, 6>;
constexpr Bounds Hall = { 0.0, 40.0, 0.0, 30.0, 0.0, 10.0 };

class Errors
{
public:
  /// So much error in a box, in many places.
  Errors& In(const Bounds& box, double error, int places = 500)
  {
    for (int i = 0; i < places; ++i)
    {
      PointError at;
      for (int axis = 0; axis < 3; ++axis)
      {
        std::uniform_real_distribution<double> along(box[2 * axis], box[2 * axis + 1]);
        at.Position[axis] = along(this->Chance);
      }
      at.Error = error / places;
      this->List.push_back(at);
    }
    return *this;
  }
  /// What chance adds to each, zero on the average.
  Errors& Shaken(double deviation)
  {
    std::normal_distribution<double> noise(0.0, deviation);
    for (PointError& at : this->List)
    {
      at.Error += noise(this->Chance);
    }
    return *this;
  }

  std::vector<PointError> List;

private:
  std::mt19937 Chance{ 7 };
};

/// All light of the box's points is told by the grid.
bool Covers(const ProbeGrid& grid, const Bounds& box)
{
  bool covers = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = box[2 * axis] - Hall[2 * axis] > 1e-6 ? grid.Spacing[axis] : 0.0;
    const double high = Hall[2 * axis + 1] - box[2 * axis + 1] > 1e-6 ? grid.Spacing[axis] : 0.0;
    const double slack = 0.1 * grid.Spacing[axis];
    covers = covers && grid.First[axis] + low < box[2 * axis] + slack &&
      grid.Last()[axis] - high > box[2 * axis + 1] - slack;
  }
  return covers;
}

/// Nine tenths of a box along each axis: little errs in its outermost part.
Bounds Middle(Bounds box)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double tenth = 0.1 * (box[2 * axis + 1] - box[2 * axis]);
    box[2 * axis] += box[2 * axis] > Hall[2 * axis] ? 0.5 * tenth : 0.0;
    box[2 * axis + 1] -= 0.5 * tenth;
  }
  return box;
}

void Print(const ProbeGrids& grids)
{
  for (int i = 0; i < grids.Count(); ++i)
  {
    const ProbeGrid& grid = grids.Get(i);
    const glm::dvec3 last = grid.Last();
    std::printf("%d x %d x %d probes, %.2f apart, from %.2f to %.2f, %.2f to %.2f, %.2f to %.2f\n",
      grid.Counts.x, grid.Counts.y, grid.Counts.z, grid.CellSize(), grid.First.x, last.x,
      grid.First.y, last.y, grid.First.z, last.z);
  }
}

}

TEST(AdaptiveGrids, ErrorsSpreadEvenlyNeedNoOthers)
{
  for (const double noise : { 0.0, 0.004 })
  {
    const Errors errors = Errors().In(Hall, 1.0, 2000).Shaken(noise);
    const ProbeGrids grids = AdaptiveGrids(Hall, 1000, errors.List);
    EXPECT_EQ(grids.Count(), 1);
    EXPECT_EQ(grids.Size(), ProbeGrid::Around(Hall, 1000).Size());
  }
  EXPECT_EQ(AdaptiveGrids(Hall, 1000, {}).Count(), 1);
  EXPECT_EQ(AdaptiveGrids(Hall, 27, Errors().In(Hall, 1.0).List).Count(), 1);
}

TEST(AdaptiveGrids, AFinerOneStandsAroundASmallRoom)
{
  const Bounds room = { 30.0, 34.0, 5.0, 10.0, 0.0, 3.0 };
  const double cell = ProbeGrid::Around(Hall, 1000).CellSize();
  for (const double noise : { 0.0, 0.001 })
  {
    const Errors errors = Errors().In(Hall, 0.2).In(room, 0.8).Shaken(noise);
    const ProbeGrids grids = AdaptiveGrids(Hall, 1000, errors.List);
    ASSERT_GT(grids.Count(), 1);
    EXPECT_LE(grids.Size(), 1000);
    EXPECT_GT(grids.Size(), 700);
    const ProbeGrid& finest = grids.Get(grids.Count() - 1);
    Print(grids);
    EXPECT_LT(finest.CellSize(), 0.4 * cell);
    EXPECT_LT(grids.Get(0).CellSize(), 2.0 * cell);
    bool covered = false;
    for (int i = 1; i < grids.Count(); ++i)
    {
      covered = covered || Covers(grids.Get(i), Middle(room));
      EXPECT_LE(grids.Get(i).Detail(), grids.Get(i - 1).Detail());
    }
    EXPECT_TRUE(covered);
  }
}

TEST(AdaptiveGrids, SeveralPlacesGetOneEach)
{
  const Bounds places[2] = { { 2.0, 5.0, 2.0, 5.0, 0.0, 3.0 },
    { 33.0, 37.0, 22.0, 26.0, 5.0, 9.0 } };
  const Errors errors = Errors().In(Hall, 0.1).In(places[0], 0.5).In(places[1], 0.4);
  const ProbeGrids grids = AdaptiveGrids(Hall, 2000, errors.List);
  ASSERT_GT(grids.Count(), 2);
  EXPECT_LE(grids.Count(), ProbeGrids::Most);
  EXPECT_LE(grids.Size(), 2000);
  Print(grids);
  for (const Bounds& place : places)
  {
    bool covered = false;
    for (int i = 1; i < grids.Count(); ++i)
    {
      covered = covered || Covers(grids.Get(i), Middle(place));
    }
    EXPECT_TRUE(covered);
  }
}

// A thing on a plane that has no height of its own.
TEST(AdaptiveGrids, FlatScenes)
{
  const Bounds flat = { -50.0, 50.0, -50.0, 50.0, 0.0, 0.0 };
  const Errors errors = Errors().In(flat, 0.1).In({ 1.0, 4.0, 2.0, 6.0, 0.0, 0.0 }, 0.9);
  const ProbeGrids grids = AdaptiveGrids(flat, 1000, errors.List);
  ASSERT_GT(grids.Count(), 1);
  EXPECT_LE(grids.Size(), 1000);
  for (int i = 0; i < grids.Count(); ++i)
  {
    EXPECT_GT(grids.Get(i).Detail(), 0.0);
    EXPECT_TRUE(glm::all(glm::greaterThanEqual(grids.Get(i).Counts, glm::ivec3(2))));
  }
}

// Places that are worth too few probes for a grid of their own leave them to the others.
TEST(AdaptiveGrids, NoProbesAreLostToPlacesThatGetNone)
{
  const Bounds places[2] = { { 2.0, 6.0, 2.0, 6.0, 0.0, 4.0 },
    { 33.0, 35.0, 22.0, 24.0, 5.0, 7.0 } };
  const Errors errors = Errors().In(Hall, 0.1).In(places[0], 0.7).In(places[1], 0.2);
  ASSERT_EQ(AdaptiveGrids(Hall, 2000, errors.List).Count(), 3);
  for (const int probes : { 250, 275 })
  {
    const ProbeGrids grids = AdaptiveGrids(Hall, probes, errors.List);
    EXPECT_EQ(grids.Count(), 2);
    EXPECT_LE(grids.Size(), probes);
    EXPECT_GT(grids.Size(), 0.95 * probes);
  }
}

TEST(AdaptiveGrids, ErrorsAreClearlyLessUnlessByChance)
{
  const auto less = [](Errors others, Errors errors) {
    return AreClearlyLess(others.List, errors.List);
  };
  const auto even = [](double error) { return Errors().In(Hall, error, 400); };
  EXPECT_TRUE(less(even(0.8), even(1.0)));
  EXPECT_FALSE(less(even(0.95), even(1.0)));
  EXPECT_FALSE(less(even(1.0), even(1.0)));
  EXPECT_FALSE(less(even(1.5), even(1.0)));
  // No sign turns it round: there is nothing to gain where nothing errs.
  EXPECT_FALSE(less(even(0.0), even(0.0)));
  EXPECT_FALSE(less(even(-1.1), even(-1.0)));
  EXPECT_FALSE(less(even(-0.95), even(-1.0)));
  EXPECT_FALSE(less(even(-2.0), even(-1.0)));
  EXPECT_TRUE(less(even(-0.1), even(1.0)));
  // A deviation of 0.002 at each of 400 places makes one of 0.04 of all, one of 0.05 makes one of 1.
  EXPECT_TRUE(less(even(0.7).Shaken(0.002), even(1.0)));
  EXPECT_FALSE(less(even(0.85).Shaken(0.05), even(1.0)));
  // What errs alike in both says nothing against the difference.
  const Errors shaken = even(1.0).Shaken(0.05);
  Errors half = shaken;
  for (PointError& at : half.List)
  {
    at.Error *= 0.5;
  }
  EXPECT_TRUE(less(half, shaken));
  EXPECT_FALSE(less(Errors(), Errors()));
  EXPECT_FALSE(less(Errors().In(Hall, 0.0, 1), Errors().In(Hall, 1.0, 1)));
}
