// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/RayMesh.h"

#include "base/Parallel.h"
#include "rays/RaySplits.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

namespace penumbra
{
namespace
{
bool IsUsable(const glm::vec3& v)
{
  // NaN fails every comparison.
  return std::abs(v.x) < RayCoordinateLimit && std::abs(v.y) < RayCoordinateLimit &&
    std::abs(v.z) < RayCoordinateLimit;
}

/// Computes the bounds of primitives. They are empty for primitives that are not finite.
class Bounder
{
public:
  explicit Bounder(const RayGeometry& geometry)
    : Geometry(geometry)
  {
  }

  RayBounds operator()(std::size_t item) const
  {
    if (item < this->Geometry.Triangles.size())
    {
      return this->Triangle(this->Geometry.Triangles[item]);
    }
    item -= this->Geometry.Triangles.size();
    if (item < this->Geometry.Spheres.size())
    {
      const RaySphere& sphere = this->Geometry.Spheres[item];
      RayBounds bounds;
      Ball(bounds, sphere.Center, sphere.Radius);
      return bounds;
    }
    const RayCylinder& cylinder = this->Geometry.Cylinders[item - this->Geometry.Spheres.size()];
    RayBounds bounds;
    if (cylinder.End0 != cylinder.End1 && Ball(bounds, cylinder.End0, cylinder.Radius) &&
      !Ball(bounds, cylinder.End1, cylinder.Radius))
    {
      bounds = RayBounds();
    }
    return bounds;
  }

private:
  RayBounds Triangle(const glm::uvec3& corners) const
  {
    RayBounds bounds;
    for (int i = 0; i < 3; ++i)
    {
      if (corners[i] >= this->Geometry.Points.size() ||
        !IsUsable(this->Geometry.Points[corners[i]]))
      {
        return RayBounds();
      }
      bounds.Add(this->Geometry.Points[corners[i]]);
    }
    return bounds;
  }
  static bool Ball(RayBounds& bounds, const glm::vec3& center, float radius)
  {
    if (!IsUsable(center) || !(radius > 0.0f && radius < RayCoordinateLimit))
    {
      return false;
    }
    // Hits on the sphere are rounded too.
    const float grown = radius * 1.000001f;
    bounds.Add({ center - grown, center + grown });
    return true;
  }

  const RayGeometry& Geometry;
};

shared::RayPrimitive Record(const RayGeometry& geometry, std::size_t item)
{
  shared::RayPrimitive record{};
  record.Primitive = static_cast<std::int32_t>(item);
  const std::size_t triangles = geometry.Triangles.size();
  if (item < triangles)
  {
    const glm::uvec3& corners = geometry.Triangles[item];
    record.Kind = GI_RAY_TRIANGLE;
    record.A = geometry.Points[corners.x];
    record.B = geometry.Points[corners.y];
    record.C = geometry.Points[corners.z];
  }
  else if (item < triangles + geometry.Spheres.size())
  {
    const RaySphere& sphere = geometry.Spheres[item - triangles];
    record.Kind = GI_RAY_SPHERE;
    record.A = sphere.Center;
    record.Radius = sphere.Radius;
  }
  else
  {
    const RayCylinder& cylinder = geometry.Cylinders[item - triangles - geometry.Spheres.size()];
    record.Kind = cylinder.Capped ? GI_RAY_CAPPED_CYLINDER : GI_RAY_CYLINDER;
    record.A = cylinder.End0;
    record.B = cylinder.End1;
    record.Radius = cylinder.Radius;
  }
  return record;
}
}

void RayGeometry::SetPoints(const std::vector<glm::dvec3>& points)
{
  glm::dvec3 lower(HUGE_VAL);
  glm::dvec3 upper(-HUGE_VAL);
  for (const glm::dvec3& point : points)
  {
    if (std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z))
    {
      lower = glm::min(lower, point);
      upper = glm::max(upper, point);
    }
  }
  this->Origin = lower.x <= upper.x ? 0.5 * lower + 0.5 * upper : glm::dvec3(0.0);
  this->Points.resize(points.size());
  ParallelFor(points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      this->Points[i] = glm::vec3(points[i] - this->Origin);
    }
  });
}

RayMesh::RayMesh(const RayGeometry& geometry)
  : Center(geometry.Origin)
  , Triangles(geometry.Triangles.size())
  , Spheres(geometry.Spheres.size())
  , Cylinders(geometry.Cylinders.size())
{
  // A leaf's reference has 28 bits for its first record.
  if (geometry.Size() >= (std::size_t(1) << (31 - GI_RAY_LEAF_SHIFT)))
  {
    throw std::runtime_error("a dataset of " + std::to_string(geometry.Size()) +
      " primitives is too large to trace rays against; the limit is 268 million: split or decimate "
      "it.");
  }
  std::vector<RayBounds> bounds = this->ItemBounds(geometry);
  const std::vector<std::uint32_t> pieces = SplitLongTriangles(geometry, bounds);
  this->Split = !pieces.empty();
  // Pieces in a leaf have little in common. If most of the tree is pieces, leaves of one are tested less often.
  const int leafSize = pieces.size() > geometry.Size() / 2 ? 1 : GI_RAY_LEAF_SIZE;
  this->Bvh.Build(bounds, leafSize, GI_RAY_MESH_DEPTH);
  for (std::uint32_t& item : this->Bvh.Order)
  {
    item = item < geometry.Size() ? item : pieces[item - geometry.Size()];
  }
  this->WriteRecords(geometry, bounds);
}

bool RayMesh::Refit(const RayGeometry& geometry)
{
  if (geometry.Triangles.size() != this->Triangles || geometry.Spheres.size() != this->Spheres ||
    geometry.Cylinders.size() != this->Cylinders)
  {
    return false;
  }
  if (this->Split)
  {
    // The borders of pieces depend on the points.
    *this = RayMesh(geometry);
    return true;
  }
  const std::vector<RayBounds> bounds = this->ItemBounds(geometry);
  // A primitive that was not finite when the tree was built is not in it.
  std::size_t placed = 0;
  for (const std::uint32_t item : this->Bvh.Order)
  {
    placed += bounds[item].IsEmpty() ? 0 : 1;
  }
  if (placed + this->NotFinite != geometry.Size())
  {
    *this = RayMesh(geometry);
    return true;
  }
  this->Center = geometry.Origin;
  this->Bvh.Refit(bounds);
  this->WriteRecords(geometry, bounds);
  return true;
}

std::vector<RayBounds> RayMesh::ItemBounds(const RayGeometry& geometry)
{
  std::vector<RayBounds> bounds(geometry.Size());
  std::atomic<std::size_t> dropped{ 0 };
  ParallelFor(bounds.size(), [&](std::size_t begin, std::size_t end) {
    const Bounder bounder(geometry);
    std::size_t empty = 0;
    for (std::size_t i = begin; i < end; ++i)
    {
      bounds[i] = bounder(i);
      empty += bounds[i].IsEmpty() ? 1 : 0;
    }
    dropped += empty;
  });
  this->NotFinite = dropped;
  return bounds;
}

void RayMesh::WriteRecords(const RayGeometry& geometry, const std::vector<RayBounds>& bounds)
{
  this->Primitives.resize(this->Bvh.Order.size());
  ParallelFor(this->Primitives.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      const std::uint32_t item = this->Bvh.Order[i];
      // A primitive that is no longer finite becomes a triangle without area.
      this->Primitives[i] =
        bounds[item].IsEmpty() ? shared::RayPrimitive{} : Record(geometry, item);
    }
  });
}
}
