// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The tree above emitting triangles, as shaders read it.
#include "rays/EmitterTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <vector>

namespace
{
using namespace penumbra;

std::vector<EmittingTriangle> Scattered(int count)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1.0, 3.0);
  std::vector<EmittingTriangle> triangles;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 at(place(random), place(random), place(random));
    triangles.push_back({ { at, at + glm::dvec3(0.01, 0.0, 0.0), at + glm::dvec3(0.0, 0.01, 0.0) },
      1.0 + i % 5, i % 3, i });
  }
  return triangles;
}

// The children of a node are in the record behind the triangles, in A and B, with radii in C.
struct Child
{
  glm::vec3 Center;
  double Radius;
  double Share;
};

Child ChildOf(const std::vector<shared::RayEmitter>& records, std::size_t count, std::size_t node)
{
  const shared::RayEmitter& pair = records[count + node / 2 - 1];
  const glm::vec4 place = node % 2 == 0 ? pair.A : pair.B;
  return { glm::vec3(place), node % 2 == 0 ? pair.C.x : pair.C.y, place.w };
}
}

TEST(EmitterTree, HasNoRecordWithoutTriangles)
{
  EXPECT_TRUE(MakeEmitterTree({}).empty());
  EXPECT_EQ(EmitterTreeLevels(0), 0);
}

TEST(EmitterTree, OfOneTriangleIsTheTriangle)
{
  const auto records = MakeEmitterTree(Scattered(1));
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(EmitterTreeLevels(1), 0);
  EXPECT_EQ(glm::floatBitsToInt(records[0].C.w), 0);
}

// Each triangle is there once, lies within every node above it, and has its share of the power.
TEST(EmitterTree, NodesContainTheirTriangles)
{
  for (const int count : { 2, 3, 8, 77, 1000 })
  {
    const auto triangles = Scattered(count);
    double total = 0.0;
    for (const EmittingTriangle& triangle : triangles)
    {
      total += triangle.Power;
    }
    const auto records = MakeEmitterTree(triangles);
    const int levels = EmitterTreeLevels(count);
    const std::size_t leaves = std::size_t(1) << levels;
    ASSERT_EQ(records.size(), count + leaves - 1);
    std::set<int> seen;
    double sum = 0.0;
    for (std::size_t leaf = 0; leaf < leaves; ++leaf)
    {
      const Child child = ChildOf(records, count, leaves + leaf);
      sum += child.Share;
      if (leaf >= static_cast<std::size_t>(count))
      {
        EXPECT_EQ(child.Share, 0.0);
        continue;
      }
      const int primitive = glm::floatBitsToInt(records[leaf].C.w);
      seen.insert(primitive);
      EXPECT_EQ(glm::floatBitsToInt(records[leaf].B.w), triangles[primitive].Surface);
      EXPECT_NEAR(child.Share, triangles[primitive].Power / total, 1e-6);
      for (std::size_t node = leaves + leaf; node > 1; node /= 2)
      {
        const Child above = ChildOf(records, count, node);
        for (const glm::dvec3& corner : triangles[primitive].Corners)
        {
          EXPECT_LE(glm::length(glm::vec3(corner) - above.Center), above.Radius + 1e-5);
        }
      }
    }
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(count));
    EXPECT_NEAR(sum, 1.0, 1e-5);
  }
}

// Neighbours in the tree are neighbours in space, or distance could not guide the choice.
TEST(EmitterTree, NodesAreSmall)
{
  constexpr int count = 4096;
  const auto records = MakeEmitterTree(Scattered(count));
  double mean = 0.0;
  for (std::size_t node = 512; node < 1024; ++node)
  {
    mean += ChildOf(records, count, node).Radius / 512.0;
  }
  // A cube with an eighth of the side of all, which has 512 of its kind, has a radius of 0.43.
  std::printf("mean radius of the nodes with 8 triangles: %.3f\n", mean);
  EXPECT_LT(mean, 0.6);
}

TEST(EmitterTree, TakesPointsThatCoincide)
{
  auto triangles = Scattered(5);
  for (EmittingTriangle& triangle : triangles)
  {
    triangle = { { glm::dvec3(1e6), glm::dvec3(1e6), glm::dvec3(1e6) }, 1.0, 0, 0 };
  }
  for (const shared::RayEmitter& record : MakeEmitterTree(triangles))
  {
    EXPECT_TRUE(std::isfinite(record.A.x) && std::isfinite(record.C.x));
  }
}
