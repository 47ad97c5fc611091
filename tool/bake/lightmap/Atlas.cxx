// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/Atlas.h"

#include "common/Failure.h"

#include <algorithm>
#include <cmath>
#include <limits>

// Sean Barrett's skyline packing, with functions local to this file.
#define STB_RECT_PACK_IMPLEMENTATION
#define STBRP_STATIC
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb/stb_rect_pack.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace penumbra::lightmap
{
namespace
{
Vec2 Scale(const Tile& tile, const Chart& chart)
{
  return Vec2(tile.Texels - 1) / chart.Size;
}

/// Number of texels of a chart, at least two for interpolation.
glm::ivec2 CountTexels(const Chart& chart, double texelSize)
{
  constexpr double rounding = 1e-6;
  constexpr double most = 1e6;
  const Vec2 count = glm::min(glm::ceil(chart.Size / texelSize - rounding), Vec2(most));
  return glm::max(glm::ivec2(count), glm::ivec2(1)) + 1;
}

/// Packs the tiles into an atlas of this width. Returns its height, or 0 if it exceeds the maximum.
int Pack(std::vector<Tile>& tiles, int width, int maximumHeight)
{
  std::vector<stbrp_rect> boxes;
  for (std::size_t i = 0; i < tiles.size(); ++i)
  {
    stbrp_rect box{};
    box.id = static_cast<int>(i);
    box.w = tiles[i].Texels.x + 2 * Atlas::Gutter;
    box.h = tiles[i].Texels.y + 2 * Atlas::Gutter;
    boxes.push_back(box);
  }
  std::vector<stbrp_node> nodes(static_cast<std::size_t>(width));
  stbrp_context context;
  stbrp_init_target(&context, width, maximumHeight, nodes.data(), width);
  if (!stbrp_pack_rects(&context, boxes.data(), static_cast<int>(boxes.size())))
  {
    return 0;
  }
  int height = 0;
  for (const stbrp_rect& box : boxes)
  {
    tiles[static_cast<std::size_t>(box.id)].At =
      glm::ivec2(box.x + Atlas::Gutter, box.y + Atlas::Gutter);
    height = std::max(height, box.y + box.h);
  }
  return height;
}

bool Fit(Atlas& atlas, int largestSide)
{
  double area = 0.0;
  int widest = 0;
  for (const Tile& tile : atlas.Tiles)
  {
    const glm::ivec2 box = tile.Texels + 2 * Atlas::Gutter;
    area += double(box.x) * box.y;
    widest = std::max({ widest, box.x, box.y });
  }
  if (widest > largestSide || area > double(largestSide) * largestSide)
  {
    return false;
  }
  // About square, because some software rejects tall pictures.
  for (int width = std::max(widest, static_cast<int>(std::ceil(std::sqrt(area))));
       width <= largestSide; width = width * 21 / 20 + 1)
  {
    const int height = Pack(atlas.Tiles, width, std::min(largestSide, width + widest));
    if (height > 0)
    {
      atlas.Width = width;
      atlas.Height = height;
      return true;
    }
  }
  atlas.Width = largestSide;
  atlas.Height = Pack(atlas.Tiles, largestSide, largestSide);
  return atlas.Height > 0;
}
}

Vec2 Tile::ToTexels(const lightmap::Chart& chart, const Vec2& inChart) const
{
  const Vec2 there = inChart * Scale(*this, chart);
  return { this->Back ? this->Texels.x - 1 - there.x : there.x, there.y };
}

Atlas PackAtlas(const std::vector<Chart>& charts, const std::vector<std::array<bool, 2>>& wanted,
  double texelSize, int largestSide)
{
  Atlas atlas;
  constexpr double wider = 1.1;
  constexpr int attempts = 120; // up to 100,000 times as wide
  for (int attempt = 0; attempt < attempts; ++attempt)
  {
    atlas.TexelSize = texelSize * std::pow(wider, attempt);
    atlas.Tiles.clear();
    for (std::size_t c = 0; c < charts.size(); ++c)
    {
      for (const bool back : { false, true })
      {
        if (wanted[c][back ? 1 : 0])
        {
          Tile tile;
          tile.Chart = static_cast<std::uint32_t>(c);
          tile.Back = back;
          tile.Texels = CountTexels(charts[c], atlas.TexelSize);
          atlas.Tiles.push_back(tile);
        }
      }
    }
    if (atlas.Tiles.empty())
    {
      tool::Fail("there is no surface for a lightmap");
    }
    if (Fit(atlas, largestSide))
    {
      return atlas;
    }
    const std::size_t least = std::size_t(2 + 2 * Atlas::Gutter) * (2 + 2 * Atlas::Gutter);
    if (atlas.Tiles.size() * least > std::size_t(largestSide) * largestSide)
    {
      break;
    }
  }
  tool::Fail("the surfaces consist of {} charts, which do not fit into {}x{} texels: raise "
             "--max-size, or light such rough surfaces with DDGI or probes",
    atlas.Tiles.size(), largestSide, largestSide);
}
}
