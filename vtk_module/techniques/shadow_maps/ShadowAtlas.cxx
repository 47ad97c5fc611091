// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/shadow_maps/ShadowAtlas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace penumbra
{
namespace
{
double Squares(const AtlasWish& wish, int halvings)
{
  return wish.Maps * std::pow(0.25, halvings);
}

// The n-th square of a Z-order curve: every other bit.
int EveryOtherBit(int n)
{
  int result = 0;
  for (int bit = 0; n >> (2 * bit) != 0; ++bit)
  {
    result |= (n >> (2 * bit) & 1) << bit;
  }
  return result;
}
}

ShadowAtlas PackShadowAtlas(int largest, const std::vector<int>& halvings)
{
  // Largest first, along a Z-order curve of the smallest size: that leaves no gap.
  std::vector<std::size_t> order(halvings.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&halvings](std::size_t a, std::size_t b) { return halvings[a] < halvings[b]; });
  const int finest = halvings.empty() ? 0 : halvings[order.back()];
  const int perSquare = 1 << (2 * finest);
  int units = 0;
  for (int h : halvings)
  {
    units += 1 << (2 * (finest - h));
  }
  const int squares = (units + perSquare - 1) / perSquare;
  const int columns = std::max(1, static_cast<int>(std::ceil(std::sqrt(squares))));
  ShadowAtlas atlas;
  atlas.Width = columns * largest;
  atlas.Height = (squares + columns - 1) / columns * largest;
  atlas.Tiles.resize(halvings.size());
  int next = 0;
  for (const std::size_t i : order)
  {
    const int unit = largest >> finest;
    const int size = unit << (finest - halvings[i]);
    const int square = next / perSquare;
    const int within = next % perSquare;
    atlas.Tiles[i] = { square % columns * largest + EveryOtherBit(within) * unit,
      square / columns * largest + EveryOtherBit(within >> 1) * unit, size };
    next += 1 << (2 * (finest - halvings[i]));
  }
  return atlas;
}

std::vector<int> ShareShadowAtlas(
  const std::vector<AtlasWish>& wishes, double squares, int mostHalvings)
{
  std::vector<int> halvings;
  double least = 0.0;
  double taken = 0.0;
  for (const auto& wish : wishes)
  {
    least += Squares(wish, std::max(wish.Halvings, mostHalvings));
    if (least > squares)
    {
      break;
    }
    taken += Squares(wish, wish.Halvings);
    halvings.push_back(wish.Halvings);
  }
  while (taken > squares)
  {
    std::size_t worst = halvings.size();
    double worstShare = 0.0;
    for (std::size_t i = 0; i < halvings.size(); ++i)
    {
      const double share = Squares(wishes[i], halvings[i]) / std::max(wishes[i].Importance, 1e-300);
      if (halvings[i] < mostHalvings && share >= worstShare)
      {
        worst = i;
        worstShare = share;
      }
    }
    if (worst == halvings.size())
    {
      break;
    }
    taken -= 0.75 * Squares(wishes[worst], halvings[worst]);
    ++halvings[worst];
  }
  return halvings;
}
}
