// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The triangles that a lightmap covers.
#pragma once

#include "common/NumbersHash.h"
#include "common/Reporter.h"

#include <glm/glm.hpp>
#include <vtkBoundingBox.h>

#include <array>
#include <cstdint>
#include <vector>

class vtkRenderer;

namespace penumbra::lightmap
{
using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;

struct Triangle
{
  std::array<std::uint32_t, 3> Points{}; ///< shared by triangles of the same instance
  std::array<Vec3, 3> Normals{};         ///< shading normals, unit, towards the front
  Vec3 Normal{ 0.0 }; ///< unit, towards the side where the corners are counter-clockwise
  double Area = 0.0;
  std::array<bool, 2> Visible{ { true, true } }; ///< front, back
};

struct Surfaces
{
  std::vector<Vec3> Points; ///< world
  std::vector<Triangle> Triangles;

  vtkBoundingBox Bounds() const;
  /// Adds a triangle with corners and normals in world coordinates. Returns false and adds nothing if it is not finite or
  /// has no area. group: only triangles of the same group share points.
  bool Add(const std::array<Vec3, 3>& corners, const std::array<Vec3, 3>& normals, int group);

private:
  std::uint32_t FindOrAdd(const Vec3& point, int group);
  tool::NumbersMap<4, std::uint32_t> PointIndex; ///< by coordinates and group
};

/// All visible opaque surfaces that light shades. Prints notes on what is left out.
Surfaces GatherSurfaces(vtkRenderer* renderer, tool::Reporter& reporter = tool::Reporter::None());
}
