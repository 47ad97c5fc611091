// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sky/Atmosphere.h"

#include "base/Parallel.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// Lengths in kilometres. Coefficients of Hillaire 2020, table 1.
constexpr double GroundRadius = 6360.0;
constexpr double TopRadius = 6460.0;
constexpr double ViewerRadius = GroundRadius + 0.002; // eyes of a person
const glm::dvec3 RayleighScattering(5.802e-3, 13.558e-3, 33.1e-3);
constexpr double RayleighHeight = 8.0;
constexpr double HazeHeight = 1.2;
constexpr double HazeAlbedo = 0.9; // Bruneton and Neyret 2008
constexpr double HazeAnisotropy = 0.8;
const glm::dvec3 OzoneAbsorption(0.650e-3, 1.881e-3, 0.085e-3);
constexpr double SunRadius = 0.00465; // radians
// Haze dims short waves more, by this power of the wave length. Angstrom 1929, On the Atmospheric Transmission of Sun
// Radiation.
constexpr double HazeExponent = 1.3;

constexpr int TransmittanceColumns = 64, TransmittanceRows = 24;
constexpr int ScatteringColumns = 32, ScatteringRows = 12;
constexpr int DepthSteps = 40, ViewSteps = 40, ScatteringSteps = 16;

double ToTop(double radius, double cosine)
{
  const double inside = radius * radius * (cosine * cosine - 1.0) + TopRadius * TopRadius;
  return std::max(0.0, -radius * cosine + std::sqrt(std::max(0.0, inside)));
}

/// Distance to the ground, or a negative number if the ray misses it.
double ToGround(double radius, double cosine)
{
  const double inside = radius * radius * (cosine * cosine - 1.0) + GroundRadius * GroundRadius;
  return cosine >= 0.0 || inside < 0.0 ? -1.0 : std::max(0.0, -radius * cosine - std::sqrt(inside));
}

double HorizonCosine(double radius)
{
  return -std::sqrt(std::max(0.0, 1.0 - std::pow(GroundRadius / radius, 2.0)));
}

double RayleighPhase(double cosine)
{
  return 3.0 / (16.0 * glm::pi<double>()) * (1.0 + cosine * cosine);
}

// Cornette and Shanks 1992, Physically Reasonable Analytic Expression for the Single-Scattering Phase Function.
double HazePhase(double cosine)
{
  constexpr double g = HazeAnisotropy;
  return 3.0 / (8.0 * glm::pi<double>()) * (1.0 - g * g) * (1.0 + cosine * cosine) /
    ((2.0 + g * g) * std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
}

glm::dvec3 Interpolated(
  const std::vector<glm::dvec3>& table, int columns, int rows, double x, double y)
{
  const double column = std::clamp(x, 0.0, 1.0) * (columns - 1);
  const double row = std::clamp(y, 0.0, 1.0) * (rows - 1);
  const int left = std::min(static_cast<int>(column), columns - 2);
  const int low = std::min(static_cast<int>(row), rows - 2);
  const glm::dvec3* cell = &table[static_cast<std::size_t>(low) * columns + left];
  return glm::mix(glm::mix(cell[0], cell[1], column - left),
    glm::mix(cell[columns], cell[columns + 1], column - left), row - low);
}
}

Atmosphere::Atmosphere(double turbidity, const glm::dvec3& groundAlbedo)
  : Ground(groundAlbedo)
{
  const double depth = (turbidity - 1.0) * RayleighScattering.g * RayleighHeight;
  this->HazeExtinction = depth / HazeHeight *
    glm::dvec3(std::pow(550.0 / 680.0, HazeExponent), 1.0, std::pow(550.0 / 440.0, HazeExponent));
  this->TabulateTransmittance();
  this->TabulateScattering();
}

