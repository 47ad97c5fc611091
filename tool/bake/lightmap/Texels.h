// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Positions of texels on the surfaces.
#pragma once

#include "bake/lightmap/Atlas.h"

#include <cstdint>

namespace penumbra::lightmap
{
struct Texel
{
  std::uint32_t Index = 0; ///< row * width + column in the atlas
  std::uint32_t Tile = 0;
  Vec3 At{ 0.0 };     ///< world, slightly inside its triangle
  Vec3 Normal{ 0.0 }; ///< unit shading normal, towards the side of the tile
};

/// All texels that interpolation on the surfaces uses, in the order of tiles. A texel with its centre outside the surface
/// gets the nearest point on it. shift: offset of the points from the centres, in texels, which does not change the set
/// of texels or their order.
std::vector<Texel> PlaceTexels(const Surfaces& surfaces, const std::vector<Chart>& charts,
  const Atlas& atlas, const Vec2& shift = Vec2(0.0));

/// Adds points on one side of a chart, distributed uniformly by area, and their normals.
void ScatterPoints(const Surfaces& surfaces, const Chart& chart, bool back, int count,
  std::vector<Vec3>& points, std::vector<Vec3>& normals);

/// A seam in the atlas: two lines with the same points on the surface.
struct SeamLine
{
  std::array<std::uint32_t, 2> Tiles{};
  std::array<std::array<Vec2, 2>, 2> Ends{}; ///< of the line in each tile, in texels of the atlas
};
std::vector<SeamLine> PlaceSeams(const Surfaces& surfaces, const std::vector<Chart>& charts,
  const Atlas& atlas, const std::vector<Seam>& seams);
}
