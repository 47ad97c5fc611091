// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/Surfaces.h"

#include "scene/build/OpaqueMeshes.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>

namespace penumbra::lightmap
{
namespace
{
/// As giDecodeOctahedral in the shaders.
Vec3 UnpackNormal(std::uint32_t bits)
{
  const glm::dvec2 p = glm::dvec2(glm::unpackUnorm2x16(bits)) * 2.0 - 1.0;
  Vec3 n(p, 1.0 - std::abs(p.x) - std::abs(p.y));
  if (n.z < 0.0)
  {
    const glm::dvec2 side(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
    n = Vec3((1.0 - std::abs(n.y)) * side.x, (1.0 - std::abs(n.x)) * side.y, n.z);
  }
  return glm::normalize(n);
}
}

std::uint32_t Surfaces::FindOrAdd(const Vec3& point, int group)
{
  const auto next = static_cast<std::uint32_t>(this->Points.size());
  const auto found =
    this->PointIndex.emplace(std::array{ point.x, point.y, point.z, double(group) }, next);
  if (found.second)
  {
    this->Points.push_back(point);
  }
  return found.first->second;
}

bool Surfaces::Add(
  const std::array<Vec3, 3>& corners, const std::array<Vec3, 3>& normals, int group)
{
  const Vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double longest = std::max({ glm::length(corners[1] - corners[0]),
    glm::length(corners[2] - corners[1]), glm::length(corners[0] - corners[2]) });
  constexpr double thinnest = 1e-10; // the normals of thinner triangles are rounding errors
  const double doubleArea = glm::length(across);
  if (!std::isfinite(doubleArea) || !(doubleArea > thinnest * longest * longest))
  {
    return false;
  }
  Triangle triangle;
  triangle.Normal = across / doubleArea;
  triangle.Area = 0.5 * doubleArea;
  for (int k = 0; k < 3; ++k)
  {
    triangle.Points[k] = this->FindOrAdd(corners[k], group);
    const double length = glm::length(normals[k]);
    const Vec3 normal =
      length > 0.0 && std::isfinite(length) ? normals[k] / length : triangle.Normal;
    // Turned to the front.
    triangle.Normals[k] = glm::dot(normal, triangle.Normal) < 0.0 ? -normal : normal;
  }
  this->Triangles.push_back(triangle);
  return true;
}

vtkBoundingBox Surfaces::Bounds() const
{
  vtkBoundingBox bounds;
  for (const Vec3& point : this->Points)
  {
    bounds.AddPoint(point.x, point.y, point.z);
  }
  return bounds;
}

Surfaces GatherSurfaces(vtkRenderer* renderer, tool::Reporter& reporter)
{
  Surfaces surfaces;
  int instances = 0;
  const auto add = [&](const tool::MeshInstance& mesh) {
    ++instances;
    const glm::dmat3 normals =
      glm::transpose(glm::inverse(glm::dmat3(mesh.ToWorld))) * (mesh.Mirrored ? -1.0 : 1.0);
    const int flags = mesh.Part.Surface.Where.z;
    const bool smooth = (flags & GI_SURFACE_SMOOTH) != 0;
    std::size_t degenerate = 0;
    for (const glm::uvec3& triangle : mesh.Geometry.Triangles)
    {
      std::array<Vec3, 3> at;
      std::array<Vec3, 3> normal{};
      for (int k = 0; k < 3; ++k)
      {
        const int corner = mesh.CornerAt(k);
        at[corner] = mesh.PointAt(triangle[k]);
        normal[corner] =
          smooth ? normals * UnpackNormal(mesh.Attributes.Points[triangle[k]].Normal) : Vec3(0.0);
      }
      if (!surfaces.Add(at, normal, instances))
      {
        ++degenerate;
        continue;
      }
      surfaces.Triangles.back().Visible = { (flags & GI_SURFACE_CULL_FRONT) == 0,
        (flags & GI_SURFACE_CULL_BACK) == 0 };
    }
    return degenerate;
  };
  tool::ForEachOpaqueMesh(renderer, false, reporter, add);
  return surfaces;
}
}
