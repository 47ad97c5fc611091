// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/RayTree.h"

#include "base/Parallel.h"
#include "rays/RayTreeBuilder.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <string>

namespace penumbra
{
float RayBounds::LargestCoordinate() const
{
  const glm::vec3 size = glm::max(glm::abs(this->Lower), glm::abs(this->Upper));
  return std::max(size.x, std::max(size.y, size.z));
}

float RayTree::Margin(const RayBounds& all)
{
  return all.IsEmpty() ? 0.0f : std::max(std::ldexp(all.LargestCoordinate(), -23), 1e-30f);
}

std::int32_t RayTree::Moved(std::int32_t reference, std::int32_t nodes, std::int32_t records)
{
  // A leaf is ~(8 * first + n). In two's complement its first record can be offset without decoding it.
  return reference >= 0 ? reference + nodes : reference - (records << GI_RAY_LEAF_SHIFT);
}

namespace
{
std::int32_t Leaf(std::size_t first, std::size_t count)
{
  return ~static_cast<std::int32_t>((first << GI_RAY_LEAF_SHIFT) | (count - 1));
}

void SetBounds(shared::RayNode& node, int child, const RayBounds& bounds)
{
  (child == 0 ? node.Lower0 : node.Lower1) = bounds.Lower;
  (child == 0 ? node.Upper0 : node.Upper1) = bounds.Upper;
}

/// Writes a built tree depth first, so that the nodes of a path are close together in memory.
class Flattener
{
public:
  Flattener(RayTree& tree, float margin)
    : Tree(tree)
    , Margin(margin)
  {
  }

  void Write(const RayBuildNode* root)
  {
    // An explicit stack, as recursion would be as deep as the tree.
    struct Place
    {
      const RayBuildNode* From;
      std::int32_t Parent;
      int Child;
      int Depth;
    };
    std::vector<Place> open{ { root, -1, 0, 1 } };
    while (!open.empty())
    {
      const Place place = open.back();
      open.pop_back();
      const std::int32_t reference = this->WriteOne(place.From);
      this->Tree.Depth = std::max(this->Tree.Depth, place.Depth);
      this->Link(place.Parent, place.Child, reference);
      if (!place.From->IsLeaf())
      {
        const auto* inner = static_cast<const RayBuildInner*>(place.From);
        open.push_back({ inner->Children[1], reference, 1, place.Depth + 1 });
        open.push_back({ inner->Children[0], reference, 0, place.Depth + 1 });
      }
    }
  }

private:
  std::int32_t WriteOne(const RayBuildNode* from)
  {
    if (from->IsLeaf())
    {
      const auto* leaf = static_cast<const RayBuildLeaf*>(from);
      const std::size_t first = this->Tree.Order.size();
      this->Tree.Order.insert(this->Tree.Order.end(), leaf->Items, leaf->Items + leaf->Count);
      return Leaf(first, from->Count);
    }
    const auto* inner = static_cast<const RayBuildInner*>(from);
    this->Tree.Nodes.emplace_back();
    shared::RayNode& node = this->Tree.Nodes.back();
    node.Unused0 = node.Unused1 = 0;
    SetBounds(node, 0, inner->Bounds[0].Grown(this->Margin));
    SetBounds(node, 1, inner->Bounds[1].Grown(this->Margin));
    return static_cast<std::int32_t>(this->Tree.Nodes.size() - 1);
  }

  void Link(std::int32_t parent, int child, std::int32_t reference)
  {
    if (parent < 0)
    {
      this->Tree.Root = reference;
    }
    else
    {
      shared::RayNode& node = this->Tree.Nodes[parent];
      (child == 0 ? node.Child0 : node.Child1) = reference;
    }
  }

  RayTree& Tree;
  float Margin;
};
}

void RayTree::Build(const std::vector<RayBounds>& items, int leafSize, int depthLimit)
{
  *this = RayTree();
  std::size_t count = 0;
  std::mutex adding;
  ParallelFor(items.size(), [&](std::size_t begin, std::size_t end) {
    RayBounds bounds;
    std::size_t present = 0;
    for (std::size_t i = begin; i < end; ++i)
    {
      bounds.Add(items[i]); // an empty one changes nothing
      present += items[i].IsEmpty() ? 0 : 1;
    }
    const std::lock_guard<std::mutex> lock(adding);
    this->Bounds.Add(bounds);
    count += present;
  });
  if (count == 0)
  {
    return;
  }
  this->Order.reserve(count);
  this->Nodes.reserve(count / 2 + 1);
  const RayTreeBuilder built(items, count, leafSize, depthLimit);
  Flattener(*this, Margin(this->Bounds)).Write(built.Root());
  if (this->Depth > depthLimit)
  {
    // Halving gets this deep only with more items than the limits in ray_scene.h allow.
    throw std::runtime_error("the scene is too large to trace rays against: a tree over " +
      std::to_string(count) + " items is deeper than the " + std::to_string(depthLimit) +
      " levels that the shaders can walk; show fewer instances.");
  }
}

void RayTree::Refit(const std::vector<RayBounds>& items)
{
  this->Bounds = RayBounds();
  for (const std::uint32_t item : this->Order)
  {
    this->Bounds.Add(items[item]);
  }
  const float margin = Margin(this->Bounds);
  // Children come after their parents, so go backwards.
  for (std::size_t i = this->Nodes.size(); i-- > 0;)
  {
    shared::RayNode& node = this->Nodes[i];
    for (int child = 0; child < 2; ++child)
    {
      const std::int32_t reference = child == 0 ? node.Child0 : node.Child1;
      RayBounds bounds;
      if (reference >= 0)
      {
        const shared::RayNode& below = this->Nodes[reference];
        bounds.Add({ below.Lower0, below.Upper0 });
        bounds.Add({ below.Lower1, below.Upper1 });
      }
      else
      {
        const std::int32_t first = ~reference >> GI_RAY_LEAF_SHIFT;
        const std::int32_t last = first + (~reference & (GI_RAY_LEAF_SIZE - 1));
        for (std::int32_t j = first; j <= last; ++j)
        {
          bounds.Add(items[this->Order[j]]);
        }
        bounds = bounds.IsEmpty() ? bounds : bounds.Grown(margin);
      }
      SetBounds(node, child, bounds);
    }
  }
}
}
