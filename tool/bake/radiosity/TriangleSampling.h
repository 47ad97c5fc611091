// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Directions to a triangle, as the light that it sends arrives.
#pragma once

#include "bake/radiosity/Sampling.h"

namespace penumbra::radiosity
{
/// Directions from a point to a triangle.
class SeenTriangle
{
public:
  SeenTriangle(const Point& at, const std::array<Point, 3>& triangle);
  /// Evenly over the solid angle for u in the unit square: Arvo 1995, Stratified Sampling of Spherical
  /// Triangles. Evenly over the area where the triangle looks so small that both are the same.
  Point Direction(const glm::dvec2& u) const;

private:
  std::array<Point, 3> Corners; ///< relative to the point
  std::array<Point, 3> Towards; ///< unit
  double Excess = 0.0;          ///< the solid angle
  double Angle = 0.0;           ///< at the first corner
  double CosineOpposite = 0.0;  ///< of the side between the first corner and the second
  bool Small = false;
};

/// A direction to the triangle with a density in proportion to its cosine with the normal, so that the
/// share of them that is not blocked is the share of the light that arrives. Of candidates by solid
/// angle, the first from u, as many as their cosine is of 1 are taken. False where all lie below the
/// horizon.
bool LightDirection(
  const SeenTriangle& seen, const Point& normal, glm::dvec2 u, Random& random, Point& direction);
}
