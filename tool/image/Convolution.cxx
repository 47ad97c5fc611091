// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image/Convolution.h"

#include "common/ForEach.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace penumbra::tool
{
namespace
{
struct Lines
{
  int Count;  ///< of lines
  int Length; ///< of a line
  int Apart;  ///< distance between lines in memory
  int Step;   ///< distance between a line's pixels
};

Plane ConvolvedAlong(const Plane& plane, const Lines& lines, const Weights& weights)
{
  Plane result(plane.size());
  const int reach = static_cast<int>(weights.size() / 2);
  ForEach(static_cast<std::size_t>(lines.Count), [&](std::size_t line) {
    const double* from = &plane[line * lines.Apart];
    double* to = &result[line * lines.Apart];
    for (int i = 0; i < lines.Length; ++i)
    {
      double sum = 0;
      for (int k = -reach; k <= reach; ++k)
      {
        const int at = std::clamp(i + k, 0, lines.Length - 1);
        sum += weights[k + reach] * from[static_cast<std::ptrdiff_t>(at) * lines.Step];
      }
      to[static_cast<std::ptrdiff_t>(i) * lines.Step] = sum;
    }
  });
  return result;
}
}

Weights GaussianWeights(double deviation, int reach)
{
  Weights weights;
  double sum = 0;
  for (int i = -reach; i <= reach; ++i)
  {
    weights.push_back(std::exp(-0.5 * i * i / (deviation * deviation)));
    sum += weights.back();
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

Plane Convolved(const Plane& plane, int width, const Weights& across, const Weights& down)
{
  const int height = static_cast<int>(plane.size()) / width;
  return ConvolvedAlong(
    ConvolvedAlong(plane, { height, width, width, 1 }, across), { width, height, 1, width }, down);
}
}
