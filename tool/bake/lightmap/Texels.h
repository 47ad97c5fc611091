// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Where on the surfaces each texel of an atlas lies.
#pragma once

#include "bake/lightmap/Atlas.h"

#include <cstdint>

namespace penumbra::lightmap
{
struct Texel
{
  std::uint32_t Index = 0; ///< row * width + column in the atlas
  std::uint32_t Tile = 0;
  Vec3 At{ 0.0 };     ///< world, a hair within its triangle
  Vec3 Normal{ 0.0 }; ///< unit, for shading, to the tile's side
};

/// All texels that interpolation at any point of the surfaces takes part of, tile by tile. Those whose middle is
/// beside the surface have the nearest point of it. shift: of the points off the texels' middles, in texels; which
/// texels there are, and their order, does not depend on it.
std::vector<Texel> PlaceTexels(const Surfaces& surfaces, const std::vector<Chart>& charts,
  const Atlas& atlas, const Vec2& shift = Vec2(0.0));

/// Points of one side of a chart with normals to that side, evenly spread over its triangles by area.
void ScatterPoints(const Surfaces& surfaces, const Chart& chart, bool back, int count,
  std::vector<Vec3>& points, std::vector<Vec3>& normals);

/// A seam in the atlas: two lines whose points, in order, are the same of the surface.
struct SeamLine
{
  std::array<std::uint32_t, 2> Tiles{};
  std::array<std::array<Vec2, 2>, 2> Ends{}; ///< in texels of the atlas, of each tile's line
};
std::vector<SeamLine> PlaceSeams(const Surfaces& surfaces, const std::vector<Chart>& charts,
  const Atlas& atlas, const std::vector<Seam>& seams);
}
