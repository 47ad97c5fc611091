// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image/Flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace
{
using namespace penumbra::tool;

constexpr int Side = 48;
using Color = std::array<float, 3>;

Picture Paint(const std::function<Color(int, int)>& color)
{
  Picture picture(Side, Side, 3);
  for (int i = 0; i < Side * Side; ++i)
  {
    const Color value = color(i % Side, i / Side);
    std::copy(value.begin(), value.end(), picture.Pixel(i));
  }
  return picture;
}

Picture Plain(const Color& color)
{
  return Paint([&](int, int) { return color; });
}

double Mean(const Plane& plane)
{
  double sum = 0;
  for (const double value : plane)
  {
    sum += value;
  }
  return sum / static_cast<double>(plane.size());
}

double MeanFlip(const Picture& a, const Picture& b)
{
  return Mean(Flip(a, b));
}

// Noise that is the same on all machines.
double Noise(int x, int y)
{
  const double value = std::sin(12.9898 * x + 78.233 * y) * 43758.5453;
  return value - std::floor(value);
}
}

// Without features, FLIP is the colour difference: of green and blue 1 by definition, of black and white from the paper's
// equations: HyAB is 100, thus 100^0.7 = 25.12 of at most 41.28.
TEST(Flip, OfPlainColors)
{
  const Picture black = Plain({ 0, 0, 0 }), white = Plain({ 1, 1, 1 });
  EXPECT_NEAR(
    MeanFlip(black, white), 0.95 + (25.1189 - 0.4 * 41.276) / (0.6 * 41.276) * 0.05, 1e-4);
  EXPECT_NEAR(MeanFlip(Plain({ 0, 1, 0 }), Plain({ 0, 0, 1 })), 1.0, 1e-9);
  EXPECT_EQ(MeanFlip(white, white), 0.0);
  const double small = MeanFlip(Plain({ 0.5f, 0.5f, 0.5f }), Plain({ 0.51f, 0.5f, 0.5f }));
  EXPECT_GT(small, 0.01);
  EXPECT_LT(small, 0.1);
}

// The authors' implementation gives these means (version 1.6, 67.02 pixels per degree).
TEST(Flip, EqualsTheAuthorsImplementation)
{
  const Picture black = Plain({ 0, 0, 0 });
  const Picture halves = Paint([](int x, int) {
    return x < Side / 2 ? Color{ 0, 0, 0 } : Color{ 1, 1, 1 };
  });
  const Picture noise = Paint([](int x, int y) {
    const auto grey = static_cast<float>(std::floor(255 * Noise(x, y)) / 255);
    return Color{ grey, grey, 1 - grey };
  });
  EXPECT_NEAR(MeanFlip(halves, black), 0.542983, 1e-4);
  EXPECT_NEAR(MeanFlip(noise, black), 0.966106, 1e-4);
  EXPECT_NEAR(MeanFlip(noise, halves), 0.902689, 1e-4);
}

TEST(Flip, IsSymmetric)
{
  const Picture line = Paint([](int x, int y) {
    return x == y ? Color{ 1, 0.2f, 0 } : Color{ 0.3f, 0.4f, 0.5f };
  });
  const Picture plain = Plain({ 0.3f, 0.4f, 0.5f });
  const Plane one = Flip(line, plain), other = Flip(plain, line);
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    ASSERT_DOUBLE_EQ(one[i], other[i]);
  }
  EXPECT_GT(one[(Side / 2) * Side + Side / 2], 0.3); // on the line
  EXPECT_LT(one[Side - 1], 1e-6);                    // far from it
}

// From farther away, a pixel is smaller, and fine noise blends.
TEST(Flip, FallsWithDistance)
{
  const Picture grey = Plain({ 0.5f, 0.5f, 0.5f });
  const Picture noise = Paint([](int x, int y) {
    const auto value = static_cast<float>(0.4 + 0.2 * Noise(x, y));
    return Color{ value, value, value };
  });
  EXPECT_LT(Mean(Flip(noise, grey, 134)), 0.8 * Mean(Flip(noise, grey, 33)));
}

TEST(Flip, BearsAnyValue)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Picture odd = Paint([&](int x, int) {
    return Color{ x == 3 ? nan : 1e30f, -1e30f, x == 4 ? INFINITY : 0.f };
  });
  for (const double value : Flip(odd, Plain({ 0, 0, 0 })))
  {
    ASSERT_GE(value, 0.0);
    ASSERT_LE(value, 1.0);
  }
}
