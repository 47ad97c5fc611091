// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/sh_probes/Harmonics.h"

#include <glm/gtc/constants.hpp>

#include <cmath>
#include <vector>

namespace penumbra
{
namespace
{
constexpr int Count = 9;
// Number of directions in which signs are checked. They miss the minimum by less than 0.1 %.
constexpr int Directions = 192;

const std::vector<Harmonics>& SampleDirections()
{
  static const std::vector<Harmonics> directions = [] {
    std::vector<Harmonics> values;
    for (int i = 0; i < Directions; ++i)
    {
      // A spiral with even steps in height.
      const double z = 1.0 - (2.0 * i + 1.0) / Directions;
      const double angle = std::sqrt(glm::pi<double>() * Directions) * std::acos(z);
      const double radius = std::sqrt(1.0 - z * z);
      values.push_back(HarmonicsOf({ radius * std::cos(angle), radius * std::sin(angle), z }));
    }
    return values;
  }();
  return directions;
}

double WindowWeight(int band, double strength)
{
  const double laplacian = band * (band + 1.0);
  return 1.0 / (1.0 + strength * laplacian * laplacian);
}

bool IsNegative(const float* colors, double strength)
{
  for (const Harmonics& y : SampleDirections())
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      double sum = 0.0;
      for (int k = 0; k < Count; ++k)
      {
        sum += y[k] * colors[3 * k + channel] * WindowWeight(HarmonicBand(k), strength);
      }
      if (sum < -1e-6 * std::abs(colors[channel]))
      {
        return true;
      }
    }
  }
  return false;
}
}

Harmonics HarmonicsOf(const glm::dvec3& d)
{
  const double pi = glm::pi<double>();
  const double one = std::sqrt(3.0 / (4.0 * pi));
  const double two = std::sqrt(15.0 / (4.0 * pi));
  return { std::sqrt(1.0 / (4.0 * pi)), one * d.y, one * d.z, one * d.x, two * d.x * d.y,
    two * d.y * d.z, std::sqrt(5.0 / (16.0 * pi)) * (3.0 * d.z * d.z - 1.0), two * d.x * d.z,
    0.5 * two * (d.x * d.x - d.y * d.y) };
}

int HarmonicBand(int index)
{
  return index == 0 ? 0 : (index < 4 ? 1 : 2);
}

double CosineKernel(int band)
{
  const double pi = glm::pi<double>();
  if (band == 1)
  {
    return 2.0 * pi / 3.0;
  }
  if (band % 2 == 1)
  {
    return 0.0;
  }
  // 2 pi (-1)^(l/2 - 1) / ((l + 2) (l - 1)) l! / (2^l (l/2)!^2)
  double share = 1.0; // l! / (2^l (l/2)!^2)
  for (int i = 1; i <= band / 2; ++i)
  {
    share *= (2.0 * i - 1.0) / (2.0 * i);
  }
  const double sign = (band / 2) % 2 == 1 ? 1.0 : -1.0;
  return 2.0 * pi * sign / ((band + 2.0) * (band - 1.0)) * share;
}

void ToIrradiance(float* colors)
{
  for (int k = 0; k < Count; ++k)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      colors[3 * k + channel] *=
        static_cast<float>(CosineKernel(HarmonicBand(k)) / glm::pi<double>());
    }
  }
}

double WindowHarmonics(float* colors)
{
  if (!IsNegative(colors, 0.0))
  {
    return 0.0;
  }
  double tooWeak = 0.0;
  double sufficient = 1e-4;
  while (IsNegative(colors, sufficient) && sufficient < 1e6)
  {
    sufficient *= 4.0;
  }
  constexpr int halvings = 16;
  for (int i = 0; i < halvings; ++i)
  {
    const double middle = 0.5 * (tooWeak + sufficient);
    (IsNegative(colors, middle) ? tooWeak : sufficient) = middle;
  }
  for (int k = 0; k < Count; ++k)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      colors[3 * k + channel] *= static_cast<float>(WindowWeight(HarmonicBand(k), sufficient));
    }
  }
  return sufficient;
}
}