Atmosphere::Medium Atmosphere::At(double height) const
{
  const double haze = std::exp(-height / HazeHeight);
  Medium medium;
  medium.Rayleigh = RayleighScattering * std::exp(-height / RayleighHeight);
  medium.Haze = HazeAlbedo * haze * this->HazeExtinction;
  medium.Extinction = medium.Rayleigh + haze * this->HazeExtinction +
    OzoneAbsorption * std::max(0.0, 1.0 - std::abs(height - 25.0) / 15.0);
  return medium;
}

// The table's coordinates are those of Bruneton and Neyret 2008: fine near the horizon and near the ground.
void Atmosphere::TabulateTransmittance()
{
  const double horizon = std::sqrt(TopRadius * TopRadius - GroundRadius * GroundRadius);
  this->Transmittance.resize(std::size_t(TransmittanceColumns) * TransmittanceRows);
  ParallelFor(
    this->Transmittance.size(),
    [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        const double rho =
          horizon * static_cast<double>(i / TransmittanceColumns) / (TransmittanceRows - 1);
        const double radius = std::sqrt(rho * rho + GroundRadius * GroundRadius);
        const double least = TopRadius - radius;
        const double length = least +
          static_cast<double>(i % TransmittanceColumns) / (TransmittanceColumns - 1) *
            (rho + horizon - least);
        const double cosine = length == 0.0
          ? 1.0
          : (horizon * horizon - rho * rho - length * length) / (2.0 * radius * length);
        glm::dvec3 depth(0.0);
        for (int step = 0; step < DepthSteps; ++step)
        {
          // Short steps at the beginning, where the air is dense.
          const double from = length * std::pow(double(step) / DepthSteps, 2.0);
          const double to = length * std::pow((step + 1.0) / DepthSteps, 2.0);
          const double middle = 0.5 * (from + to);
          const double place =
            std::sqrt(radius * radius + middle * middle + 2.0 * radius * middle * cosine);
          depth += (to - from) * this->At(std::max(0.0, place - GroundRadius)).Extinction;
        }
        this->Transmittance[i] = glm::exp(-depth);
      }
    },
    256);
}

glm::dvec3 Atmosphere::Through(double radius, double cosine) const
{
  const double horizon = std::sqrt(TopRadius * TopRadius - GroundRadius * GroundRadius);
  const double rho = std::sqrt(std::max(0.0, radius * radius - GroundRadius * GroundRadius));
  const double least = TopRadius - radius;
  const double range = std::max(1e-9, rho + horizon - least);
  return Interpolated(this->Transmittance, TransmittanceColumns, TransmittanceRows,
    (ToTop(radius, cosine) - least) / range, rho / horizon);
}

glm::dvec3 Atmosphere::SunThrough(double radius, double cosine) const
{
  // The disc is cut by the horizon.
  const double visible = glm::smoothstep(-SunRadius, SunRadius, cosine - HorizonCosine(radius));
  return visible > 0.0 ? visible * this->Through(radius, std::max(cosine, HorizonCosine(radius)))
                       : glm::dvec3(0.0);
}

glm::dvec3 Atmosphere::SunAtGround(double sinElevation) const
{
  return this->SunThrough(ViewerRadius, sinElevation);
}

glm::dvec3 Atmosphere::Scattered(double radius, double sunCosine) const
{
  // Rows lie dense near the ground; columns lie dense where the sun sets.
  const double row = std::sqrt(std::max(0.0, (radius - GroundRadius) / (TopRadius - GroundRadius)));
  const double column = 0.5 + 0.5 * std::copysign(std::sqrt(std::abs(sunCosine)), sunCosine);
  return Interpolated(this->Multiple, ScatteringColumns, ScatteringRows, column, row);
}

