// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/RayTreeBuilder.h"

#include "base/Parallel.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#define PENUMBRA_EMBREE 1
#elif __has_include(<embree3/rtcore.h>)
#include <embree3/rtcore.h>
#define PENUMBRA_EMBREE 1
#endif

#include <algorithm>
#include <deque>
#include <new>

namespace penumbra
{
namespace
{
/// The items whose bounds are not empty.
std::vector<std::uint32_t> Present(const std::vector<RayBounds>& items, std::size_t count)
{
  std::vector<std::uint32_t> present;
  present.reserve(count);
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    if (!items[i].IsEmpty())
    {
      present.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return present;
}

struct Storage
{
  std::deque<RayBuildInner> Inner;
  std::deque<RayBuildLeaf> Leaves;
};

/// Halves the items by their centres along the longest axis. The depth is always logarithmic.
class Halver
{
public:
  Halver(const std::vector<RayBounds>& items, Storage& storage, int leafSize)
    : Items(items)
    , Output(storage)
    , LeafSize(leafSize)
  {
  }

  const RayBuildNode* Build(std::uint32_t* begin, std::uint32_t* end)
  {
    if (end - begin <= this->LeafSize)
    {
      RayBuildLeaf& leaf = this->Output.Leaves.emplace_back();
      leaf.Count = static_cast<std::uint32_t>(end - begin);
      std::copy(begin, end, leaf.Items);
      return &leaf;
    }
    RayBounds centers;
    for (const std::uint32_t* item = begin; item != end; ++item)
    {
      centers.Add(this->Center(*item));
    }
    const glm::vec3 size = centers.Upper - centers.Lower;
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    std::uint32_t* middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [&](std::uint32_t a, std::uint32_t b) {
      return this->Center(a)[axis] < this->Center(b)[axis];
    });
    RayBuildInner& node = this->Output.Inner.emplace_back(); // a deque does not move its elements
    node.Bounds[0] = this->BoundsOf(begin, middle);
    node.Bounds[1] = this->BoundsOf(middle, end);
    node.Children[0] = this->Build(begin, middle);
    node.Children[1] = this->Build(middle, end);
    return &node;
  }

private:
  glm::vec3 Center(std::uint32_t item) const
  {
    return 0.5f * (this->Items[item].Lower + this->Items[item].Upper);
  }
  RayBounds BoundsOf(const std::uint32_t* begin, const std::uint32_t* end) const
  {
    RayBounds bounds;
    for (; begin != end; ++begin)
    {
      bounds.Add(this->Items[*begin]);
    }
    return bounds;
  }

  const std::vector<RayBounds>& Items;
  Storage& Output;
  std::ptrdiff_t LeafSize;
};

#ifdef PENUMBRA_EMBREE
/// One device for the process, as it owns threads.
RTCDevice Device()
{
  static const RTCDevice device = rtcNewDevice(nullptr);
  return device;
}

void* CreateNode(RTCThreadLocalAllocator allocator, unsigned int, void*)
{
  RayBuildNode* node =
    new (rtcThreadLocalAlloc(allocator, sizeof(RayBuildInner), 16)) RayBuildInner;
  return node;
}

/// Embree has the address of a node's base class.
RayBuildInner* Inner(void* node)
{
  return static_cast<RayBuildInner*>(static_cast<RayBuildNode*>(node));
}

void SetChildren(void* node, void** children, unsigned int count, void*)
{
  for (unsigned int i = 0; i < count; ++i)
  {
    Inner(node)->Children[i] = static_cast<const RayBuildNode*>(children[i]);
  }
}

void SetChildBounds(void* node, const RTCBounds** bounds, unsigned int count, void*)
{
  for (unsigned int i = 0; i < count; ++i)
  {
    const RTCBounds& b = *bounds[i];
    Inner(node)->Bounds[i] = { { b.lower_x, b.lower_y, b.lower_z },
      { b.upper_x, b.upper_y, b.upper_z } };
  }
}

void* CreateLeaf(
  RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* items, std::size_t count, void*)
{
  auto* leaf = new (rtcThreadLocalAlloc(allocator, sizeof(RayBuildLeaf), 16)) RayBuildLeaf;
  leaf->Count = static_cast<std::uint32_t>(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    leaf->Items[i] = items[i].primID;
  }
  return static_cast<RayBuildNode*>(leaf);
}
#endif
}

struct RayTreeBuilder::Internals
{
  Storage Halves;
#ifdef PENUMBRA_EMBREE
  RTCBVH Tree = nullptr;
  ~Internals()
  {
    if (this->Tree)
    {
      rtcReleaseBVH(this->Tree);
    }
  }
  const RayBuildNode* Build(
    const std::vector<RayBounds>& items, std::size_t count, int leafSize, int depthLimit)
  {
    if (!Device())
    {
      return nullptr;
    }
    // Not a vector, which would first clear the memory in a single thread.
    const std::unique_ptr<RTCBuildPrimitive[]> primitives(new RTCBuildPrimitive[count]);
    std::vector<std::uint32_t> present;
    if (count < items.size())
    {
      present = Present(items, count);
    }
    ParallelFor(count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::size_t item = present.empty() ? i : present[i];
        const glm::vec3& lower = items[item].Lower;
        const glm::vec3& upper = items[item].Upper;
        primitives[i] = { lower.x, lower.y, lower.z, 0, upper.x, upper.y, upper.z,
          static_cast<unsigned int>(item) };
      }
    });
    this->Tree = rtcNewBVH(Device());
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.maxBranchingFactor = 2;
    arguments.maxDepth = static_cast<unsigned int>(depthLimit);
    arguments.minLeafSize = 1;
    arguments.maxLeafSize = static_cast<unsigned int>(leafSize);
    // Leaves of about four items build a third faster than leaves of one or two, and trace as fast.
    arguments.sahBlockSize = 4;
    // Reading a record costs three gathers, a node four.
    arguments.traversalCost = 1.0f;
    arguments.intersectionCost = 1.0f;
    arguments.bvh = this->Tree;
    arguments.primitives = primitives.get();
    arguments.primitiveCount = count;
    arguments.primitiveArrayCapacity = count;
    arguments.createNode = CreateNode;
    arguments.setNodeChildren = SetChildren;
    arguments.setNodeBounds = SetChildBounds;
    arguments.createLeaf = CreateLeaf;
    return static_cast<const RayBuildNode*>(rtcBuildBVH(&arguments));
  }
#else
  const RayBuildNode* Build(const std::vector<RayBounds>&, std::size_t, int, int)
  {
    return nullptr;
  }
#endif
};

RayTreeBuilder::RayTreeBuilder(
  const std::vector<RayBounds>& items, std::size_t count, int leafSize, int depthLimit)
  : Impl(std::make_unique<Internals>())
{
  this->Top = this->Impl->Build(items, count, leafSize, depthLimit);
  if (!this->Top)
  {
    std::vector<std::uint32_t> order = Present(items, count);
    Halver halver(items, this->Impl->Halves, leafSize);
    this->Top = halver.Build(order.data(), order.data() + order.size());
  }
}

RayTreeBuilder::~RayTreeBuilder() = default;
}
