// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/Light.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace penumbra::lightmap
{
namespace
{
constexpr double Spacing = 0.4; // texels between points of a seam that are compared

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

/// One equation: the two sides of a point of a seam are the same.
struct Equation
{
  std::array<std::uint32_t, 8> Unknowns;
  std::array<double, 8> Weights;
};

/// The normal equations' matrix times x: equations first, then each texel kept where it was.
std::vector<double> Multiply(const std::vector<Equation>& equations, const std::vector<double>& x,
  const std::vector<double>& keep)
{
  std::vector<double> result(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    result[i] = keep[i] * x[i];
  }
  for (const Equation& equation : equations)
  {
    double differs = 0.0;
    for (std::size_t k = 0; k < equation.Unknowns.size(); ++k)
    {
      differs += equation.Weights[k] * x[equation.Unknowns[k]];
    }
    for (std::size_t k = 0; k < equation.Unknowns.size(); ++k)
    {
      result[equation.Unknowns[k]] += equation.Weights[k] * differs;
    }
  }
  return result;
}

double Dot(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += a[i] * b[i];
  }
  return sum;
}

/// Conjugate gradients (Hestenes and Stiefel 1952), from x on. keep: how much each texel is to stay what it is.
void Solve(
  const std::vector<Equation>& equations, std::vector<double>& x, const std::vector<double>& keep)
{
  constexpr int most = 2000;
  constexpr double enough = 1e-14; // of the first residual, squared
  std::vector<double> wanted(x);
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    wanted[i] *= keep[i];
  }
  const std::vector<double> product = Multiply(equations, x, keep);
  std::vector<double> residual(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    residual[i] = wanted[i] - product[i];
  }
  std::vector<double> direction = residual;
  double now = Dot(residual, residual);
  const double end = enough * now;
  for (int step = 0; step < most && now > end && now > 0.0; ++step)
  {
    const std::vector<double> across = Multiply(equations, direction, keep);
    const double length = now / Dot(direction, across);
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      x[i] += length * direction[i];
      residual[i] -= length * across[i];
    }
    const double next = Dot(residual, residual);
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      direction[i] = residual[i] + next / now * direction[i];
    }
    now = next;
  }
}
}

double Light::Sample(const Vec2& at, int channel) const
{
  double sum = 0.0;
  for (const Tap& tap : TapsAt(*this, at))
  {
    sum += tap.Weight * this->At(tap.Texel)[channel];
  }
  return sum;
}

void CloseSeams(
  Light& light, const std::vector<SeamLine>& lines, const std::vector<unsigned char>& fixed)
{
  const auto isFixed = [&fixed](std::uint32_t texel) { return !fixed.empty() && fixed[texel]; };
  std::unordered_map<std::uint32_t, std::uint32_t> unknown;
  std::vector<std::uint32_t> texels;
  std::vector<Equation> equations;
  ForPoints(lines, [&](const Vec2& a, const Vec2& b) {
    Equation equation;
    for (int side = 0; side < 2; ++side)
    {
      const Taps taps = TapsAt(light, side == 0 ? a : b);
      for (std::size_t k = 0; k < taps.size(); ++k)
      {
        const auto found =
          unknown.emplace(taps[k].Texel, static_cast<std::uint32_t>(texels.size()));
        if (found.second)
        {
          texels.push_back(taps[k].Texel);
        }
        equation.Unknowns[4 * side + k] = found.first->second;
        equation.Weights[4 * side + k] = (side == 0 ? 1.0 : -1.0) * taps[k].Weight;
      }
    }
    if (!std::all_of(equation.Unknowns.begin(), equation.Unknowns.end(),
          [&](std::uint32_t i) { return isFixed(texels[i]); }))
    {
      equations.push_back(equation);
    }
  });
  constexpr double little = 1e-4; // what remains of a step is about this share of it
  constexpr double fast = 1000.0;
  constexpr int rounds = 4;
  for (int channel = 0; channel < light.Channels; ++channel)
  {
    std::vector<double> x(texels.size());
    for (std::size_t i = 0; i < texels.size(); ++i)
    {
      x[i] = light.At(texels[i])[channel];
    }
    const bool irradiance = channel < 3; // is never below 0, its first moments may be
    std::vector<double> keep(texels.size(), little);
    for (std::size_t i = 0; i < texels.size(); ++i)
    {
      keep[i] = isFixed(texels[i]) ? fast : little;
    }
    for (int round = 0; round < rounds; ++round)
    {
      Solve(equations, x, keep);
      // What had to be darker than black is black, and the others make up for it.
      bool below = false;
      for (std::size_t i = 0; i < texels.size() && irradiance; ++i)
      {
        if (x[i] < 0.0)
        {
          below = true;
          x[i] = 0.0;
          keep[i] = fast;
        }
      }
      if (!below)
      {
        break;
      }
    }
    for (std::size_t i = 0; i < texels.size(); ++i)
    {
      if (!isFixed(texels[i]))
      {
        light.At(texels[i])[channel] = static_cast<float>(irradiance ? std::max(x[i], 0.0) : x[i]);
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
      mean += 0.5 * (light.Sample(a, channel) + light.Sample(b, channel));
      ++count;
    }
  });
  mean = count > 0 ? mean / static_cast<double>(count) : 0.0;
  double most = 0.0;
  ForPoints(lines, [&](const Vec2& a, const Vec2& b) {
    for (int channel = 0; channel < 3 && mean > 0.0; ++channel)
    {
      const double one = light.Sample(a, channel), other = light.Sample(b, channel);
      constexpr double dark = 0.1; // of the mean, below which steps count as if it were so bright
      most = std::max(most, std::abs(one - other) / std::max(0.5 * (one + other), dark * mean));
    }
  });
  return most;
}
}
