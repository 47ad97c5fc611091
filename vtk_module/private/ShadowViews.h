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

struct ShadowView
{
  glm::dmat4 WorldToView{ 1.0 };
  glm::dmat4 ViewToClip{ 1.0 };
  bool Parallel = true;
};

struct ShadowViews
{
  std::vector<ShadowView> Views;
  double Texel = 0.0; ///< width of a map texel in world units, at unit distance if positional
};

/// bounds: x0, x1, y0, y1, z0, z1 in world coordinates, not empty. resolution: of one map, in
/// texels. margin: texels that a filter reads beyond a map's edge.
ShadowViews FitShadowViews(
  const Light& light, const std::array<double, 6>& bounds, int resolution, double margin);
}
