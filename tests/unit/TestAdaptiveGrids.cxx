// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Placement of finer probe grids by the distribution of errors.
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
  /// Add an error, spread evenly over random points in a box.
  Errors& In(const Bounds& box, double error, int points = 500)
  {
    for (int i = 0; i < points; ++i)
    {
      PointError point;
      for (int axis = 0; axis < 3; ++axis)
      {
        std::uniform_real_distribution<double> along(box[2 * axis], box[2 * axis + 1]);
        point.Position[axis] = along(this->Random);
      }
      point.Error = error / points;
      this->List.push_back(point);
    }
    return *this;
  }
  /// Add noise of mean zero to the error of each point.
  Errors& WithNoise(double deviation)
  {
    std::normal_distribution<double> noise(0.0, deviation);
    for (PointError& point : this->List)
    {
      point.Error += noise(this->Random);
    }
    return *this;
  }

  std::vector<PointError> List;

private:
  std::mt19937 Random{ 7 };
};

/// Whether the grid alone lights all points of the box.
bool Covers(const ProbeGrid& grid, const Bounds& box)
{
  bool covers = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = box[2 * axis] - Hall[2 * axis] > 1e-6 ? grid.Spacing[axis] : 0.0;
    const double high = Hall[2 * axis + 1] - box[2 * axis + 1] > 1e-6 ? grid.Spacing[axis] : 0.0;
    const double tolerance = 0.1 * grid.Spacing[axis];
    covers = covers && grid.First[axis] + low < box[2 * axis] + tolerance &&
      grid.Last()[axis] - high > box[2 * axis + 1] - tolerance;
  }
  return covers;
}

/// The inner nine tenths of a box along each axis. Its margin may be left out, as it contains little error.
Bounds Inner(Bounds box)
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

TEST(AdaptiveGrids, UniformErrorsNeedOneGrid)
{
  for (const double noise : { 0.0, 0.004 })
  {
    const Errors errors = Errors().In(Hall, 1.0, 2000).WithNoise(noise);
    const ProbeGrids grids = AdaptiveGrids(Hall, 1000, errors.List);
    EXPECT_EQ(grids.Count(), 1);
    EXPECT_EQ(grids.Size(), ProbeGrid::Around(Hall, 1000).Size());
  }
  EXPECT_EQ(AdaptiveGrids(Hall, 1000, {}).Count(), 1);
  EXPECT_EQ(AdaptiveGrids(Hall, 27, Errors().In(Hall, 1.0).List).Count(), 1);
}

TEST(AdaptiveGrids, AFinerGridEnclosesASmallRoom)
{
  const Bounds room = { 30.0, 34.0, 5.0, 10.0, 0.0, 3.0 };
  const double cell = ProbeGrid::Around(Hall, 1000).CellSize();
  for (const double noise : { 0.0, 0.001 })
  {
    const Errors errors = Errors().In(Hall, 0.2).In(room, 0.8).WithNoise(noise);
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
      covered = covered || Covers(grids.Get(i), Inner(room));
      EXPECT_LE(grids.Get(i).Detail(), grids.Get(i - 1).Detail());
    }
    EXPECT_TRUE(covered);
  }
}

TEST(AdaptiveGrids, SeveralRegionsGetAGridEach)
{
  const Bounds regions[2] = { { 2.0, 5.0, 2.0, 5.0, 0.0, 3.0 },
    { 33.0, 37.0, 22.0, 26.0, 5.0, 9.0 } };
  const Errors errors = Errors().In(Hall, 0.1).In(regions[0], 0.5).In(regions[1], 0.4);
  const ProbeGrids grids = AdaptiveGrids(Hall, 2000, errors.List);
  ASSERT_GT(grids.Count(), 2);
  EXPECT_LE(grids.Count(), ProbeGrids::Most);
  EXPECT_LE(grids.Size(), 2000);
  Print(grids);
  for (const Bounds& region : regions)
  {
    bool covered = false;
    for (int i = 1; i < grids.Count(); ++i)
    {
      covered = covered || Covers(grids.Get(i), Inner(region));
    }
    EXPECT_TRUE(covered);
  }
}

// A scene whose bounds have no height.
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

// A region whose share of the probes is too small for a grid leaves them to the other grids.
TEST(AdaptiveGrids, RegionsWithoutAGridTakeNoProbes)
{
  const Bounds regions[2] = { { 2.0, 6.0, 2.0, 6.0, 0.0, 4.0 },
    { 33.0, 35.0, 22.0, 24.0, 5.0, 7.0 } };
  const Errors errors = Errors().In(Hall, 0.1).In(regions[0], 0.7).In(regions[1], 0.2);
  ASSERT_EQ(AdaptiveGrids(Hall, 2000, errors.List).Count(), 3);
  for (const int probes : { 250, 275 })
  {
    const ProbeGrids grids = AdaptiveGrids(Hall, probes, errors.List);
    EXPECT_EQ(grids.Count(), 2);
    EXPECT_LE(grids.Size(), probes);
    EXPECT_GT(grids.Size(), 0.95 * probes);
  }
}

TEST(AdaptiveGrids, ClearlyLessMeansBeyondNoise)
{
  const auto less = [](Errors others, Errors errors) {
    return AreClearlyLess(others.List, errors.List);
  };
  const auto even = [](double error) { return Errors().In(Hall, error, 400); };
  EXPECT_TRUE(less(even(0.8), even(1.0)));
  EXPECT_FALSE(less(even(0.95), even(1.0)));
  EXPECT_FALSE(less(even(1.0), even(1.0)));
  EXPECT_FALSE(less(even(1.5), even(1.0)));
  // Sums that are not positive do not reverse the comparison: without an error there is nothing to gain.
  EXPECT_FALSE(less(even(0.0), even(0.0)));
  EXPECT_FALSE(less(even(-1.1), even(-1.0)));
  EXPECT_FALSE(less(even(-0.95), even(-1.0)));
  EXPECT_FALSE(less(even(-2.0), even(-1.0)));
  EXPECT_TRUE(less(even(-0.1), even(1.0)));
  // A standard deviation of 0.002 at each of 400 points gives one of 0.04 for their sum; 0.05 gives 1.
  EXPECT_TRUE(less(even(0.7).WithNoise(0.002), even(1.0)));
  EXPECT_FALSE(less(even(0.85).WithNoise(0.05), even(1.0)));
  // Noise that both have in common does not count.
  const Errors noisy = even(1.0).WithNoise(0.05);
  Errors half = noisy;
  for (PointError& point : half.List)
  {
    point.Error *= 0.5;
  }
  EXPECT_TRUE(less(half, noisy));
  EXPECT_FALSE(less(Errors(), Errors()));
  EXPECT_FALSE(less(Errors().In(Hall, 0.0, 1), Errors().In(Hall, 1.0, 1)));
}
