// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/shadow_maps/ShadowCascades.h"

#include "light/LightTable.h"
#include "technique/FrameBuilder.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// Shadow texels of at most so many pixels are fine enough.
constexpr double FinePixels = 2.0;
// Another cascade pays where it makes the coarsest texels finer by this factor.
constexpr double WorthIt = 1.5;
// Nearer than this part of the farthest distance, nothing is expected.
constexpr double NearestPart = 2e-3;
// The next cascade takes over along the last tenth, as shadow_maps/mask.frag does it.
constexpr double OverlapStart = 0.9;

// What of the camera matters, without the anti-aliasing's jitter and roundings of a turn.
struct Sight
{
  glm::dvec3 Eye{ 0.0 };
  glm::dvec3 Axis{ 0.0 };
  double Cosine = 1.0; ///< of the angle between axis and corners
  double Pixel = 0.0;  ///< width at distance one
  double Nearest = 0.0;
  double Farthest = 0.0;

  explicit Sight(const View& view)
  {
    const glm::dvec2 size(view.Viewport.z, view.Viewport.w);
    const glm::dvec3 jitter(-2.0 * view.Jitter / size, 0.0);
    const glm::dmat4 clipToView =
      glm::inverse(glm::translate(glm::dmat4(1.0), jitter) * view.ViewToClip);
    std::array<glm::dvec3, 4> corners;
    glm::dvec3 sum(0.0);
    for (int i = 0; i < 4; ++i)
    {
      const glm::dvec4 p =
        clipToView * glm::dvec4(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, 0.0, 1.0);
      corners[i] = glm::normalize(glm::dvec3(p) / p.w);
      sum += corners[i];
    }
    const glm::dvec3 axis = glm::normalize(sum);
    for (const auto& corner : corners)
    {
      this->Cosine = std::min(this->Cosine, glm::dot(corner, axis));
    }
    this->Cosine = std::floor(this->Cosine * 512.0) / 512.0;
    this->Pixel =
      2.0 * std::abs(corners[2].y / corners[2].z - corners[0].y / corners[0].z) / 2.0 / size.y;
    this->Eye = glm::dvec3(view.ViewToWorld[3]);
    this->Axis = glm::normalize(glm::dmat3(view.ViewToWorld) * axis);
    // A quarter of an octave.
    const glm::dvec2 range = DistanceRange(this->Eye, view.Bounds);
    this->Farthest = std::exp2(std::ceil(4.0 * std::log2(range.y)) / 4.0);
    this->Nearest = range.x > 0.0 ? std::exp2(std::floor(4.0 * std::log2(range.x)) / 4.0) : 0.0;
  }

  // Around what is seen between two distances: the middle lies on the axis, as far from the corners of
  // the near end as from those of the far end, or amid the latter.
  ShadowSphere Around(double from, double to) const
  {
    const double middle = std::min((from + to) / (2.0 * this->Cosine), to * this->Cosine);
    const double radius = std::sqrt(to * to + middle * middle - 2.0 * to * middle * this->Cosine);
    return { this->Eye + middle * this->Axis, radius };
  }
};

ShadowCascades Split(const Sight& sight, int count, double logarithmic)
{
  const double near = std::max(sight.Nearest, sight.Farthest * NearestPart);
  ShadowCascades cascades;
  double from = sight.Nearest;
  for (int i = 1; i <= count; ++i)
  {
    const double t = static_cast<double>(i) / count;
    const double end = logarithmic * near * std::pow(sight.Farthest / near, t) +
      (1.0 - logarithmic) * (near + (sight.Farthest - near) * t);
    cascades.Ends.push_back(end);
    cascades.Spheres.push_back(sight.Around(from, end));
    from = OverlapStart * end;
  }
  return cascades;
}
}

ShadowCascades ChooseCascades(const Light& light, const View& view, const CascadeOptions& options)
{
  if (view.Parallel || light.Positional || options.Most < 2)
  {
    return {};
  }
  const Sight sight(view);
  const double near = std::max(sight.Nearest, sight.Farthest * NearestPart);
  std::vector<ShadowCascades> choices(options.Most);
  std::vector<double> pixels; // of the coarsest texel
  pixels.push_back(FitShadowViews(light, view.Bounds, options.Resolution, options.Margin)[0].Texel /
    (sight.Pixel * near));
  for (int count = 2; count <= options.Most; ++count)
  {
    ShadowCascades& cascades = choices[count - 1];
    cascades = Split(sight, count, options.Logarithmic);
    double coarsest = 0.0;
    double from = near;
    for (int i = 0; i < count; ++i)
    {
      const ShadowView map = FitShadowSphere(
        light, view.Bounds, cascades.Spheres[i], options.Resolution / 2, options.Margin);
      coarsest = std::max(coarsest, map.Texel / (sight.Pixel * from));
      from = cascades.Ends[i];
    }
    pixels.push_back(coarsest);
  }
  const double enough =
    std::max(FinePixels, WorthIt * *std::min_element(pixels.begin(), pixels.end()));
  std::size_t chosen = 0;
  while (pixels[chosen] > enough)
  {
    ++chosen;
  }
  return choices[chosen];
}
}
