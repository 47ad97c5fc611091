// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A binary tree over items with bounds, built by Embree's builder and laid out for
 * the shader.
 */
#pragma once

#include "ray_scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace penumbra
{
struct RayBounds
{
  glm::vec3 Lower{ 3e38f };
  glm::vec3 Upper{ -3e38f };

  void Add(const glm::vec3& point)
  {
    this->Lower = glm::min(this->Lower, point);
    this->Upper = glm::max(this->Upper, point);
  }
  void Add(const RayBounds& other)
  {
    this->Lower = glm::min(this->Lower, other.Lower);
    this->Upper = glm::max(this->Upper, other.Upper);
  }
  bool IsEmpty() const { return !(this->Lower.x <= this->Upper.x); }
  /// These bounds, extended on all sides.
  RayBounds Grown(float by) const { return { this->Lower - by, this->Upper + by }; }
  float LargestCoordinate() const;
};

/// Larger coordinates are treated as infinite. This is Embree's own limit (FLT_LARGE).
constexpr float RayCoordinateLimit = 1.8e18f;

struct RayTree
{
  /// Parents come before their children. Children and leaves count from 0 in this tree.
  std::vector<shared::RayNode> Nodes;
  /// Indices of items in the order of the leaves.
  std::vector<std::uint32_t> Order;
  std::int32_t Root = GI_RAY_DONE; ///< GI_RAY_DONE if there are no items
  int Depth = 0;
  RayBounds Bounds;

  /// Build the tree over the items with non-empty bounds.
  void Build(const std::vector<RayBounds>& items, int leafSize, int depthLimit);

  /// Update the bounds of nodes without changing the tree's structure. items: in the same order as for Build().
  void Refit(const std::vector<RayBounds>& items);

  /// Margin by which bounds are extended: a unit in the last place of the largest
  /// coordinate. It also ensures that a ray in a face of the bounds is not lost (rays/trace.glsl).
  static float Margin(const RayBounds& all);

  /// Reference to a leaf or node, offset by numbers of nodes and records.
  static std::int32_t Moved(std::int32_t reference, std::int32_t nodes, std::int32_t records);
};
}
