// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Several maps for one directional light, each for what the camera sees from one distance to another,
 * so that shadow texels are fine where the camera is near (Engel 2006, Cascaded Shadow Maps, ShaderX5;
 * Zhang et al. 2006, Parallel-Split Shadow Maps for Large-Scale Virtual Environments).
 */
#pragma once

#include "techniques/shadow_maps/ShadowViews.h"

namespace penumbra
{
struct View;

struct ShadowCascades
{
  std::vector<double> Ends;          ///< distances from the eye
  std::vector<ShadowSphere> Spheres; ///< around what is seen up to there; none: one map for all
};

struct CascadeOptions
{
  int Most = 4;           ///< cascades
  int Resolution = 2048;  ///< texels across one map for all; a cascade has half as many
  double Margin = 0.0;    ///< texels that a filter reads beyond a map's edge
  double Logarithmic = 0; ///< share of logarithmic in the places of the splits; the rest is even
};

/// The fewest cascades whose coarsest texel, in pixels of the picture, comes close to the finest
/// that can be had, or is small. None in parallel projection, which sees all from the same distance.
/// Distances are counted from the eye, and rounded: what the maps show does not change while the
/// camera turns, or moves a little.
ShadowCascades ChooseCascades(const Light& light, const View& view, const CascadeOptions& options);
}
