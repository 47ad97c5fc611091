// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/Light.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace penumbra::lightmap
{
namespace
{
constexpr double Spacing = 0.4; // distance in texels between the compared points of a seam

struct Tap
{
  std::uint32_t Texel;
  double Weight;
};
using Taps = std::array<Tap, 4>;

Taps TapsAt(const Light& light, const Vec2& at)
{
  const Vec2 inside = glm::clamp(at, Vec2(0.0), Vec2(light.Width - 1, light.Height - 1));
  const glm::ivec2 low = glm::min(
    glm::ivec2(glm::floor(inside)), glm::max(glm::ivec2(light.Width, light.Height) - 2, 0));
  const Vec2 f = inside - Vec2(low);
  Taps taps;
  for (int i = 0; i < 4; ++i)
  {
    const int x = std::min(low.x + (i & 1), light.Width - 1);
    const int y = std::min(low.y + (i >> 1), light.Height - 1);
    taps[i] = { static_cast<std::uint32_t>(y * light.Width + x),
      ((i & 1) ? f.x : 1.0 - f.x) * ((i >> 1) ? f.y : 1.0 - f.y) };
  }
  return taps;
}

template <typename Visit>
void ForPoints(const std::vector<SeamLine>& lines, const Visit& visit)
{
  for (const SeamLine& line : lines)
  {
    double length = 0.0;
    for (const auto& ends : line.Ends)
    {
      length = std::max(length, glm::length(ends[1] - ends[0]));
    }
    const int count = std::max(2, static_cast<int>(std::ceil(length / Spacing)) + 1);
    for (int i = 0; i < count; ++i)
    {
      const double u = double(i) / (count - 1);
      visit(glm::mix(line.Ends[0][0], line.Ends[0][1], u),
        glm::mix(line.Ends[1][0], line.Ends[1][1], u));
    }
  }
}

using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Least squares of the differences at seams, and of each texel's change from x, weighted by keep.
Eigen::VectorXd Solve(const Matrix& squares, const Eigen::VectorXd& x, const Eigen::VectorXd& keep)
{
  Matrix kept(x.size(), x.size());
  kept.reserve(Eigen::VectorXi::Constant(x.size(), 1));
  for (Eigen::Index i = 0; i < x.size(); ++i)
  {
    kept.insert(i, i) = keep[i];
  }
  const Matrix system = squares + kept;
  constexpr int most = 2000;
  constexpr double enough = 1e-9;
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> solver(system);
  solver.setMaxIterations(most).setTolerance(enough);
  return solver.solveWithGuess(keep.cwiseProduct(x), x);
}
}

double Sample(const Light& light, const Vec2& at, int channel)
{
  double sum = 0.0;
  for (const Tap& tap : TapsAt(light, at))
  {
    sum += tap.Weight * light.Pixel(tap.Texel)[channel];
  }
  return sum;
}

void CloseSeams(
  Light& light, const std::vector<SeamLine>& lines, const std::vector<unsigned char>& fixed)
{
  const auto isFixed = [&fixed](std::uint32_t texel) { return !fixed.empty() && fixed[texel]; };
  std::unordered_map<std::uint32_t, int> unknown;
  std::vector<std::uint32_t> texels;
  std::vector<Eigen::Triplet<double>> weights; // one row per point of a seam: both sides are equal
  int rows = 0;
  ForPoints(lines, [&](const Vec2& a, const Vec2& b) {
    const std::array<Taps, 2> sides = { TapsAt(light, a), TapsAt(light, b) };
    bool moves = false;
    for (const Taps& taps : sides)
    {
      moves = moves ||
        std::any_of(taps.begin(), taps.end(), [&](const Tap& tap) { return !isFixed(tap.Texel); });
    }
    for (int side = 0; side < 2 && moves; ++side)
    {
      for (const Tap& tap : sides[side])
      {
        const auto found = unknown.emplace(tap.Texel, static_cast<int>(texels.size()));
        if (found.second)
        {
          texels.push_back(tap.Texel);
        }
        weights.emplace_back(rows, found.first->second, side == 0 ? tap.Weight : -tap.Weight);
      }
    }
    rows += moves ? 1 : 0;
  });
  if (texels.empty())
  {
    return;
  }
  const auto count = static_cast<Eigen::Index>(texels.size());
  Matrix equations(rows, count);
  equations.setFromTriplets(weights.begin(), weights.end());
  const Matrix squares = equations.transpose() * equations;
  constexpr double little = 1e-4; // about the share of a step that remains
  constexpr double fast = 1000.0;
  constexpr int rounds = 4;
  for (int channel = 0; channel < light.Channels; ++channel)
  {
    const bool irradiance = channel < 3; // never negative, unlike moments
    Eigen::VectorXd x(count), keep(count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      x[i] = light.Pixel(texels[i])[channel];
      keep[i] = isFixed(texels[i]) ? fast : little;
    }
    for (int round = 0; round < rounds; ++round)
    {
      x = Solve(squares, x, keep);
      if (!irradiance || x.minCoeff() >= 0.0)
      {
        break;
      }
      // Negative texels become black, and others compensate for it.
      keep = (x.array() < 0.0).select(fast, keep);
      x = x.cwiseMax(0.0);
    }
    for (Eigen::Index i = 0; i < count; ++i)
    {
      if (!isFixed(texels[i]))
      {
        light.Pixel(texels[i])[channel] =
          static_cast<float>(irradiance ? std::max(x[i], 0.0) : x[i]);
      }
    }
  }
}

double SeamStep(const Light& light, const std::vector<SeamLine>& lines)
{
  double mean = 0.0;
  std::size_t count = 0;
  ForPoints(lines, [&](const Vec2& a, const Vec2& b) {
    for (int channel = 0; channel < 3; ++channel)
    {
      mean += 0.5 * (Sample(light, a, channel) + Sample(light, b, channel));
      ++count;
    }
  });
  mean = count > 0 ? mean / static_cast<double>(count) : 0.0;
  double most = 0.0;
  ForPoints(lines, [&](const Vec2& a, const Vec2& b) {
    for (int channel = 0; channel < 3 && mean > 0.0; ++channel)
    {
      const double one = Sample(light, a, channel), other = Sample(light, b, channel);
      constexpr double dark = 0.1; // of the mean: the least light that steps are relative to
      most = std::max(most, std::abs(one - other) / std::max(0.5 * (one + other), dark * mean));
    }
  });
  return most;
}
}
