// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "shadows/ShadowViews.h"

#include "light/LightTable.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// Wider cones would waste texels on perspective. They get six views like an omnidirectional light.
constexpr double WidestCone = 60.0;

// With a perspective depth range of 1:1000, a 32-bit map resolves millimetres in a kilometre.
constexpr double NearestFraction = 1e-3;

std::array<glm::dvec3, 8> Corners(const Bounds& b)
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

// Extent of the bounds in the coordinates of a directional light's view.
struct Extent
{
  glm::dvec3 Low{ 1e300 };
  glm::dvec3 High{ -1e300 };

  Extent(const glm::dmat4& worldToView, const Bounds& bounds)
  {
    for (const auto& corner : Corners(bounds))
    {
      const glm::dvec3 p(worldToView * glm::dvec4(corner, 1.0));
      this->Low = glm::min(this->Low, p);
      this->High = glm::max(this->High, p);
    }
  }
  // A flat scene still gets a volume.
  double Half() const
  {
    return std::max(
             { this->High.x - this->Low.x, this->High.y - this->Low.y, this->Diagonal() * 1e-3 }) /
      2;
  }
  double Diagonal() const { return glm::length(this->High - this->Low); }
};

// Half width of a view, enlarged by a margin in texels.
double WithMargin(double half, int resolution, double margin)
{
  return half * resolution / std::max(1.0, resolution - 2.0 * margin);
}

// The depth range covers all casters, even those outside the part of the scene that receives shadows.
ShadowView Parallel(
  const glm::dmat4& worldToView, const Bounds& bounds, double half, int resolution)
{
  ShadowView view;
  view.WorldToView = worldToView;
  const Extent extent(worldToView, bounds);
  const double depth = extent.Diagonal() * 1e-2;
  view.Near = -extent.High.z - depth;
  view.Far = -extent.Low.z + depth;
  view.ViewToClip = glm::ortho(-half, half, -half, half, view.Near, view.Far);
  view.Texel = 2.0 * half / resolution;
  return view;
}

glm::dmat4 LookAlong(const glm::dvec3& direction, const glm::dvec3& from)
{
  return glm::lookAt(from, from + direction, AnyUp(direction));
}

glm::dvec3 Center(const Bounds& bounds)
{
  return { (bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2 };
}

ShadowView FitDirectional(const Light& light, const Bounds& bounds, int resolution, double margin)
{
  return FitDirection(light.WorldDirection, bounds, bounds, resolution, margin);
}

// A square window at distance 1 in front of a positional light.
struct Window
{
  glm::dmat4 WorldToView{ 1.0 };
  glm::dvec2 Center{ 0.0 };
  double Half = 1.0;
  bool Narrow = false; ///< one view suffices; the other members are valid
};

// The window through which the light sees all of the bounds.
Window WindowOntoBounds(const Light& light, const Bounds& bounds)
{
  Window window;
  const glm::dvec3 eye = light.WorldPosition;
  const glm::dvec3 center = Center(bounds);
  const glm::dvec3 direction = center - eye;
  if (glm::length(direction) <= 0.0)
  {
    return window;
  }
  window.WorldToView = glm::lookAt(eye, center, AnyUp(glm::normalize(direction)));
  glm::dvec2 low(1e300);
  glm::dvec2 high(-1e300);
  for (const auto& corner : Corners(bounds))
  {
    const glm::dvec3 p(window.WorldToView * glm::dvec4(corner, 1.0));
    if (-p.z <= 0.5 * glm::length(p)) // beyond 60 degrees
    {
      return window;
    }
    const glm::dvec2 tangents = glm::dvec2(p) / -p.z;
    low = glm::min(low, tangents);
    high = glm::max(high, tangents);
  }
  window.Center = 0.5 * (low + high);
  window.Half = std::max({ high.x - low.x, high.y - low.y, 1e-6 }) / 2.0;
  window.Narrow = true;
  return window;
}

// The smaller of the windows onto the light's cone and onto the scene.
Window WindowOntoScene(const Light& light, const Bounds& bounds)
{
  Window window = WindowOntoBounds(light, bounds);
  const double cone = std::tan(glm::radians(light.ConeAngle));
  if (light.ConeAngle < WidestCone && (!window.Narrow || cone < window.Half))
  {
    window.WorldToView = LookAlong(light.WorldDirection, light.WorldPosition);
    window.Center = glm::dvec2(0.0);
    window.Half = cone;
    window.Narrow = true;
  }
  return window;
}
}

