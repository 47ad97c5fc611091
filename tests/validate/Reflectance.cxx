// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reflectance.h"

#include <algorithm>
#include <cmath>

namespace validate
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int Steps = 1000; // per axis; doubling it changes no result here by more than 0.01 %

/// Mean of a function over the unit square.
template <typename Function>
double MeanOverSquare(const Function& function)
{
  double sum = 0.0;
  for (int i = 0; i < Steps; ++i)
  {
    for (int j = 0; j < Steps; ++j)
    {
      sum += function((i + 0.5) / Steps, (j + 0.5) / Steps);
    }
  }
  return sum / Steps / Steps;
}

double Fresnel(double f0, double f90, double cosine)
{
  return f0 + (f90 - f0) * std::pow(1.0 - cosine, 5.0);
}
}

double PhongAlbedo(double diffuse, double specular, double power, double cosView)
{
  const double sinView = std::sqrt(1.0 - cosView * cosView);
  // Directions are sampled by the angle to the mirrored view: cos^n dω = 2π / (n + 1) du dv with cos = u^(1/(n+1)).
  const double visibleShare = MeanOverSquare([&](double u, double v) {
    const double cosine = std::pow(u, 1.0 / (power + 1.0));
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const double up = cosine * cosView + sine * std::cos(2.0 * Pi * v) * sinView;
    return up > 0.0 ? 1.0 : 0.0;
  });
  return diffuse + specular * 2.0 / (power + 1.0) * visibleShare;
}

double PhysicalAlbedo(double color, double metallic, double roughness, double cosView)
{
  const double sinView = std::sqrt(1.0 - cosView * cosView);
  const double base = 0.04; // ((1.5 - 1) / (1.5 + 1))^2
  const double f0 = base + (color - base) * metallic;
  const double edge = std::min(1.0, 3.0 * f0 * 50.0 * 0.33); // sum of three equal colour channels
  const double f90 = edge + (1.0 - edge) * metallic;
  const double width = roughness * roughness; // width of the distribution
  const double smith = roughness * roughness; // squared width of the visibility
  // Highlight: normals H are sampled with density D cos; light directions are the view mirrored in them.
  const double highlight = MeanOverSquare([&](double u, double v) {
    const double cosine2 = (1.0 - u) / (1.0 + (width * width - 1.0) * u);
    const double NdH = std::sqrt(cosine2);
    const double VdH = NdH * cosView + std::sqrt(1.0 - cosine2) * std::cos(2.0 * Pi * v) * sinView;
    const double NdL = 2.0 * VdH * NdH - cosView;
    if (VdH <= 0.0 || NdL <= 0.0)
    {
      return 0.0;
    }
    const double visibility = 0.5 /
      (NdL * std::sqrt(smith + cosView * cosView * (1.0 - smith)) +
        cosView * std::sqrt(smith + NdL * NdL * (1.0 - smith)));
    return visibility * Fresnel(f0, f90, VdH) * NdL * 4.0 * VdH / NdH;
  });
  // Diffuse part: sampled by the light's cosine.
  const double matte = MeanOverSquare([&](double u, double v) {
    const double NdL = std::sqrt(1.0 - u);
    const double VdL = NdL * cosView + std::sqrt(u) * std::cos(2.0 * Pi * v) * sinView;
    const double HdL = std::sqrt(0.5 * (1.0 + VdL));
    return 1.0 - Fresnel(f0, f90, HdL);
  });
  return highlight + (1.0 - metallic) * color * matte;
}
}
