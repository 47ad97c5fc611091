// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image/Flip.h"

#include "common/ForEach.h"
#include "image/ColorDifference.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>

// Constants without a comment are the paper's, from its section 4.
namespace penumbra::tool
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double ColorExponent = 0.7;
constexpr double FeatureExponent = 0.5;
constexpr double FeatureWidth = 0.082; // of edges and points, in degrees

/// Luminance, red-green and blue-yellow, linear in radiance: the opponent space in which the eye's filters are known.
using Opponents = std::array<Plane, 3>;

glm::dvec3 OpponentsOf(const glm::dvec3& xyz)
{
  return { 116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z) };
}

glm::dvec3 XyzOf(const glm::dvec3& opponents)
{
  const double y = (opponents.x + 16) / 116;
  return { y + opponents.y / 500, y, y - opponents.z / 200 };
}

Opponents OpponentsOf(const Picture& picture)
{
  Opponents result;
  result.fill(Plane(picture.PixelCount()));
  ForEach(picture.PixelCount(), [&](std::size_t i) {
    glm::dvec3 color(picture.Color(i, 0), picture.Color(i, 1), picture.Color(i, 2));
    for (int channel = 0; channel < 3; ++channel)
    {
      color[channel] = std::isfinite(color[channel]) ? color[channel] : 0;
    }
    const glm::dvec3 value = OpponentsOf(RelativeXyz(LinearOfDisplay(color)));
    for (int channel = 0; channel < 3; ++channel)
    {
      result[channel][i] = value[channel];
    }
  });
  return result;
}

/// The contrast sensitivity of one opponent as a sum of Gaussians exp(-pi^2 x^2 / b) with x in degrees.
struct Sensitivity
{
  struct Gaussian
  {
    double A, B;
  };
  std::vector<Gaussian> Parts;
};

const std::array<Sensitivity, 3> Sensitivities = { { { { { 1, 0.0047 } } }, { { { 1, 0.0053 } } },
  { { { 34.1, 0.04 }, { 13.5, 0.025 } } } } };
constexpr double WidestPart = 0.04;

double Sum(const Weights& weights)
{
  double sum = 0;
  for (const double weight : weights)
  {
    sum += weight;
  }
  return sum;
}

/// The picture as the eye sees it from the distance: fine detail is lost.
Plane Seen(const Plane& plane, int width, const Sensitivity& sensitivity, double pixelsPerDegree)
{
  const int reach =
    static_cast<int>(std::ceil(3 * std::sqrt(WidestPart / (2 * Pi * Pi)) * pixelsPerDegree));
  Plane result(plane.size(), 0.0);
  double total = 0;
  for (const Sensitivity::Gaussian& part : sensitivity.Parts)
  {
    Weights weights;
    for (int i = -reach; i <= reach; ++i)
    {
      const double x = i / pixelsPerDegree;
      weights.push_back(std::exp(-Pi * Pi * x * x / part.B));
    }
    const double amplitude = part.A * std::sqrt(Pi / part.B);
    total += amplitude * Sum(weights) * Sum(weights);
    const Plane filtered = Convolved(plane, width, weights, weights);
    for (std::size_t i = 0; i < result.size(); ++i)
    {
      result[i] += amplitude * filtered[i];
    }
  }
  for (double& value : result)
  {
    value /= total;
  }
  return result;
}

/// CIELAB, with less chroma where it is dark (Hunt's effect).
Lab HuntAdjusted(const glm::dvec3& linear)
{
  Lab lab = LabOfRelativeXyz(RelativeXyz(linear));
  lab.A *= 0.01 * lab.L;
  lab.B *= 0.01 * lab.L;
  return lab;
}

/// HyAB (Abasi, Tehran and Fairchild 2020), which holds for large differences too, raised to the colour exponent.
double Distance(const Lab& one, const Lab& other)
{
  const double hyab = std::abs(one.L - other.L) + std::hypot(one.A - other.A, one.B - other.B);
  return std::pow(hyab, ColorExponent);
}

