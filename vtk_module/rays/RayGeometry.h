// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Geometry of a dataset for ray tracing: triangles, spheres and cylinders. Primitives are numbered in
 * this order: all triangles, all spheres, all cylinders.
 */
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace penumbra
{
struct RaySphere
{
  glm::vec3 Center{ 0.0f };
  float Radius = 0.0f;
};

struct RayCylinder
{
  glm::vec3 End0{ 0.0f };
  glm::vec3 End1{ 0.0f };
  float Radius = 0.0f;
  bool Capped = false;
};

/// Transformation of one of many instances of a mesh: a point p lies at Turn * p + At.
struct RayPlace
{
  glm::mat3 Turn{ 1.0f };
  std::uint32_t Color = 0xffffffffu; ///< RGBA8, for surfaces with GI_SURFACE_PLACE_COLORS
  glm::dvec3 At{ 0.0 };
};

struct RayGeometry
{
  /// Origin of all coordinates below. It is near the data, so that floats keep their precision.
  glm::dvec3 Origin{ 0.0 };
  std::vector<glm::vec3> Points;
  std::vector<glm::uvec3> Triangles; ///< indices into Points
  std::vector<RaySphere> Spheres;
  std::vector<RayCylinder> Cylinders;

  std::size_t Size() const
  {
    return this->Triangles.size() + this->Spheres.size() + this->Cylinders.size();
  }

  /// Set points in double precision. Puts the origin in the middle of the finite ones.
  void SetPoints(const std::vector<glm::dvec3>& points);
};
}
