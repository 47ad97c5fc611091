// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/EmitterTree.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace penumbra
{
namespace
{
struct Node
{
  glm::dvec3 Lower{ std::numeric_limits<double>::max() };
  glm::dvec3 Upper{ std::numeric_limits<double>::lowest() };
  double Power = 0.0;

  bool IsEmpty() const { return this->Lower.x > this->Upper.x; }
  glm::dvec3 Center() const
  {
    return this->IsEmpty() ? glm::dvec3(0.0) : 0.5 * (this->Lower + this->Upper);
  }
  double Radius() const
  {
    return this->IsEmpty() ? 0.0 : 0.5 * glm::length(this->Upper - this->Lower);
  }
  void Add(const glm::dvec3& point)
  {
    this->Lower = glm::min(this->Lower, point);
    this->Upper = glm::max(this->Upper, point);
  }
  void Add(const Node& other)
  {
    this->Lower = glm::min(this->Lower, other.Lower);
    this->Upper = glm::max(this->Upper, other.Upper);
    this->Power += other.Power;
  }
};

Node NodeOf(const EmittingTriangle& triangle)
{
  Node node;
  node.Power = triangle.Power;
  for (const glm::dvec3& corner : triangle.Corners)
  {
    node.Add(corner);
  }
  return node;
}

// Spreads the lowest 21 bits, with two zeros between each.
std::uint64_t Spread(std::uint64_t x)
{
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffffULL;
  x = (x | x << 16) & 0x1f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  return (x | x << 2) & 0x1249249249249249ULL;
}

// A cube around triangles. xyz: lowest corner, w: side.
glm::dvec4 CubeAround(const std::vector<EmittingTriangle>& triangles)
{
  Node all;
  for (const EmittingTriangle& triangle : triangles)
  {
    all.Add(NodeOf(triangle));
  }
  const glm::dvec3 size = all.Upper - all.Lower;
  return glm::dvec4(all.Lower, std::max({ size.x, size.y, size.z, 1e-300 }));
}

void SortAlongCurve(std::vector<EmittingTriangle>& triangles, const glm::dvec4& cube)
{
  std::vector<std::pair<std::uint64_t, std::size_t>> keys(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const glm::dvec3 at = (NodeOf(triangles[i]).Center() - glm::dvec3(cube)) / cube.w * 2097151.0;
    keys[i] = { Spread(static_cast<std::uint64_t>(at.x)) |
        Spread(static_cast<std::uint64_t>(at.y)) << 1 |
        Spread(static_cast<std::uint64_t>(at.z)) << 2,
      i };
  }
  std::sort(keys.begin(), keys.end());
  std::vector<EmittingTriangle> sorted;
  sorted.reserve(triangles.size());
  for (const auto& [key, index] : keys)
  {
    sorted.push_back(triangles[index]);
  }
  triangles = std::move(sorted);
}

// Four nodes as a shader reads them.
shared::RayEmitter Pack(const Node* nodes, double power, const glm::dvec4& cube)
{
  constexpr double steps = 65535.0;
  constexpr double rounding = 0.866 / steps; // bound on a packed centre's distance from the centre
  shared::RayEmitter record;
  for (int i = 0; i < 4; ++i)
  {
    const glm::vec3 center((nodes[i].Center() - glm::dvec3(cube)) / cube.w);
    const double radius = std::ceil((nodes[i].Radius() / cube.w + rounding) * steps) / steps;
    record.A[i] = static_cast<float>(nodes[i].Power / power);
    record.B[i] = glm::uintBitsToFloat(glm::packUnorm2x16(glm::vec2(center)));
    record.C[i] = glm::uintBitsToFloat(glm::packUnorm2x16(glm::vec2(center.z, radius)));
  }
  return record;
}
}

EmitterTree MakeEmitterTree(std::vector<EmittingTriangle> triangles)
{
  EmitterTree tree;
  if (triangles.empty())
  {
    return tree;
  }
  const glm::dvec4 cube = CubeAround(triangles);
  tree.Cube = glm::vec4(cube);
  SortAlongCurve(triangles, cube);
  for (const EmittingTriangle& triangle : triangles)
  {
    tree.Records.push_back({ glm::vec4(triangle.Corners[0], 0.0f),
      glm::vec4(triangle.Corners[1], glm::intBitsToFloat(triangle.Surface)),
      glm::vec4(triangle.Corners[2], glm::intBitsToFloat(triangle.Primitive)) });
  }
  std::size_t leaves = 1;
  for (; leaves < triangles.size(); leaves *= 4)
  {
    ++tree.Levels;
  }
  // The children of node i are 4 i + 1 to 4 i + 4; the root is node 0.
  const std::size_t inner = (leaves - 1) / 3;
  std::vector<Node> nodes(inner + leaves);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    nodes[inner + i] = NodeOf(triangles[i]);
  }
  for (std::size_t i = inner; i-- > 0;)
  {
    for (std::size_t child = 4 * i + 1; child <= 4 * i + 4; ++child)
    {
      nodes[i].Add(nodes[child]);
    }
  }
  for (std::size_t i = 0; i < inner; ++i)
  {
    tree.Records.push_back(Pack(&nodes[4 * i + 1], nodes[0].Power, cube));
  }
  return tree;
}
}
