// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "light/LightShape.h"

#include "base/Matrices.h"
#include "light/LightTable.h"

#include "vtkGILightShape.h"
#include "vtkLight.h"

#include <glm/gtc/constants.hpp>

namespace penumbra
{
static_assert(GI_SHAPE_NONE == vtkGILightShape::NONE && GI_SHAPE_POINT == vtkGILightShape::POINT &&
    GI_SHAPE_ANGLE == vtkGILightShape::ANGLE && GI_SHAPE_SPHERE == vtkGILightShape::SPHERE &&
    GI_SHAPE_DISC == vtkGILightShape::DISC && GI_SHAPE_RECTANGLE == vtkGILightShape::RECTANGLE,
  "the shapes of light.h");

namespace
{
// Sizes in single precision, whose squares and inverse squares must be finite.
double Usable(double size)
{
  return size > 1e-15 ? std::min(size, 1e15) : 0.0; // 0 if not a number
}

/// The part of a vector that is perpendicular to a direction, with unit length.
glm::dvec3 Across(const glm::dvec3& vector, const glm::dvec3& direction)
{
  const glm::dvec3 part = vector - glm::dot(vector, direction) * direction;
  const double length = glm::length(part);
  return length > 1e-9 ? part / length : glm::dvec3(0.0);
}

/// Two unit vectors across a light in world coordinates: its width and, to the right of its path, its height.
std::array<glm::dvec3, 2> Axes(vtkLight* light, const glm::dvec3& direction)
{
  std::array<glm::dvec3, 2> vertical = { { { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } };
  if (vtkMatrix4x4* matrix = light->GetTransformMatrix())
  {
    for (glm::dvec3& axis : vertical)
    {
      axis = glm::dvec3(ToMatrix(matrix) * glm::dvec4(axis, 0.0));
    }
  }
  glm::dvec3 up = Across(vertical[0], direction);
  up = up == glm::dvec3(0.0) ? Across(vertical[1], direction) : up;
  const glm::dvec3 side = glm::cross(direction, up);
  const double turn = glm::radians(vtkGILightShape::GetTurn(light));
  const double cosine = std::isfinite(turn) ? std::cos(turn) : 1.0;
  const double sine = std::isfinite(turn) ? std::sin(turn) : 0.0;
  return { { cosine * side - sine * up, sine * side + cosine * up } };
}

}

void ReadShape(vtkLight* light, Light& entry)
{
  entry.Shape = vtkGILightShape::GetShape(light);
  const double radius = Usable(vtkGILightShape::GetRadius(light));
  glm::dvec2 extent(radius);
  switch (entry.Shape)
  {
    case GI_SHAPE_ANGLE:
      entry.Size = glm::radians(std::min(Usable(vtkGILightShape::GetAngle(light)), 90.0)) / 2.0;
      break;
    case GI_SHAPE_SPHERE:
      entry.Size = radius;
      break;
    case GI_SHAPE_RECTANGLE:
      extent = { Usable(vtkGILightShape::GetWidth(light)) / 2.0,
        Usable(vtkGILightShape::GetHeight(light)) / 2.0 };
      [[fallthrough]];
    case GI_SHAPE_DISC:
    {
      entry.Size = std::min(extent.x, extent.y);
      const auto axes = Axes(light, entry.WorldDirection);
      entry.WorldSide = extent.x * axes[0];
      entry.WorldUp = extent.y * axes[1];
      break;
    }
    case GI_SHAPE_NONE:
      return;
    default:
      break;
  }
  entry.Shape = entry.Size > 0.0 ? entry.Shape : GI_SHAPE_POINT;
}

double Light::Area() const
{
  const double across = glm::length(this->Side) * glm::length(this->Up);
  return !this->IsFlat()           ? 0.0
    : this->Shape == GI_SHAPE_DISC ? glm::pi<double>() * across
                                   : 4.0 * across;
}
}
