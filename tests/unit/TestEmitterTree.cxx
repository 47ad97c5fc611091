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

struct Child
{
  glm::vec3 Center;
  double Radius;
  double Share;
};

// A node below the root. Behind the triangles is a record for the children of each node.
Child ChildOf(const EmitterTree& tree, std::size_t count, std::size_t node)
{
  const shared::RayEmitter& four = tree.Records[count + (node - 1) / 4];
  const int i = static_cast<int>((node - 1) % 4);
  const glm::vec2 xy = glm::unpackUnorm2x16(glm::floatBitsToUint(four.B[i]));
  const glm::vec2 zr = glm::unpackUnorm2x16(glm::floatBitsToUint(four.C[i]));
  return { glm::vec3(tree.Cube) + tree.Cube.w * glm::vec3(xy, zr.x), tree.Cube.w * zr.y,
    four.A[i] };
}
}

TEST(EmitterTree, HasNoRecordWithoutTriangles)
{
  EXPECT_TRUE(MakeEmitterTree({}).Records.empty());
  EXPECT_EQ(MakeEmitterTree({}).Levels, 0);
}

TEST(EmitterTree, OfOneTriangleIsTheTriangle)
{
  const EmitterTree tree = MakeEmitterTree(Scattered(1));
  ASSERT_EQ(tree.Records.size(), 1u);
  EXPECT_EQ(tree.Levels, 0);
  EXPECT_EQ(glm::floatBitsToInt(tree.Records[0].C.w), 0);
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
    const EmitterTree tree = MakeEmitterTree(triangles);
    const std::vector<shared::RayEmitter>& records = tree.Records;
    const std::size_t leaves = std::size_t(1) << 2 * tree.Levels;
    const std::size_t inner = (leaves - 1) / 3;
    ASSERT_EQ(records.size(), count + inner);
    std::set<int> seen;
    double sum = 0.0;
    for (std::size_t leaf = 0; leaf < leaves; ++leaf)
    {
      const Child child = ChildOf(tree, count, inner + leaf);
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
      for (std::size_t node = inner + leaf; node > 0; node = (node - 1) / 4)
      {
        const Child above = ChildOf(tree, count, node);
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
  const EmitterTree tree = MakeEmitterTree(Scattered(count));
  double mean = 0.0;
  for (std::size_t node = 341; node < 341 + 1024; ++node)
  {
    mean += ChildOf(tree, count, node).Radius / 1024.0;
  }
  // 1024 cubes that fill that of all have a radius of 0.34.
  std::printf("mean radius of the nodes with 4 triangles: %.3f\n", mean);
  EXPECT_LT(mean, 0.47);
}

TEST(EmitterTree, TakesPointsThatCoincide)
{
  auto triangles = Scattered(5);
  for (EmittingTriangle& triangle : triangles)
  {
    triangle = { { glm::dvec3(1e6), glm::dvec3(1e6), glm::dvec3(1e6) }, 1.0, 0, 0 };
  }
  const EmitterTree tree = MakeEmitterTree(triangles);
  for (std::size_t node = 1; node <= 4 * (tree.Records.size() - triangles.size()); ++node)
  {
    const Child child = ChildOf(tree, triangles.size(), node);
    EXPECT_TRUE(
      std::isfinite(child.Center.x) && std::isfinite(child.Radius) && std::isfinite(child.Share));
  }
}
