// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Surfaces cut into charts: pieces that lie flat without overlap.
#pragma once

#include "bake/lightmap/Surfaces.h"

#include <cstdint>

namespace penumbra::lightmap
{
/// Triangles projected to a plane, so that lengths in it are lengths in the world, shortened where a triangle
/// leans by at most Settings::Lean.
struct Chart
{
  std::vector<std::uint32_t> Triangles;
  Vec3 Normal{ 0.0 };
  std::array<Vec3, 2> Axes{}; ///< unit, across one another and the normal, right-handed
  Vec2 Low{ 0.0 };            ///< least coordinates along the axes
  Vec2 Size{ 0.0 };

  /// Coordinates along the axes, from Low on.
  Vec2 Project(const Vec3& point) const
  {
    return Vec2(glm::dot(point, this->Axes[0]), glm::dot(point, this->Axes[1])) - this->Low;
  }
};

struct ChartSettings
{
  double Lean =
    40.0; ///< degrees between a triangle and its chart's plane as it joins; 15 more in the end
  double Crease = 20.0; ///< degrees between normals at an edge, above which it parts charts
};

/// Every triangle is in one chart. Charts grow over edges, flattest first (after Sander, Wood, Gortler, Snyder and
/// Hoppe 2003, Multi-Chart Geometry Images), and what would overlap in the plane starts another.
std::vector<Chart> MakeCharts(const Surfaces& surfaces, const ChartSettings& settings = {});

/// An edge that two charts have in common, or one of one chart where its sides lie apart in the plane.
struct Seam
{
  std::array<std::uint32_t, 2> Triangles{}; ///< on either side
  std::array<int, 2> Edges{};               ///< from this corner of it to the next
  bool Turned =
    false; ///< the triangles wind differently: the front of one goes on as the other's back
};

/// Edges between two triangles of different charts where shading runs on smoothly: normals there differ by less
/// than so many degrees.
std::vector<Seam> FindSeams(const Surfaces& surfaces, const std::vector<Chart>& charts,
  double crease = ChartSettings().Crease);

}
