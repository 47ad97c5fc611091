// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The shadow maps of a frame: which light has which, where they lie in the atlas, and what each shows.
 */
#pragma once

#include "techniques/shadow_maps/ShadowAtlas.h"
#include "techniques/shadow_maps/ShadowViews.h"

#include "shadow.h"

#include <vector>

namespace penumbra
{
class LightTable;
struct View;

struct ShadowOptions
{
  int Resolution = 2048;   ///< of the largest maps, in texels
  double Margin = 0.0;     ///< texels that a filter reads beyond a map's edge
  double Squares = 1.0;    ///< maps of the largest size that the atlas has room for
  int Cascades = 1;        ///< at most, of a directional light
  double Logarithmic = 0;  ///< see CascadeOptions
  double LightTangent = 0; ///< of half the angle across which directional lights are seen
  double LightRadius = 0;  ///< of positional lights, in world units
};

struct ShadowMap
{
  ShadowView Shown;
  AtlasTile Tile;

  /// What the map would show of unchanging casters, as numbers.
  std::vector<double> Signature() const;
};

struct ShadowPlan
{
  int Width = 0; ///< of the atlas
  int Height = 0;
  std::vector<ShadowMap> Maps;
  std::vector<shared::ShadowMapData> MapData;
  std::vector<shared::ShadowLightData> LightData;
};

/// lights: indices in the table, the most important first. The plan holds the first of them that fit.
ShadowPlan PlanShadows(const LightTable& table, const std::vector<std::size_t>& lights,
  const View& view, const ShadowOptions& options);
}
