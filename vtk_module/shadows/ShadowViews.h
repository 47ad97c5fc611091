// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The views from which a light's shadow maps are drawn: one for a directional light or a narrow cone, six
 * for a wider light. Each is fitted to the bounds of the shadow casters.
 */
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace penumbra
{
struct Light;

using Bounds = std::array<double, 6>; ///< x0, x1, y0, y1, z0, z1 in world coordinates, not empty

struct ShadowView
{
  glm::dmat4 WorldToView{ 1.0 };
  glm::dmat4 ViewToClip{ 1.0 };
  bool Parallel = true;
  /// Width of a map texel in world units, at distance 1 if the light is positional.
  double Texel = 0.0;
  /// Depth range of the map: distances from the light, or from the view's origin if directional.
  double Near = 0.0;
  double Far = 1.0;
};

/// Bounding sphere of what a map has to cover.
struct ShadowSphere
{
  glm::dvec3 Center{ 0.0 };
  double Radius = 0.0;
};

/// Number of views that a light needs: one if its cone or the whole scene lies within 60 degrees of one
/// direction from the light, else six.
int CountShadowViews(const Light& light, const Bounds& bounds);

/// Fit a light's views to the bounds. resolution: width of one map in texels. margin: texels that a filter
/// reads beyond a map's edge.
std::vector<ShadowView> FitShadowViews(
  const Light& light, const Bounds& bounds, int resolution, double margin);

/// Fit the view along a direction in which light travels: the map covers `across`, whose centre is in its middle, and its
/// depth range all casters.
ShadowView FitDirection(const glm::dvec3& direction, const Bounds& across, const Bounds& casters,
  int resolution, double margin);

/// Fit the view of a directional light to a part of the scene, or to the whole scene if that is smaller.
/// Texels keep their positions in the world while the sphere moves with a constant radius.
ShadowView FitShadowSphere(const Light& light, const Bounds& bounds, const ShadowSphere& sphere,
  int resolution, double margin);

/// Distances from a point to the nearest and farthest point of the bounds.
glm::dvec2 DistanceRange(const glm::dvec3& from, const Bounds& bounds);
}
