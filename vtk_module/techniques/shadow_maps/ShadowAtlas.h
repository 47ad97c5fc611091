// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Squares of different sizes in one texture. It is made of equal squares of the largest size; smaller
 * maps share one, each half, a quarter, ... as wide.
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
  std::vector<AtlasTile> Tiles; ///< in the order of the wishes
};

/// halvings: how often each map's width is the half of the largest's. Maps of one kind keep their
/// places while the kinds do.
ShadowAtlas PackShadowAtlas(int largest, const std::vector<int>& halvings);

struct AtlasWish
{
  int Maps = 1;
  int Halvings = 0; ///< as wide as is useful
  double Importance = 1.0;
};

/// How often to halve each light's maps, so that all together take at most so many squares of the
/// largest size: the least important for its share first, down to so many halvings. Wishes stand in
/// the order of importance; those at the end that do not fit even so are left out.
std::vector<int> ShareShadowAtlas(
  const std::vector<AtlasWish>& wishes, double squares, int mostHalvings);
}
