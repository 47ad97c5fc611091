// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Random numbers and stratified samples. They depend only on the element, not on the thread.
#pragma once

#include "bake/radiosity/Patches.h"

#include <glm/gtc/constants.hpp>

#include <cstdint>

namespace penumbra::radiosity
{
/// Steele, Lea, Flood 2014, Fast Splittable Pseudorandom Number Generators.
class Random
{
public:
  Random(std::uint64_t stream, std::uint64_t purpose)
    : State(Mix(stream * 0xd1342543de82ef95u + purpose))
  {
  }
  double Next() ///< in [0, 1)
  {
    this->State += 0x9e3779b97f4a7c15u;
    return static_cast<double>(Mix(this->State) >> 11) * 0x1.0p-53;
  }
  std::size_t Below(std::size_t count) { return static_cast<std::size_t>(this->Next() * count); }

private:
  static std::uint64_t Mix(std::uint64_t z)
  {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::uint64_t State;
};

/// Stratified points of the unit square: one in each cell of a grid, in random order.
inline std::vector<glm::dvec2> Strata(int side, Random& random)
{
  std::vector<glm::dvec2> points;
  points.reserve(static_cast<std::size_t>(side) * side);
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      points.emplace_back((x + random.Next()) / side, (y + random.Next()) / side);
    }
  }
  for (std::size_t i = points.size(); i > 1; --i)
  {
    std::swap(points[i - 1], points[random.Below(i)]);
  }
  return points;
}

/// The side of the smallest grid with at least this number of cells.
inline int GridSide(int samples)
{
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(double(samples)) - 1e-9)));
}

/// A direction with a density of cosine / pi over the hemisphere, by uniform sampling of the disc below it (Malley's method:
/// Pharr, Jakob and Humphreys 2016, Physically Based Rendering, section 13.6.3).
inline Point CosineDirection(const Point& normal, const glm::dvec2& u)
{
  const Point side =
    glm::normalize(glm::cross(normal, std::abs(normal.x) < 0.5 ? Point(1, 0, 0) : Point(0, 1, 0)));
  const double angle = 2.0 * glm::pi<double>() * u.y;
  const double radius = std::sqrt(u.x);
  return radius * (std::cos(angle) * side + std::sin(angle) * glm::cross(normal, side)) +
    std::sqrt(std::max(0.0, 1.0 - u.x)) * normal;
}
}
