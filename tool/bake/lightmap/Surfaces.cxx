// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/Surfaces.h"

#include "rays/RayPart.h"
#include "rays/parts/GatherCache.h"

#include <fmt/format.h>
#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra::lightmap
{
namespace
{
struct LeftOut
{
  std::size_t Translucent = 0, Balls = 0, Broken = 0;
};

// As the ray core's giDecodeOctahedral.
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

struct Adder
{
  Surfaces& Into;
  LeftOut& Left;
  int Part = 0;

  void AddAt(const RayPart& part, const RayGeometry& geometry, const RayAttributes& attributes,
    const glm::dmat4& toWorld)
  {
    ++this->Part;
    const glm::dmat3 turn(toWorld);
    const bool mirrored = glm::determinant(turn) < 0.0;
    const glm::dmat3 normals = glm::transpose(glm::inverse(turn)) * (mirrored ? -1.0 : 1.0);
    const int flags = part.Surface.Where.z;
    const bool smooth = (flags & GI_SURFACE_SMOOTH) != 0;
    for (const glm::uvec3& triangle : geometry.Triangles)
    {
      std::array<Vec3, 3> at;
      std::array<Vec3, 3> normal{};
      for (int k = 0; k < 3; ++k)
      {
        const std::uint32_t index = triangle[k];
        const int to = mirrored ? (3 - k) % 3 : k; // the corners' order runs the other way round
        at[to] = Vec3(toWorld * glm::dvec4(geometry.Origin + Vec3(geometry.Points[index]), 1.0));
        normal[to] = smooth ? normals * UnpackNormal(attributes.Points[index].Normal) : Vec3(0.0);
      }
      if (!this->Into.Add(at, normal, this->Part))
      {
        ++this->Left.Broken;
        continue;
      }
      this->Into.Triangles.back().Drawn = { (flags & GI_SURFACE_CULL_FRONT) == 0,
        (flags & GI_SURFACE_CULL_BACK) == 0 };
    }
  }
};
}

std::uint32_t Surfaces::FindOrAdd(const Vec3& point, int weld)
{
  const auto next = static_cast<std::uint32_t>(this->Points.size());
  const auto found =
    this->Known.emplace(std::array{ point.x, point.y, point.z, double(weld) }, next);
  if (found.second)
  {
    this->Points.push_back(point);
  }
  return found.first->second;
}

bool Surfaces::Add(const std::array<Vec3, 3>& corners, const std::array<Vec3, 3>& normals, int weld)
{
  const Vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double longest = std::max({ glm::length(corners[1] - corners[0]),
    glm::length(corners[2] - corners[1]), glm::length(corners[0] - corners[2]) });
  constexpr double thinnest = 1e-10; // thinner than this its normal is rounding error
  const double twice = glm::length(across);
  if (!std::isfinite(twice) || !(twice > thinnest * longest * longest))
  {
    return false;
  }
  Triangle triangle;
  triangle.Normal = across / twice;
  triangle.Area = 0.5 * twice;
  for (int k = 0; k < 3; ++k)
  {
    triangle.Points[k] = this->FindOrAdd(corners[k], weld);
    const double length = glm::length(normals[k]);
    const Vec3 normal =
      length > 0.0 && std::isfinite(length) ? normals[k] / length : triangle.Normal;
    // Seen from the front it is turned to the front.
    triangle.Normals[k] = glm::dot(normal, triangle.Normal) < 0.0 ? -normal : normal;
  }
  this->Triangles.push_back(triangle);
  return true;
}

std::array<Vec3, 2> Surfaces::Box() const
{
  Vec3 low(std::numeric_limits<double>::max());
  Vec3 high(-std::numeric_limits<double>::max());
  for (const Vec3& point : this->Points)
  {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  return this->Points.empty() ? std::array<Vec3, 2>{ Vec3(0.0), Vec3(0.0) }
                              : std::array{ low, high };
}

Surfaces GatherSurfaces(vtkRenderer* renderer)
{
  Surfaces surfaces;
  LeftOut left;
  GatherCache cache;
  std::vector<vtkProp*> unseen;
  Adder adder{ surfaces, left };
  for (const RayPart& part : GatherRayParts(renderer, unseen, cache))
  {
    if ((part.Surface.Where.z & GI_SURFACE_MODEL) == GI_SURFACE_UNLIT)
    {
      continue;
    }
    if (part.Surface.Color.a < 1.0f)
    {
      ++left.Translucent;
      continue;
    }
    const RayGeometry geometry = part.MakeGeometry();
    const RayAttributes attributes = part.MakeAttributes();
    left.Balls += geometry.Spheres.size() + geometry.Cylinders.size();
    const std::vector<RayPlace> once(1);
    for (const RayPlace& place : part.Places ? *part.Places : once)
    {
      glm::dmat4 placed{ glm::dmat3(place.Turn) };
      placed[3] = glm::dvec4(place.At, 1.0);
      adder.AddAt(part, geometry, attributes, part.Places ? part.ToWorld * placed : part.ToWorld);
    }
  }
  const auto say = [&surfaces](std::size_t count, const char* what) {
    if (count > 0)
    {
      surfaces.Notes.push_back(fmt::format("{} {}", count, what));
    }
  };
  say(
    left.Translucent, "translucent surfaces get no lightmap: they take no indirect light from it");
  say(left.Balls, "balls and sticks get no lightmap: they have no triangles");
  say(unseen.size(), "objects are left out: rays do not see what draws them");
  say(left.Broken, "triangles without area or with points that are not finite are left out");
  return surfaces;
}
}
