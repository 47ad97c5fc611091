// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Importance sampling of the light from a triangle.
#pragma once

#include "bake/radiosity/Sampling.h"

namespace penumbra::radiosity
{
/// A triangle as seen from a point.
class SphericalTriangle
{
public:
  SphericalTriangle(const Point& at, const std::array<Point, 3>& triangle);
  /// A direction, uniformly distributed over the solid angle for u in the unit square (Arvo 1995, Stratified Sampling of
  /// Spherical Triangles). For tiny triangles it is uniform over the area, which is equivalent.
  Point Direction(const glm::dvec2& u) const;

private:
  std::array<Point, 3> Corners; ///< relative to the point
  std::array<Point, 3> Towards; ///< unit
  double Excess = 0.0;          ///< the solid angle
  double Angle = 0.0;           ///< angle at the first corner
  double CosineOpposite = 0.0;  ///< cosine of the side between the first two corners
  bool Small = false;
};

/// A direction to a triangle, with a density proportional to the cosine with the normal, so that the share of directions that
/// are not occluded is the share of the light that arrives. Candidates, of which u gives the first, are accepted with a
/// probability equal to their cosine. Returns false if none lies above the horizon.
bool LightDirection(const SphericalTriangle& triangle, const Point& normal, glm::dvec2 u,
  Random& random, Point& direction);
}
