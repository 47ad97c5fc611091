// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "shadows/ShadowAtlas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace penumbra
{
namespace
{
double SquaresOf(const AtlasRequest& request, int halvings)
{
  return request.Maps * std::pow(0.25, halvings);
}

// The bits of n at even positions: one coordinate of the n-th square of a Z-order curve.
int EvenBits(int n)
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
  // Placing tiles along a Z-order curve of the smallest size, largest tiles first, leaves no gap.
  std::vector<std::size_t> order(halvings.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&halvings](std::size_t a, std::size_t b) { return halvings[a] < halvings[b]; });
  const int finest = halvings.empty() ? 0 : halvings[order.back()];
  const int perSquare = 1 << (2 * finest);
  int units = 0;
  for (int halving : halvings)
  {
    units += 1 << (2 * (finest - halving));
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
    const int offset = next % perSquare;
    atlas.Tiles[i] = { square % columns * largest + EvenBits(offset) * unit,
      square / columns * largest + EvenBits(offset >> 1) * unit, size };
    next += 1 << (2 * (finest - halvings[i]));
  }
  return atlas;
}

std::vector<int> DistributeShadowAtlas(
  const std::vector<AtlasRequest>& requests, double squares, int maximumHalvings)
{
  std::vector<int> halvings;
  double minimum = 0.0;
  double used = 0.0;
  for (const auto& request : requests)
  {
    minimum += SquaresOf(request, std::max(request.Halvings, maximumHalvings));
    if (minimum > squares)
    {
      break;
    }
    used += SquaresOf(request, request.Halvings);
    halvings.push_back(request.Halvings);
  }
  while (used > squares)
  {
    std::size_t worst = halvings.size();
    double worstShare = 0.0;
    for (std::size_t i = 0; i < halvings.size(); ++i)
    {
      const double share =
        SquaresOf(requests[i], halvings[i]) / std::max(requests[i].Importance, 1e-300);
      if (halvings[i] < maximumHalvings && share >= worstShare)
      {
        worst = i;
        worstShare = share;
      }
    }
    if (worst == halvings.size())
    {
      break;
    }
    used -= 0.75 * SquaresOf(requests[worst], halvings[worst]);
    ++halvings[worst];
  }
  return halvings;
}
}
