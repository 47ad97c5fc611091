// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * From where a light looks at the scene: one view for a directional light or a narrow cone, six
 * for a light that shines wider. Each is fitted to the bounds of what may cast shadows.
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
  double Texel = 0.0; ///< width of a map texel in world units, at unit distance if positional
  double Near = 0.0;  ///< distances from the light, or from anywhere across it, of the map's depths
  double Far = 1.0;
};

/// A sphere around what one map has to show.
struct ShadowSphere
{
  glm::dvec3 Center{ 0.0 };
  double Radius = 0.0;
};

/// How many views a light takes: one where its cone, or all of the scene, lies within 60 degrees of a
/// direction from it, else six.
int CountShadowViews(const Light& light, const Bounds& bounds);

/// resolution: of one map, in texels. margin: texels that a filter reads beyond a map's edge.
std::vector<ShadowView> FitShadowViews(
  const Light& light, const Bounds& bounds, int resolution, double margin);

/// The view of a directional light onto a part of the scene: its texels keep their places in the world
/// while the sphere moves and its radius stays. As wide as the scene where that is smaller.
ShadowView FitShadowSphere(const Light& light, const Bounds& bounds, const ShadowSphere& sphere,
  int resolution, double margin);

/// Distances from a point to the nearest and farthest point of the bounds.
glm::dvec2 DistanceRange(const glm::dvec3& from, const Bounds& bounds);
}
