// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Packing of charts into an atlas.
#pragma once

#include "bake/lightmap/Charts.h"

#include <cstdint>

namespace penumbra::lightmap
{
/// One side of a chart. Centres of texels lie on the bounding box of the chart, so that edges along it are exact. On the back
/// the first axis is reversed, so that triangles are counter-clockwise as seen from there.
struct Tile
{
  std::uint32_t Chart = 0;
  bool Back = false;
  glm::ivec2 Texels{ 2 }; ///< along the axes, without the gutter
  glm::ivec2 At{ 0 };     ///< its lowest texel in the atlas

  /// From the chart's plane to texels of the tile. Integers are centres of texels.
  Vec2 ToTexels(const lightmap::Chart& chart, const Vec2& inChart) const;
};

struct Atlas
{
  static constexpr int Gutter = 2; ///< texels around each tile that belong to it
  int Width = 0;
  int Height = 0;
  double TexelSize = 0.0; ///< maximum, in world units
  std::vector<Tile> Tiles;
};

/// Makes tiles for the requested sides of charts, with texels of the given width, or wider ones if they do not fit into the
/// largest side. Throws a Failure if that does not help.
Atlas PackAtlas(const std::vector<Chart>& charts, const std::vector<std::array<bool, 2>>& wanted,
  double texelSize, int largestSide);
}
