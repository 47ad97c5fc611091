// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/ShadowViews.h"

#include "private/LightTable.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// Wider cones lose texels to perspective: they take six views like an omnidirectional light.
constexpr double WidestCone = 60.0;

// A perspective depth range of 1:1000 leaves a 32-bit map millimetres in a kilometre.
constexpr double NearestFraction = 1e-3;

std::array<glm::dvec3, 8> Corners(const std::array<double, 6>& b)
{
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners[i] = { b[i & 1], b[2 + ((i >> 1) & 1)], b[4 + ((i >> 2) & 1)] };
  }
  return corners;
}

glm::dvec3 AnyUp(const glm::dvec3& direction)
{
  return std::abs(direction.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
}

ShadowViews FitDirectional(
  const Light& light, const std::array<double, 6>& bounds, int resolution, double margin)
{
  ShadowViews result;
  ShadowView view;
  const glm::dvec3 center((bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2,
    (bounds[4] + bounds[5]) / 2);
  view.WorldToView =
    glm::lookAt(center, center + light.WorldDirection, AnyUp(light.WorldDirection));
  glm::dvec3 low(1e300);
  glm::dvec3 high(-1e300);
  for (const auto& corner : Corners(bounds))
  {
    const glm::dvec3 p(view.WorldToView * glm::dvec4(corner, 1.0));
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  // Square texels, and a border for the filter; a flat scene still gets a volume.
  const double diagonal = glm::length(high - low);
  double half = std::max({ high.x - low.x, high.y - low.y, diagonal * 1e-3 }) / 2;
  half *= resolution / std::max(1.0, resolution - 2.0 * margin);
  const double depth = diagonal * 1e-2;
  view.ViewToClip = glm::ortho(-half, half, -half, half, -high.z - depth, -low.z + depth);
  result.Texel = 2.0 * half / resolution;
  result.Views.push_back(view);
  return result;
}

// Distances from a point to the nearest and farthest point of the bounds.
void DistanceRange(
  const glm::dvec3& from, const std::array<double, 6>& bounds, double& nearest, double& farthest)
{
  const glm::dvec3 low(bounds[0], bounds[2], bounds[4]);
  const glm::dvec3 high(bounds[1], bounds[3], bounds[5]);
  nearest = glm::length(glm::clamp(from, low, high) - from);
  farthest = 0.0;
  for (const auto& corner : Corners(bounds))
  {
    farthest = std::max(farthest, glm::length(corner - from));
  }
}
}

ShadowViews FitShadowViews(
  const Light& light, const std::array<double, 6>& bounds, int resolution, double margin)
{
  if (!light.Positional)
  {
    return FitDirectional(light, bounds, resolution, margin);
  }
  ShadowViews result;
  double nearest = 0.0;
  double farthest = 0.0;
  DistanceRange(light.WorldPosition, bounds, nearest, farthest);
  // Along a view's axis things may be nearer than their distance, down to a face's corner.
  const double far = farthest * 1.01;
  const double near = std::max(nearest / std::sqrt(3.0) * 0.99, far * NearestFraction);
  const bool cone = light.ConeAngle < WidestCone;
  const double border = resolution / std::max(1.0, resolution - 2.0 * margin);
  const double tangent = (cone ? std::tan(glm::radians(light.ConeAngle)) : 1.0) * border;
  const glm::dmat4 projection =
    glm::frustum(-near * tangent, near * tangent, -near * tangent, near * tangent, near, far);
  result.Texel = 2.0 * tangent / resolution;
  const glm::dvec3 eye = light.WorldPosition;
  if (cone)
  {
    const glm::dmat4 toView =
      glm::lookAt(eye, eye + light.WorldDirection, AnyUp(light.WorldDirection));
    result.Views.push_back({ toView, projection, false });
    return result;
  }
  // In the order +x, -x, +y, -y, +z, -z, which the shader chooses by.
  for (int axis = 0; axis < 3; ++axis)
  {
    for (double sign : { 1.0, -1.0 })
    {
      glm::dvec3 direction(0.0);
      direction[axis] = sign;
      result.Views.push_back(
        { glm::lookAt(eye, eye + direction, AnyUp(direction)), projection, false });
    }
  }
  return result;
}
}
