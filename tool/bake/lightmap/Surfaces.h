// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The triangles that a lightmap is made for.
#pragma once

#include "common/NumbersHash.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkRenderer;

namespace penumbra::lightmap
{
using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;

struct Triangle
{
  std::array<std::uint32_t, 3> Points{}; ///< those of one place and one part of the scene are one
  std::array<Vec3, 3> Normals{};         ///< for shading, unit, to the front
  Vec3 Normal{ 0.0 }; ///< unit, to the side where the corners run counter-clockwise
  double Area = 0.0;
  std::array<bool, 2> Drawn{ { true, true } }; ///< front, back
};

struct Surfaces
{
  std::vector<Vec3> Points; ///< world
  std::vector<Triangle> Triangles;
  std::vector<std::string> Notes; ///< what is left out, a sentence each

  std::array<Vec3, 2> Box() const; ///< least and greatest coordinates
  double Diagonal() const { return glm::distance(this->Box()[0], this->Box()[1]); }
  Vec3 Center() const
  {
    const auto [low, high] = this->Box();
    return 0.5 * (low + high);
  }
  /// A triangle with corners in the world and their normals; false, and nothing done, where it is not finite or
  /// has no area. weld: triangles of one number share points.
  bool Add(const std::array<Vec3, 3>& corners, const std::array<Vec3, 3>& normals, int weld);

private:
  std::uint32_t FindOrAdd(const Vec3& point, int weld);
  tool::NumbersMap<4, std::uint32_t> Known; ///< the points by place and weld
};

/// All visible opaque surfaces that light shades, as rays see them.
Surfaces GatherSurfaces(vtkRenderer* renderer);
}
