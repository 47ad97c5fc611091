// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The shadow maps of a frame: the maps of each light, their tiles in the atlas, and their views.
 */
#pragma once

#include "shadows/ShadowAtlas.h"
#include "shadows/ShadowViews.h"

#include "shadow.h"

#include <vector>

namespace penumbra
{
class LightTable;
struct View;

struct ShadowOptions
{
  int Resolution = 2048;   ///< width of the largest maps in texels
  double Margin = 0.0;     ///< texels that a filter reads beyond a map's edge
  double Squares = 1.0;    ///< number of maps of the largest size that fit into the atlas
  int Cascades = 1;        ///< maximum number for a directional light
  double Logarithmic = 0;  ///< see CascadeOptions
  double LightTangent = 0; ///< tangent of half the angular diameter of directional lights
  double LightRadius = 0;  ///< radius of positional lights in world units
};

struct ShadowMap
{
  ShadowView View;
  AtlasTile Tile;

  /// Numbers that stay the same as long as the map of unchanged casters does.
  std::vector<double> Signature() const;
};

struct ShadowPlan
{
  int Width = 0; ///< width of the atlas
  int Height = 0;
  std::vector<ShadowMap> Maps;
  std::vector<shared::ShadowMapData> MapData;
  std::vector<shared::ShadowLightData> LightData;
};

/// Plan the maps of lights. lights: indices in the table, most important first. Lights at the end that do not fit
/// into the atlas are left out.
ShadowPlan PlanShadows(const LightTable& table, const std::vector<std::size_t>& lights,
  const View& view, const ShadowOptions& options);
}
