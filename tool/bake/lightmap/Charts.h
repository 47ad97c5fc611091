// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Segmentation of surfaces into charts, which are flattened without overlap.
#pragma once

#include "bake/lightmap/Surfaces.h"

#include <cstdint>

namespace penumbra::lightmap
{
/// Triangles projected to a plane. Lengths are those in the world, shortened for triangles that are tilted, by at most
/// ChartSettings::Lean.
struct Chart
{
  std::vector<std::uint32_t> Triangles;
  Vec3 Normal{ 0.0 };
  std::array<Vec3, 2> Axes{}; ///< unit, perpendicular to one another and the normal, right-handed
  Vec2 Low{ 0.0 };            ///< minimum coordinates along the axes
  Vec2 Size{ 0.0 };

  /// Coordinates along the axes, relative to Low.
  Vec2 Project(const Vec3& point) const
  {
    return Vec2(glm::dot(point, this->Axes[0]), glm::dot(point, this->Axes[1])) - this->Low;
  }
};

struct ChartSettings
{
  double Lean =
    40.0; ///< maximum degrees between a new triangle and its chart's plane; finally 15 more
  double Crease = 20.0; ///< degrees between normals at an edge above which it separates charts
};

/// Assigns every triangle to a chart. Charts grow across edges, flattest first (after Sander, Wood, Gortler, Snyder and Hoppe
/// 2003, Multi-Chart Geometry Images). Triangles that would overlap in the plane start another chart.
std::vector<Chart> MakeCharts(const Surfaces& surfaces, const ChartSettings& settings = {});

/// An edge shared by two charts, or by two parts of a chart that are separate in the plane.
struct Seam
{
  std::array<std::uint32_t, 2> Triangles{}; ///< on both sides
  std::array<std::uint32_t, 2> Charts{};    ///< of the triangles
  std::array<int, 2> Edges{};               ///< the corner at which the edge begins in each
  bool Turned = false; ///< opposite winding: the front of one continues as the back of the other
};

/// Edges between charts across which shading is smooth. crease: maximum angle between normals there, in degrees.
std::vector<Seam> FindSeams(const Surfaces& surfaces, const std::vector<Chart>& charts,
  double crease = ChartSettings().Crease);
}
