// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Shadow casters: their changes, their bounds, and how they are drawn into a shadow map.
 */
#pragma once

#include "shadows/ShadowAtlas.h"
#include "shadows/ShadowViews.h"

#include <glm/glm.hpp>

#include <vector>

namespace penumbra
{
class FrameContext;
class SceneCapture;
class Texture;

/// Numbers that change with the set of casters and with each caster. Drawing updates pipelines, and thus the numbers.
std::vector<double> CasterSignature(const SceneCapture& scene);

/// Number of cells that drawing all casters once draws, as far as their mappers tell.
double CellsOfCasters(const SceneCapture& scene);

struct CasterBounds
{
  bool Empty = true;
  Bounds All{};
  /// Bounds of those that cast shadows onto something: without a flat caster that has all others on one side, such as a
  /// wide floor. What lies outside is in shadow of nothing but that.
  Bounds Effective{};
};
CasterBounds BoundsOfCasters(const SceneCapture& scene);

/// Draw the depth of all casters into a tile of an atlas. anchor: see SceneCapture::DrawCasters().
void DrawShadowMap(FrameContext& context, SceneCapture& scene, const Texture& atlas,
  const ShadowView& view, const AtlasTile& tile, const glm::ivec2& anchor);
}