/// Distances within 0..1: most of the range for those up to a share of the greatest, between green and blue.
double Redistributed(double distance)
{
  constexpr double share = 0.4, target = 0.95;
  static const double greatest = Distance(HuntAdjusted({ 0, 1, 0 }), HuntAdjusted({ 0, 0, 1 }));
  const double bend = share * greatest;
  return distance < bend ? target / bend * distance
                         : target + (distance - bend) / (greatest - bend) * (1 - target);
}

Plane ColorDifferences(const Opponents& a, const Opponents& b, int width, double pixelsPerDegree)
{
  std::array<Opponents, 2> seen;
  for (int channel = 0; channel < 3; ++channel)
  {
    seen[0][channel] = Seen(a[channel], width, Sensitivities[channel], pixelsPerDegree);
    seen[1][channel] = Seen(b[channel], width, Sensitivities[channel], pixelsPerDegree);
  }
  Plane result(a[0].size());
  ForEach(result.size(), [&](std::size_t i) {
    Lab colors[2];
    for (int k = 0; k < 2; ++k)
    {
      const glm::dvec3 opponents(seen[k][0][i], seen[k][1][i], seen[k][2][i]);
      colors[k] = HuntAdjusted(glm::clamp(LinearOfRelativeXyz(XyzOf(opponents)), 0.0, 1.0));
    }
    result[i] = Redistributed(Distance(colors[0], colors[1]));
  });
  return result;
}

/// Scale the positive weights to a sum of 1, and the negative ones to -1.
Weights Balanced(Weights weights)
{
  double positive = 0, negative = 0;
  for (const double weight : weights)
  {
    (weight > 0 ? positive : negative) += std::abs(weight);
  }
  for (double& weight : weights)
  {
    weight /= weight > 0 ? positive : negative;
  }
  return weights;
}

struct Features
{
  Plane Edges, Points; ///< how strong they are
};

/// Magnitude of two filters, one across and one down.
Plane Magnitude(const Plane& plane, int width, const Weights& filter, const Weights& blur)
{
  Plane across = Convolved(plane, width, filter, blur);
  const Plane down = Convolved(plane, width, blur, filter);
  for (std::size_t i = 0; i < across.size(); ++i)
  {
    across[i] = std::hypot(across[i], down[i]);
  }
  return across;
}

Features FeaturesOf(const Plane& opponent, int width, double pixelsPerDegree)
{
  Plane luminance = opponent; // from 0 to 1
  for (double& value : luminance)
  {
    value = (value + 16) / 116;
  }
  const double deviation = 0.5 * FeatureWidth * pixelsPerDegree;
  const int reach = static_cast<int>(std::ceil(3 * deviation));
  const Weights blur = GaussianWeights(deviation, reach);
  Weights first, second; // derivatives of the Gaussian
  for (int i = -reach; i <= reach; ++i)
  {
    first.push_back(-i * blur[i + reach]);
    second.push_back((i * i / (deviation * deviation) - 1) * blur[i + reach]);
  }
  return { Magnitude(luminance, width, Balanced(first), blur),
    Magnitude(luminance, width, Balanced(second), blur) };
}
}

Plane Flip(const Picture& a, const Picture& b, double pixelsPerDegree)
{
  const Opponents first = OpponentsOf(a), second = OpponentsOf(b);
  Plane result = ColorDifferences(first, second, a.Width, pixelsPerDegree);
  const Features one = FeaturesOf(first[0], a.Width, pixelsPerDegree);
  const Features other = FeaturesOf(second[0], a.Width, pixelsPerDegree);
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    const double difference =
      std::max(std::abs(one.Edges[i] - other.Edges[i]), std::abs(one.Points[i] - other.Points[i]));
    const double feature = std::pow(difference / std::sqrt(2.0), FeatureExponent);
    result[i] = std::pow(result[i], 1 - feature);
  }
  return result;
}
}
