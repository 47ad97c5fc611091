// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Spherical harmonics of light, against closed-form values.
#include "techniques/sh_probes/Harmonics.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

namespace
{
using namespace penumbra;

// The midpoint rule is accurate enough here; a Gauss-Legendre rule would need tables.
double OverSphere(const std::function<double(const glm::dvec3&)>& function, int steps = 400)
{
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const double z = (2.0 * i + 1.0) / steps - 1.0;
    const double radius = std::sqrt(1.0 - z * z);
    for (int j = 0; j < steps; ++j)
    {
      const double phi = 2.0 * glm::pi<double>() * (j + 0.5) / steps;
      sum += function({ radius * std::cos(phi), radius * std::sin(phi), z });
    }
  }
  return sum * 4.0 * glm::pi<double>() / steps / steps;
}

std::vector<float> Project(const std::function<double(const glm::dvec3&)>& radiance)
{
  std::vector<float> colors(27);
  for (int k = 0; k < 9; ++k)
  {
    const auto value =
      OverSphere([&](const glm::dvec3& d) { return radiance(d) * HarmonicsOf(d)[k]; });
    for (int channel = 0; channel < 3; ++channel)
    {
      colors[3 * k + channel] = static_cast<float>(value);
    }
  }
  return colors;
}

// Light of unit irradiance from one direction.
std::vector<float> Directional(const glm::dvec3& from)
{
  const Harmonics y = HarmonicsOf(from);
  std::vector<float> colors(27);
  for (int k = 0; k < 27; ++k)
  {
    colors[k] = static_cast<float>(y[k / 3]);
  }
  return colors;
}

double Evaluate(const std::vector<float>& colors, const glm::dvec3& d)
{
  const Harmonics y = HarmonicsOf(d);
  double sum = 0.0;
  for (int k = 0; k < 9; ++k)
  {
    sum += colors[3 * k] * y[k];
  }
  return sum;
}

double Legendre(int band, double x)
{
  double previous = 1.0;
  double current = x;
  for (int l = 1; l < band; ++l)
  {
    const double next = ((2.0 * l + 1.0) * x * current - l * previous) / (l + 1.0);
    previous = current;
    current = next;
  }
  return band == 0 ? 1.0 : current;
}

TEST(Harmonics, AreOrthonormal)
{
  for (int i = 0; i < 9; ++i)
  {
    for (int j = i; j < 9; ++j)
    {
      const double product =
        OverSphere([&](const glm::dvec3& d) { return HarmonicsOf(d)[i] * HarmonicsOf(d)[j]; }, 200);
      EXPECT_NEAR(product, i == j ? 1.0 : 0.0, 1e-3) << i << " " << j;
    }
  }
}

TEST(Harmonics, CosineKernel)
{
  const double pi = glm::pi<double>();
  const double expected[5] = { pi, 2.0 * pi / 3.0, pi / 4.0, 0.0, -pi / 24.0 };
  for (int band = 0; band < 5; ++band)
  {
    double integral = 0.0; // 2 pi times the integral of P_l(x) x from 0 to 1
    constexpr int steps = 20000;
    for (int i = 0; i < steps; ++i)
    {
      const double x = (i + 0.5) / steps;
      integral += 2.0 * pi * Legendre(band, x) * x / steps;
    }
    std::printf("A%d = %.5f\n", band, CosineKernel(band));
    EXPECT_NEAR(CosineKernel(band), expected[band], 1e-12);
    EXPECT_NEAR(CosineKernel(band), integral, 1e-6);
  }
}

