// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image/ColorDifference.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace penumbra::tool
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double Radians = Pi / 180;

// Of D65.
const glm::dvec3 White(0.95047, 1.0, 1.08883);

// Columns are the XYZ of sRGB's red, green and blue.
glm::dmat3 FromLinear()
{
  return { { 0.4124564, 0.2126729, 0.0193339 }, { 0.3575761, 0.7151522, 0.1191920 },
    { 0.1804375, 0.0721750, 0.9503041 } };
}

double Linear(double value)
{
  value = std::clamp(value, 0.0, 1.0);
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double CubeRoot(double ratio)
{
  constexpr double bend = 6.0 / 29;
  return ratio > bend * bend * bend ? std::cbrt(ratio) : ratio / (3 * bend * bend) + 4.0 / 29;
}

/// Hue angle in degrees, 0 to 360; 0 for grey.
double HueOf(double a, double b)
{
  const double angle = a == 0 && b == 0 ? 0 : std::atan2(b, a) / Radians;
  return angle < 0 ? angle + 360 : angle;
}

double Seventh(double chroma)
{
  const double power = std::pow(chroma, 7);
  return std::sqrt(power / (power + std::pow(25.0, 7)));
}

double Square(double value)
{
  return value * value;
}
}

glm::dvec3 LinearOfDisplay(const glm::dvec3& display)
{
  return { Linear(display.r), Linear(display.g), Linear(display.b) };
}

glm::dvec3 RelativeXyz(const glm::dvec3& linear)
{
  return FromLinear() * linear / White;
}

glm::dvec3 LinearOfRelativeXyz(const glm::dvec3& xyz)
{
  static const glm::dmat3 toLinear = glm::inverse(FromLinear());
  return toLinear * (xyz * White);
}

Lab LabOfRelativeXyz(const glm::dvec3& xyz)
{
  const double x = CubeRoot(xyz.x), y = CubeRoot(xyz.y), z = CubeRoot(xyz.z);
  return { 116 * y - 16, 500 * (x - y), 200 * (y - z) };
}

Lab LabOfDisplay(double red, double green, double blue)
{
  return LabOfRelativeXyz(RelativeXyz(LinearOfDisplay({ red, green, blue })));
}

ColorDifference Ciede2000(const Lab& one, const Lab& other)
{
  // The numbers are those of the equations in the paper.
  const double meanChroma = (std::hypot(one.A, one.B) + std::hypot(other.A, other.B)) / 2; // 2, 3
  const double g = 0.5 * (1 - Seventh(meanChroma));                                        // 4
  const double a1 = (1 + g) * one.A, a2 = (1 + g) * other.A;                               // 5
  const double c1 = std::hypot(a1, one.B), c2 = std::hypot(a2, other.B);                   // 6
  const double h1 = HueOf(a1, one.B), h2 = HueOf(a2, other.B);                             // 7
  const bool grey = c1 * c2 == 0;

  double turn = grey ? 0 : h2 - h1; // 10
  turn += turn > 180 ? -360 : turn < -180 ? 360 : 0;
  const double deltaL = other.L - one.L;                                       // 8
  const double deltaC = c2 - c1;                                               // 9
  const double deltaH = 2 * std::sqrt(c1 * c2) * std::sin(turn / 2 * Radians); // 11

  const double l = (one.L + other.L) / 2; // 12
  const double c = (c1 + c2) / 2;         // 13
  double h = h1 + h2;                     // 14
  if (!grey)
  {
    h = std::abs(h1 - h2) <= 180 ? h / 2 : h < 360 ? (h + 360) / 2 : (h - 360) / 2;
  }
  const double t = 1 - 0.17 * std::cos((h - 30) * Radians) + 0.24 * std::cos(2 * h * Radians) +
    0.32 * std::cos((3 * h + 6) * Radians) - 0.20 * std::cos((4 * h - 63) * Radians); // 15
  const double rotation = 30 * std::exp(-Square((h - 275) / 25));                     // 16
  const double weightL = 1 + 0.015 * Square(l - 50) / std::sqrt(20 + Square(l - 50)); // 18
  const double weightC = 1 + 0.045 * c;                                               // 19
  const double weightH = 1 + 0.015 * c * t;                                           // 20
  const double cross = -std::sin(2 * rotation * Radians) * 2 * Seventh(c);            // 17, 21
  const double partL = deltaL / weightL, partC = deltaC / weightC, partH = deltaH / weightH;
  const double square = Square(partL) + Square(partC) + Square(partH) + cross * partC * partH; // 22
  return { std::sqrt(std::max(0.0, square)), std::abs(deltaH) };
}
}
