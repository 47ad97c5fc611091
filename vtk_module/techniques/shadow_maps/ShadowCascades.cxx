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
// Shadow texels are fine enough if they are at most this many pixels wide.
constexpr double FinePixels = 2.0;
// More cascades are used only if they make the coarsest texels finer by this factor.
constexpr double WorthwhileGain = 1.5;
// Nearest distance at which surfaces are expected, as a fraction of the farthest.
constexpr double NearestFraction = 2e-3;
// The next cascade blends in over the last tenth, see shadow_maps/mask.frag.
constexpr double OverlapStart = 0.9;

// A cone around the camera's frustum. It excludes the anti-aliasing's jitter, and is rounded so that turning the
// camera does not change its shape.
struct ViewCone
{
  glm::dvec3 Eye{ 0.0 };
  glm::dvec3 Axis{ 0.0 };
  double Cosine = 1.0; ///< cosine of the angle between the axis and the frustum's corners
  double Pixel = 0.0;  ///< width of a pixel at distance 1
  double Nearest = 0.0;
  double Farthest = 0.0;

  explicit ViewCone(const View& view)
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
    // Round distances to quarter octaves.
    glm::dvec2 range = DistanceRange(this->Eye, view.Bounds);
    if (view.SurfaceBounds[0] <= view.SurfaceBounds[1])
    {
      const glm::dvec2 others = DistanceRange(this->Eye, view.SurfaceBounds);
      range = { std::min(range.x, others.x), std::max(range.y, others.y) };
    }
    this->Farthest = std::exp2(std::ceil(4.0 * std::log2(range.y)) / 4.0);
    this->Nearest = range.x > 0.0 ? std::exp2(std::floor(4.0 * std::log2(range.x)) / 4.0) : 0.0;
  }

  // Bounding sphere of the part of the cone between two distances. Its centre lies on the axis, at equal distances from
  // the near and the far rim, or in the plane of the far rim if that is wider.
  ShadowSphere BoundingSphere(double from, double to) const
  {
    const double center = std::min((from + to) / (2.0 * this->Cosine), to * this->Cosine);
    const double radius = std::sqrt(to * to + center * center - 2.0 * to * center * this->Cosine);
    return { this->Eye + center * this->Axis, radius };
  }
};

ShadowCascades Split(const ViewCone& cone, int count, double logarithmic)
{
  const double near = std::max(cone.Nearest, cone.Farthest * NearestFraction);
  ShadowCascades cascades;
  double from = cone.Nearest;
  for (int i = 1; i <= count; ++i)
  {
    const double t = static_cast<double>(i) / count;
    const double end = logarithmic * near * std::pow(cone.Farthest / near, t) +
      (1.0 - logarithmic) * (near + (cone.Farthest - near) * t);
    cascades.Ends.push_back(end);
    cascades.Spheres.push_back(cone.BoundingSphere(from, end));
    from = OverlapStart * end;
  }
  return cascades;
}
}

ShadowCascades ChooseCascades(const Light& light, const View& view, const CascadeOptions& options)
{
  if (view.Parallel || light.Positional || options.MaximumCount < 2)
  {
    return {};
  }
  const ViewCone cone(view);
  const double near = std::max(cone.Nearest, cone.Farthest * NearestFraction);
  std::vector<ShadowCascades> candidates(options.MaximumCount);
  std::vector<double> pixels; // width of the coarsest texel, by number of cascades
  pixels.push_back(FitShadowViews(light, view.Bounds, options.Resolution, options.Margin)[0].Texel /
    (cone.Pixel * near));
  for (int count = 2; count <= options.MaximumCount; ++count)
  {
    ShadowCascades& cascades = candidates[count - 1];
    cascades = Split(cone, count, options.Logarithmic);
    double coarsest = 0.0;
    double from = near;
    for (int i = 0; i < count; ++i)
    {
      const ShadowView map = FitShadowSphere(
        light, view.Bounds, cascades.Spheres[i], options.Resolution / 2, options.Margin);
      coarsest = std::max(coarsest, map.Texel / (cone.Pixel * from));
      from = cascades.Ends[i];
    }
    pixels.push_back(coarsest);
  }
  const double enough =
    std::max(FinePixels, WorthwhileGain * *std::min_element(pixels.begin(), pixels.end()));
  std::size_t chosen = 0;
  while (pixels[chosen] > enough)
  {
    ++chosen;
  }
  return candidates[chosen];
}
}
