// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/ground/GroundPlane.h"

#include "graph/View.h"
#include "rays/parts/SurfaceMaterial.h"

#include "vtkProperty.h"

namespace penumbra
{
namespace
{
// Depth of the ground below the bounds, in half diagonals, so that a floor of the scene at its height hides it.
constexpr double Gap = 1e-4;

// Triangles of the disc for rays.
constexpr int Sectors = 64;

// The disc of radius 1 around the origin, facing up the z axis.
RayGeometry UnitDisc()
{
  RayGeometry disc;
  disc.Points.emplace_back(0.0f);
  for (unsigned int i = 0; i < Sectors; ++i)
  {
    const double angle = glm::radians(360.0 * i / Sectors);
    disc.Points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    disc.Triangles.emplace_back(0u, 1u + i, 1u + (i + 1u) % Sectors);
  }
  return disc;
}

RayAttributes DiscAttributes()
{
  RayAttributes attributes;
  for (const glm::uvec3& triangle : UnitDisc().Triangles)
  {
    attributes.Primitives.push_back({ { triangle.x, triangle.y, triangle.z }, 0xffffffffu });
  }
  attributes.Points.resize(Sectors + 1, { GI_RAY_NO_NORMAL, 0xffffffffu, 0.0f, 0.0f });
  return attributes;
}

// Two axes in the plane of an axis, which form a right-handed system with up.
glm::dmat3 Around(const glm::dvec3& up)
{
  const glm::dvec3 across(up.y, up.z, up.x);
  return { across, glm::cross(up, across), up };
}
}

glm::dvec3 NearestAxis(const glm::dvec3& direction)
{
  const glm::dvec3 size = glm::abs(direction);
  const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
  glm::dvec3 nearest(0.0);
  nearest[axis] = direction[axis] < 0.0 ? -1.0 : 1.0;
  return nearest;
}

GroundPlane GroundPlane::Below(
  const std::array<double, 6>& bounds, const glm::dvec3& up, double offset, double size)
{
  const glm::dvec3 low(bounds[0], bounds[2], bounds[4]);
  const glm::dvec3 half = 0.5 * (glm::dvec3(bounds[1], bounds[3], bounds[5]) - low);
  GroundPlane ground;
  ground.Up = up;
  ground.Middle =
    low + half + up * (offset - glm::dot(half, glm::abs(up)) - Gap * glm::length(half));
  ground.Radius = size * glm::length(half);
  return ground;
}

bool GroundPlane::IsSeen(const View& view) const
{
  const glm::dvec3 toEye = view.Parallel ? glm::dvec3(view.ViewToWorld[2])
                                         : glm::dvec3(view.ViewToWorld[3]) - this->Middle;
  return this->Radius > 0.0 && glm::dot(toEye, this->Up) > 0.0;
}

std::array<double, 6> GroundPlane::Bounds() const
{
  const glm::dvec3 half = this->Radius * (1.0 - glm::abs(this->Up));
  const glm::dvec3 low = this->Middle - half;
  const glm::dvec3 high = this->Middle + half;
  return { { low.x, high.x, low.y, high.y, low.z, high.z } };
}

glm::dvec2 GroundPlane::DepthRange(const View& view) const
{
  const glm::dmat3 turn(view.WorldToView);
  const glm::dvec3 up = turn * this->Up;
  const double distance = -(view.WorldToView * glm::dvec4(this->Middle, 1.0)).z;
  const double reach = this->Radius * std::sqrt(std::max(0.0, 1.0 - up.z * up.z));
  glm::dvec2 range(distance - reach, distance + reach);
  if (!view.Parallel)
  {
    // The nearest visible point lies on the ray of a corner of the picture.
    const double height = glm::dot(glm::dvec3(view.ViewToWorld[3]) - this->Middle, this->Up);
    const glm::dmat4 clipToView = glm::inverse(view.ViewToClip);
    double steepest = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const glm::dvec4 p =
        clipToView * glm::dvec4(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, -1.0, 1.0);
      steepest = std::max(steepest, glm::dot(up, glm::dvec3(p)) / p.z);
    }
    // Smaller ratios of the distances cost precision of the depth.
    constexpr double least = 1e-3;
    range.x =
      std::max({ range.x, steepest > 0.0 ? 0.99 * height / steepest : range.y, least * range.y });
  }
  return range;
}

Arguments GroundPlane::InView(const View& view) const
{
  const glm::dvec3 up = glm::dmat3(view.WorldToView) * this->Up;
  const glm::dvec3 fromEye = this->Middle - glm::dvec3(view.ViewToWorld[3]);
  const glm::dvec3 middle = glm::dmat3(view.WorldToView) * fromEye;
  return Arguments()
    .Set("plane", glm::vec4(up, glm::dot(this->Up, fromEye)))
    .Set("disc", glm::vec4(middle, this->Radius));
}

RayPart GroundPlane::MakeRayPart(const glm::dvec3& color) const
{
  vtkNew<vtkProperty> property;
  property->SetColor(color.r, color.g, color.b);
  property->SetAmbient(0.0);
  property->SetSpecular(0.0);
  RayPart part;
  part.MeshKey = part.AttributeKey = reinterpret_cast<std::uintptr_t>(&UnitDisc);
  part.CellTime = part.PointTime = part.AttributeTime = 1;
  part.MakeGeometry = UnitDisc;
  part.MakeAttributes = DiscAttributes;
  // Rays must not see it where the ground has faded out.
  part.ToWorld = glm::dmat4(0.98 * this->Radius * Around(this->Up));
  part.ToWorld[3] = glm::dvec4(this->Middle, 1.0);
  part.Surface = MakeRaySurface(property);
  return part;
}
}