TEST(Harmonics, OneDirectionalLight)
{
  const glm::dvec3 from = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
  std::vector<float> light = Directional(from);
  ToIrradiance(light.data());
  const double pi = glm::pi<double>();
  double minimum = 1.0;
  double minimumCosine = 0.0;
  double squares = 0.0;
  const glm::dvec3 side = glm::normalize(glm::cross(from, glm::dvec3(1.0, 0.0, 0.0)));
  constexpr int steps = 3000;
  for (int i = 0; i < steps; ++i)
  {
    const double cosine = (2.0 * i + 1.0) / steps - 1.0; // uniform over the sphere
    const glm::dvec3 n = cosine * from + std::sqrt(1.0 - cosine * cosine) * side;
    const double value = pi * Evaluate(light, n);
    minimumCosine = value < minimum ? cosine : minimumCosine;
    minimum = std::min(minimum, value);
    const double error = value - std::max(cosine, 0.0);
    squares += error * error / steps;
  }
  const double peak = pi * Evaluate(light, from);
  const double opposite = pi * Evaluate(light, -from);
  std::printf("peak %.4f, opposite %.4f, minimum %.5f at %.4f, root mean square error %.4f\n", peak,
    opposite, minimum, minimumCosine, std::sqrt(squares));
  EXPECT_NEAR(peak, 1.0625, 5e-5);
  EXPECT_NEAR(opposite, 0.0625, 5e-5);
  EXPECT_NEAR(minimum, -0.03958, 5e-6);
  EXPECT_NEAR(minimumCosine, -8.0 / 15.0, 1e-3);
  EXPECT_NEAR(std::sqrt(squares), 0.0361, 5e-5);
}

TEST(Harmonics, AConstantEnvironmentIsExact)
{
  std::vector<float> light = Project([](const glm::dvec3&) { return 0.7; });
  ToIrradiance(light.data());
  EXPECT_EQ(WindowHarmonics(light.data()), 0.0);
  for (const glm::dvec3& n : { glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.6, 0.0, -0.8) })
  {
    EXPECT_NEAR(Evaluate(light, n), 0.7, 1e-5);
  }
}

TEST(Harmonics, RotationInvariance)
{
  const auto radiance = [](const glm::dvec3& d) {
    return 1.0 + d.x + 0.5 * d.y * d.z + std::max(d.z, 0.0);
  };
  const glm::dmat3 turn = glm::mat3_cast(glm::angleAxis(1.1, glm::normalize(glm::dvec3(1, 2, 3))));
  std::vector<float> straight = Project(radiance);
  std::vector<float> turned =
    Project([&](const glm::dvec3& d) { return radiance(glm::transpose(turn) * d); });
  ToIrradiance(straight.data());
  ToIrradiance(turned.data());
  for (const glm::dvec3& n : { glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, -0.6, 0.8),
         glm::normalize(glm::dvec3(-1.0, 2.0, 0.5)) })
  {
    EXPECT_NEAR(Evaluate(turned, turn * n), Evaluate(straight, n), 1e-3);
  }
}

TEST(Harmonics, TheWindowIsAsStrongAsNecessary)
{
  std::vector<float> light = Directional({ 0.0, 0.0, 1.0 });
  ToIrradiance(light.data());
  const float mean = light[0];
  const double strength = WindowHarmonics(light.data());
  EXPECT_GT(strength, 0.0);
  EXPECT_EQ(light[0], mean);
  double minimum = 1.0;
  for (int i = 0; i <= 2000; ++i)
  {
    const double z = i / 1000.0 - 1.0;
    minimum = std::min(minimum, Evaluate(light, { std::sqrt(std::max(0.0, 1.0 - z * z)), 0.0, z }));
  }
  const double peak = glm::pi<double>() * Evaluate(light, { 0.0, 0.0, 1.0 });
  double squares = 0.0;
  constexpr int steps = 2000;
  for (int i = 0; i < steps; ++i)
  {
    const double z = (2.0 * i + 1.0) / steps - 1.0;
    const double value = glm::pi<double>() * Evaluate(light, { std::sqrt(1.0 - z * z), 0.0, z });
    squares += std::pow(value - std::max(z, 0.0), 2.0) / steps;
  }
  std::printf("strength %.4f: minimum %.6f, peak %.4f, root mean square error %.4f\n", strength,
    minimum, peak, std::sqrt(squares));
  EXPECT_GT(minimum, -0.0005); // in units of 1 / pi
  EXPECT_LT(minimum, 0.002);   // no stronger than necessary
  EXPECT_GT(peak, 0.5);
}
}
