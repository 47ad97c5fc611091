// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The published tone curves, written from their formulas.
#pragma once

#include <glm/glm.hpp>

namespace penumbra_test
{
/// Khronos PBR Neutral as published. fresnel: 0.04 there; 0 for materials without a coat.
inline glm::dvec3 Neutral(glm::dvec3 color, double fresnel)
{
  const double start = 0.8 - fresnel;
  const double x = std::min(color.r, std::min(color.g, color.b));
  color -= fresnel <= 0.0 ? 0.0 : x < 2.0 * fresnel ? x - x * x / (4.0 * fresnel) : fresnel;
  const double peak = std::max(color.r, std::max(color.g, color.b));
  if (peak < start)
  {
    return color;
  }
  const double d = 1.0 - start;
  const double newPeak = 1.0 - d * d / (peak + d - start);
  const double g = 1.0 - 1.0 / (0.15 * (peak - newPeak) + 1.0);
  return glm::mix(color * (newPeak / peak), glm::dvec3(newPeak), g);
}

/// Narkowicz 2015.
inline double Filmic(double x)
{
  return glm::clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}
}
