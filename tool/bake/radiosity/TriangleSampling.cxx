// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/TriangleSampling.h"

#include <algorithm>

namespace penumbra::radiosity
{
namespace
{
/// The unit vector from b towards a, perpendicular to b.
Point Perpendicular(const Point& a, const Point& b)
{
  const Point across = a - glm::dot(a, b) * b;
  const double length = glm::length(across);
  return length > 0.0 ? across / length : Point(0.0);
}

/// The angle between the sides of a spherical triangle at a.
double AngleAt(const Point& a, const Point& b, const Point& c)
{
  return std::acos(std::clamp(glm::dot(Perpendicular(b, a), Perpendicular(c, a)), -1.0, 1.0));
}
}

SphericalTriangle::SphericalTriangle(const Point& at, const std::array<Point, 3>& triangle)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Corners[i] = triangle[i] - at;
    this->Towards[i] = glm::normalize(this->Corners[i]);
  }
  const auto& t = this->Towards;
  // Van Oosterom and Strackee 1983, The Solid Angle of a Plane Triangle.
  const double volume = std::abs(glm::dot(t[0], glm::cross(t[1], t[2])));
  this->Excess = 2.0 *
    std::atan2(volume, 1.0 + glm::dot(t[0], t[1]) + glm::dot(t[1], t[2]) + glm::dot(t[2], t[0]));
  // For smaller solid angles, differences of angles lose too many digits.
  constexpr double least = 1e-6;
  this->Small = !(this->Excess > least);
  this->Angle = AngleAt(t[0], t[1], t[2]);
  this->CosineOpposite = glm::dot(t[0], t[1]);
}

Point SphericalTriangle::Direction(const glm::dvec2& u) const
{
  if (this->Small)
  {
    const double r = std::sqrt(u.x);
    return glm::normalize((1.0 - r) * this->Corners[0] + r * (1.0 - u.y) * this->Corners[1] +
      r * u.y * this->Corners[2]);
  }
  // Move the third corner along its side until the triangle has a share u.x of the solid angle.
  const auto& t = this->Towards;
  const double beta = AngleAt(t[1], t[2], t[0]);
  const double gamma = AngleAt(t[2], t[0], t[1]);
  const double wanted = u.x * (this->Angle + beta + gamma - glm::pi<double>());
  const double s = std::sin(wanted - this->Angle);
  const double c = std::cos(wanted - this->Angle);
  const double cosine = std::cos(this->Angle);
  const double sine = std::sin(this->Angle);
  const double p = c - cosine;
  const double q = s + sine * this->CosineOpposite;
  const double below = (q * s + p * c) * sine;
  const double along =
    below != 0.0 ? std::clamp(((q * c - p * s) * cosine - q) / below, -1.0, 1.0) : 1.0;
  const Point third = along * t[0] + std::sqrt(1.0 - along * along) * Perpendicular(t[2], t[0]);
  // Choose a point between it and the second corner, uniformly by area of the sphere.
  const double height = 1.0 - u.y * (1.0 - glm::dot(third, t[1]));
  return glm::normalize(
    height * t[1] + std::sqrt(std::max(0.0, 1.0 - height * height)) * Perpendicular(third, t[1]));
}

bool LightDirection(const SphericalTriangle& triangle, const Point& normal, glm::dvec2 u,
  Random& random, Point& direction)
{
  // If none of so many is accepted, the triangle is so low that its light is negligible.
  constexpr int most = 256;
  for (int i = 0; i < most; ++i)
  {
    direction = triangle.Direction(u);
    if (random.Next() < glm::dot(direction, normal))
    {
      return true;
    }
    u = { random.Next(), random.Next() };
  }
  return false;
}
}
