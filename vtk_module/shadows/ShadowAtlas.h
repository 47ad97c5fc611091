// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Packs square maps of different sizes into one texture. The texture consists of equal squares of the largest
 * size. Smaller maps, whose widths are a half, a quarter, ... of it, share a square.
 */
#pragma once

#include <vector>

namespace penumbra
{
struct AtlasTile
{
  int X = 0;
  int Y = 0;
  int Size = 0;
};

struct ShadowAtlas
{
  int Width = 0;
  int Height = 0;
  std::vector<AtlasTile> Tiles; ///< tiles in the order of the maps
};

/// Place maps. largest: width of the largest map. halvings: number of times each map's width is halved. The result
/// depends on nothing else, so maps keep their tiles while sizes stay the same.
ShadowAtlas PackShadowAtlas(int largest, const std::vector<int>& halvings);

struct AtlasRequest
{
  int Maps = 1;
  int Halvings = 0; ///< minimum: a larger width is not useful
  double Importance = 1.0;
};

/// Number of times to halve each light's maps so that all fit into a number of squares of the largest size. Maps
/// that are least important for the space they take are halved first, up to maximumHalvings. Requests are ordered by
/// importance. Those at the end that do not fit even then are left out of the result.
std::vector<int> DistributeShadowAtlas(
  const std::vector<AtlasRequest>& requests, double squares, int maximumHalvings);
}
