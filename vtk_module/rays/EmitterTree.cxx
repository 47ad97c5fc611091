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

void SortAlongCurve(std::vector<EmittingTriangle>& triangles)
{
  Node all;
  for (const EmittingTriangle& triangle : triangles)
  {
    all.Add(NodeOf(triangle));
  }
  const glm::dvec3 size = all.Upper - all.Lower;
  const double side = std::max({ size.x, size.y, size.z, 1e-300 });
  std::vector<std::pair<std::uint64_t, std::size_t>> keys(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const glm::dvec3 at = (NodeOf(triangles[i]).Center() - all.Lower) / side * 2097151.0;
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
}

int EmitterTreeLevels(std::size_t triangles)
{
  int levels = 0;
  while ((std::size_t(1) << levels) < triangles)
  {
    ++levels;
  }
  return levels;
}

std::vector<shared::RayEmitter> MakeEmitterTree(std::vector<EmittingTriangle> triangles)
{
  std::vector<shared::RayEmitter> records;
  if (triangles.empty())
  {
    return records;
  }
  SortAlongCurve(triangles);
  for (const EmittingTriangle& triangle : triangles)
  {
    records.push_back({ glm::vec4(triangle.Corners[0], 0.0f),
      glm::vec4(triangle.Corners[1], glm::intBitsToFloat(triangle.Surface)),
      glm::vec4(triangle.Corners[2], glm::intBitsToFloat(triangle.Primitive)) });
  }
  // The children of node i are 2 i and 2 i + 1; the root is node 1.
  const std::size_t leaves = std::size_t(1) << EmitterTreeLevels(triangles.size());
  std::vector<Node> nodes(2 * leaves);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    nodes[leaves + i] = NodeOf(triangles[i]);
  }
  for (std::size_t i = leaves - 1; i > 0; --i)
  {
    nodes[i] = nodes[2 * i];
    nodes[i].Add(nodes[2 * i + 1]);
  }
  const double total = nodes[1].Power;
  for (std::size_t i = 1; i < leaves; ++i)
  {
    const Node& first = nodes[2 * i];
    const Node& second = nodes[2 * i + 1];
    records.push_back({ glm::vec4(first.Center(), first.Power / total),
      glm::vec4(second.Center(), second.Power / total),
      glm::vec4(first.Radius(), second.Radius(), 0.0f, 0.0f) });
  }
  return records;
}
}