glm::dvec2 DistanceRange(const glm::dvec3& from, const Bounds& bounds)
{
  const glm::dvec3 low(bounds[0], bounds[2], bounds[4]);
  const glm::dvec3 high(bounds[1], bounds[3], bounds[5]);
  double farthest = 0.0;
  for (const auto& corner : Corners(bounds))
  {
    farthest = std::max(farthest, glm::length(corner - from));
  }
  return { glm::length(glm::clamp(from, low, high) - from), farthest };
}

ShadowView FitDirection(const glm::dvec3& direction, const Bounds& across, const Bounds& casters,
  int resolution, double margin)
{
  const glm::dmat4 worldToView = LookAlong(direction, Center(across));
  const double half = WithMargin(Extent(worldToView, across).Half(), resolution, margin);
  return Parallel(worldToView, casters, half, resolution);
}

ShadowView FitShadowSphere(const Light& light, const Bounds& bounds, const ShadowSphere& sphere,
  int resolution, double margin)
{
  // The view moves in steps of this many texels, so that a map is redrawn only now and then, and its texels
  // keep their positions (Valient 2007, Stable Rendering of Cascaded Shadow Maps, ShaderX6).
  constexpr double step = 8.0;
  const double half = WithMargin(sphere.Radius, resolution, margin + step);
  const ShadowView sceneView = FitDirectional(light, bounds, resolution, margin);
  if (half * 2.0 >= sceneView.Texel * resolution)
  {
    return sceneView;
  }
  const double grid = step * 2.0 * half / resolution;
  const glm::dmat3 toLight(LookAlong(light.WorldDirection, glm::dvec3(0.0)));
  glm::dvec3 center = toLight * sphere.Center;
  center.x = std::round(center.x / grid) * grid;
  center.y = std::round(center.y / grid) * grid;
  center.z = 0.0;
  glm::dmat4 worldToView(toLight);
  worldToView[3] = glm::dvec4(-center, 1.0);
  return Parallel(worldToView, bounds, half, resolution);
}

int CountShadowViews(const Light& light, const Bounds& bounds)
{
  return light.Positional && !WindowOntoScene(light, bounds).Narrow ? 6 : 1;
}

std::vector<ShadowView> FitShadowViews(
  const Light& light, const Bounds& bounds, int resolution, double margin)
{
  if (!light.Positional)
  {
    return { FitDirectional(light, bounds, resolution, margin) };
  }
  const glm::dvec2 range = DistanceRange(light.WorldPosition, bounds);
  const Window window = WindowOntoScene(light, bounds);
  ShadowView view;
  view.Parallel = false;
  // Depth along a view's axis is smaller than the distance, by up to sqrt(3) at the corner of a cube's face.
  view.Far = range.y * 1.01;
  view.Near = std::max(range.x / std::sqrt(3.0) * 0.99, view.Far * NearestFraction);
  const double half = WithMargin(window.Half, resolution, margin);
  const glm::dvec2 low = view.Near * (window.Center - half);
  const glm::dvec2 high = view.Near * (window.Center + half);
  view.ViewToClip = glm::frustum(low.x, high.x, low.y, high.y, view.Near, view.Far);
  view.Texel = 2.0 * half / resolution;
  if (window.Narrow)
  {
    view.WorldToView = window.WorldToView;
    return { view };
  }
  const glm::dvec3 eye = light.WorldPosition;
  // The shader relies on the order +x, -x, +y, -y, +z, -z.
  std::vector<ShadowView> views;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (double sign : { 1.0, -1.0 })
    {
      glm::dvec3 direction(0.0);
      direction[axis] = sign;
      view.WorldToView = glm::lookAt(eye, eye + direction, AnyUp(direction));
      views.push_back(view);
    }
  }
  return views;
}
}
