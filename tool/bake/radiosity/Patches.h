// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Sides of patches, which exchange light, and rays between them.
#pragma once

#include "bake/radiosity/PatchMesh.h"

#include <cmath>
#include <cstdint>
#include <memory>

namespace penumbra::radiosity
{
/// A side of a patch. Side s of patch p has the index 2 p + s.
struct Element
{
  std::array<Point, 3> Corners; ///< counter-clockwise as seen from this side
  Point Normal;                 ///< unit
  double Area = 0.0;
  Color Reflectance{ 0.0 };
  Color Emission{ 0.0 }; ///< radiant exitance: pi times the radiance
  bool Present = true;   ///< false if light passes through it

  Point At(double u, double v) const ///< uniform over the triangle for u, v in [0, 1)
  {
    // Osada et al. 2002, Shape Distributions, section 4.2.
    const double r = std::sqrt(u);
    return (1.0 - r) * this->Corners[0] + r * (1.0 - v) * this->Corners[1] +
      r * v * this->Corners[2];
  }
};

std::vector<Element> MakeElements(const PatchMesh& mesh);

/// Emitters for direct light: input faces if their emission is uniform, or else patches.
std::vector<Element> MakeEmitters(const PatchMesh& mesh);

class PatchRays
{
public:
  static constexpr std::uint32_t Nothing = 0xffffffffu;
  struct Hit
  {
    std::uint32_t Element = Nothing; ///< the side that was hit
    double Distance = 0.0;
    double U = 0.0, V = 0.0; ///< weights of the second and third corner of the patch's front side
  };

  explicit PatchRays(const std::vector<Element>& elements);
  ~PatchRays();
  PatchRays(const PatchRays&) = delete;
  PatchRays& operator=(const PatchRays&) = delete;

  /// The nearest hit of a ray from a point on a surface. normal: of the side that it leaves.
  Hit Nearest(const Point& from, const Point& normal, const Point& direction) const;
  /// Whether anything lies between two points on surfaces. The normal is 0 for a point in free space.
  bool Occluded(
    const Point& from, const Point& normal, const Point& to, const Point& toNormal) const;
  /// Whether anything lies in a direction.
  bool OccludedTowards(const Point& from, const Point& normal, const Point& direction) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};
}
