// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Several maps for one directional light, each for a range of distances from the camera, so that shadow
 * texels are fine near the camera (Engel 2006, Cascaded Shadow Maps, ShaderX5; Zhang et al. 2006,
 * Parallel-Split Shadow Maps for Large-Scale Virtual Environments).
 */
#pragma once

#include "shadows/ShadowViews.h"

namespace penumbra
{
struct View;

struct ShadowCascades
{
  std::vector<double> Ends;          ///< distances from the eye
  /// Bounds of what is visible up to there; empty: one map for everything.
  std::vector<ShadowSphere> Spheres;
};

struct CascadeOptions
{
  int MaximumCount = 4;   ///< maximum number of cascades
  int Resolution = 2048;  ///< width of a single map in texels; a cascade has half of it
  double Margin = 0.0;    ///< texels that a filter reads beyond a map's edge
  double Logarithmic = 0; ///< weight of logarithmic splits, 0 to 1; the rest is even splits
};

/// Choose the fewest cascades whose coarsest texel, measured in pixels, is small or close to the finest
/// that is possible. A parallel projection gets none, as distance does not change its scale. Distances
/// are measured from the eye and rounded, so that the maps stay the same while the camera turns or
/// moves a little.
ShadowCascades ChooseCascades(const Light& light, const View& view, const CascadeOptions& options);
}
