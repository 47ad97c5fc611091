// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Where the charts lie in one picture.
#pragma once

#include "bake/lightmap/Charts.h"

#include <cstdint>

namespace penumbra::lightmap
{
/// One side of a chart. Texels' middles lie on the box around the chart, so that edges along it are met exactly;
/// of the back the first axis runs the other way, so that it too winds counter-clockwise where it is seen.
struct Tile
{
  std::uint32_t Chart = 0;
  bool Back = false;
  glm::ivec2 Texels{ 2 }; ///< along the axes, without the gutter
  glm::ivec2 At{ 0 };     ///< of its lowest texel in the atlas

  /// From the chart's plane to texels of the tile, where whole numbers are texels' middles.
  Vec2 ToTexels(const lightmap::Chart& chart, const Vec2& inChart) const;
};

struct Atlas
{
  static constexpr int Gutter = 2; ///< texels around each tile that nothing else has
  int Width = 0;
  int Height = 0;
  double TexelSize = 0.0; ///< world units, at most
  std::vector<Tile> Tiles;
};

/// Tiles for the sides of charts that are wanted, of texels as wide as asked for or, where they do not fit into
/// the largest side, wider. Throws std::runtime_error with a sentence where that is of no help.
Atlas PackAtlas(const std::vector<Chart>& charts, const std::vector<std::array<bool, 2>>& wanted,
  double texelSize, int largestSide);
}
