// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Builds a tree with Embree (3 or 4). If Embree fails, because bounds that it cannot distinguish
 * would make the tree too deep, or if it was not found at build time, the items are halved by position.
 */
#pragma once

#include "rays/RayTree.h"

#include <cstdint>
#include <memory>

namespace penumbra
{
/// A node with two children or a leaf with up to GI_RAY_LEAF_SIZE items.
struct RayBuildNode
{
  std::uint32_t Count = 0; ///< number of items of a leaf; 0 for a node with children
  bool IsLeaf() const { return this->Count > 0; }
};
struct RayBuildInner : RayBuildNode
{
  RayBounds Bounds[2];
  const RayBuildNode* Children[2] = { nullptr, nullptr };
};
struct RayBuildLeaf : RayBuildNode
{
  std::uint32_t Items[GI_RAY_LEAF_SIZE] = {};
};

class RayTreeBuilder
{
public:
  /// count: number of items whose bounds are not empty, at least 1.
  RayTreeBuilder(
    const std::vector<RayBounds>& items, std::size_t count, int leafSize, int depthLimit);
  ~RayTreeBuilder();
  RayTreeBuilder(const RayTreeBuilder&) = delete;
  RayTreeBuilder& operator=(const RayTreeBuilder&) = delete;

  const RayBuildNode* Root() const { return this->Top; }

private:
  struct Internals;
  std::unique_ptr<Internals> Impl;
  const RayBuildNode* Top = nullptr;
};
}
