// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image/Metrics.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace penumbra::tool
{
namespace
{
using Plane = std::vector<double>;

/// The paper's window: 11 by 11 Gaussian weights with a standard deviation of 1.5. Edge pixels are repeated.
constexpr int Reach = 5;
constexpr double Deviation = 1.5;

void BlurAlong(Plane& plane, int count, int lines, int step, int lineStep)
{
  double weights[2 * Reach + 1], sum = 0;
  for (int i = -Reach; i <= Reach; ++i)
  {
    sum += weights[i + Reach] = std::exp(-0.5 * i * i / (Deviation * Deviation));
  }
  Plane line(count);
  for (int l = 0; l < lines; ++l)
  {
    double* start = &plane[std::size_t(l) * lineStep];
    for (int i = 0; i < count; ++i)
    {
      double value = 0;
      for (int k = -Reach; k <= Reach; ++k)
      {
        value += weights[k + Reach] * start[std::size_t(std::clamp(i + k, 0, count - 1)) * step];
      }
      line[i] = value / sum;
    }
    for (int i = 0; i < count; ++i)
    {
      start[std::size_t(i) * step] = line[i];
    }
  }
}

Plane Blurred(const Picture& size, const std::function<double(std::size_t)>& value)
{
  Plane plane(size.PixelCount());
  for (std::size_t i = 0; i < plane.size(); ++i)
  {
    const double v = value(i);
    plane[i] = std::isfinite(v) ? v : 0;
  }
  BlurAlong(plane, size.Width, size.Height, 1, size.Width);
  BlurAlong(plane, size.Height, size.Width, size.Width, 1);
  return plane;
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
