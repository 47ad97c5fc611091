// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image/Convolution.h"
#include "image/Metrics.h"

#include <cmath>
#include <functional>

namespace penumbra::tool
{
namespace
{
// The paper's window: 11 by 11 Gaussian weights with a standard deviation of 1.5.
Plane Blurred(const Picture& size, const std::function<double(std::size_t)>& value)
{
  Plane plane(size.PixelCount());
  for (std::size_t i = 0; i < plane.size(); ++i)
  {
    const double v = value(i);
    plane[i] = std::isfinite(v) ? v : 0;
  }
  const Weights weights = GaussianWeights(1.5, 5);
  return Convolved(plane, size.Width, weights, weights);
}
}

double StructuralSimilarity(const Picture& a, const Picture& b)
{
  const auto x = [&](std::size_t i) { return double(a.Luminance(i)); };
  const auto y = [&](std::size_t i) { return double(b.Luminance(i)); };
  const Plane meanX = Blurred(a, x), meanY = Blurred(a, y);
  const Plane meanXX = Blurred(a, [&](std::size_t i) { return x(i) * x(i); });
  const Plane meanYY = Blurred(a, [&](std::size_t i) { return y(i) * y(i); });
  const Plane meanXY = Blurred(a, [&](std::size_t i) { return x(i) * y(i); });
  constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03; // the paper's K1 and K2, squared
  double sum = 0;
  for (std::size_t i = 0; i < meanX.size(); ++i)
  {
    const double mx = meanX[i], my = meanY[i];
    const double vx = meanXX[i] - mx * mx, vy = meanYY[i] - my * my, cov = meanXY[i] - mx * my;
    sum += (2 * mx * my + c1) * (2 * cov + c2) / ((mx * mx + my * my + c1) * (vx + vy + c2));
  }
  return sum / static_cast<double>(meanX.size());
}
}