// Hillaire 2020, section 5.5: light of the second scattering, divided by the share that each further one loses.
void Atmosphere::TabulateScattering()
{
  constexpr int side = 8; // directions: side * side
  constexpr double uniform = 1.0 / (4.0 * glm::pi<double>());
  this->Multiple.resize(std::size_t(ScatteringColumns) * ScatteringRows);
  ParallelFor(
    this->Multiple.size(),
    [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        const double row = static_cast<double>(i / ScatteringColumns) / (ScatteringRows - 1);
        const double column =
          2.0 * static_cast<double>(i % ScatteringColumns) / (ScatteringColumns - 1) - 1.0;
        const double radius = std::max(ViewerRadius,
          std::min(TopRadius - 1e-3, GroundRadius + row * row * (TopRadius - GroundRadius)));
        const double sunCosine = std::copysign(column * column, column);
        const double sunSine = std::sqrt(1.0 - sunCosine * sunCosine);
        glm::dvec3 second(0.0);
        glm::dvec3 again(0.0);
        for (int d = 0; d < side * side; ++d)
        {
          const double cosine = 2.0 * (d / side + 0.5) / side - 1.0;
          const double sine = std::sqrt(1.0 - cosine * cosine);
          const double phi = 2.0 * glm::pi<double>() * (d % side + 0.5) / side;
          const double ground = ToGround(radius, cosine);
          const double length = ground >= 0.0 ? ground : ToTop(radius, cosine);
          const double between = sine * std::cos(phi) * sunSine + cosine * sunCosine;
          glm::dvec3 through(1.0);
          for (int step = 0; step < ScatteringSteps; ++step)
          {
            const double from = length * std::pow(double(step) / ScatteringSteps, 2.0);
            const double to = length * std::pow((step + 1.0) / ScatteringSteps, 2.0);
            const double t = 0.5 * (from + to);
            const double place = std::sqrt(radius * radius + t * t + 2.0 * radius * t * cosine);
            const Medium medium = this->At(std::max(0.0, place - GroundRadius));
            const glm::dvec3 scattering = medium.Rayleigh + medium.Haze;
            const glm::dvec3 kept = glm::exp(-(to - from) * medium.Extinction);
            const glm::dvec3 share = through * (1.0 - kept) / medium.Extinction * scattering;
            again += share;
            second +=
              share * uniform * this->SunThrough(place, (radius * sunCosine + t * between) / place);
            through *= kept;
          }
          if (ground >= 0.0)
          {
            const double facing = (radius * sunCosine + ground * between) / GroundRadius;
            second += through * this->Ground / glm::pi<double>() * std::max(0.0, facing) *
              this->SunThrough(GroundRadius, facing);
          }
        }
        constexpr double directions = side * side;
        this->Multiple[i] = second / directions / (1.0 - again / directions);
      }
    },
    8);
}

glm::dvec3 Atmosphere::Radiance(const glm::dvec3& direction, const glm::dvec3& sun) const
{
  const double cosine = std::max(direction.y, 0.0);
  const double between = glm::dot(direction, sun);
  const double rayleigh = RayleighPhase(between);
  const double haze = HazePhase(between);
  const double length = ToTop(ViewerRadius, cosine);
  glm::dvec3 through(1.0);
  glm::dvec3 sum(0.0);
  for (int step = 0; step < ViewSteps; ++step)
  {
    const double from = length * std::pow(double(step) / ViewSteps, 2.0);
    const double to = length * std::pow((step + 1.0) / ViewSteps, 2.0);
    const double t = 0.5 * (from + to);
    const double place =
      std::sqrt(ViewerRadius * ViewerRadius + t * t + 2.0 * ViewerRadius * t * cosine);
    const double sunCosine = (ViewerRadius * sun.y + t * between) / place;
    const Medium medium = this->At(place - GroundRadius);
    const glm::dvec3 source =
      (medium.Rayleigh * rayleigh + medium.Haze * haze) * this->SunThrough(place, sunCosine) +
      (medium.Rayleigh + medium.Haze) * this->Scattered(place, sunCosine);
    const glm::dvec3 kept = glm::exp(-(to - from) * medium.Extinction);
    sum += through * (1.0 - kept) / medium.Extinction * source;
    through *= kept;
  }
  return sum;
}
}
