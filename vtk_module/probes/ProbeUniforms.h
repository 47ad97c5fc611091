// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Uniforms of shaders that look up the light of probes, see glsl/probes/field.glsl.
 */
#pragma once

#include "gpu/ShaderLibrary.h"
#include "probes/ProbeGrids.h"

namespace penumbra
{
struct ProbeUniforms
{
  ProbeGrids Grids;
  glm::dvec3 Origin{ 0.0 }; ///< origin of the shaders' coordinates, in the world
  double Bias = 0.0;        ///< in cells

  Arguments ShaderArguments() const;

  /// Shader variant for the number of grids.
  Defines Variant() const;

  /// Number of maps per row of a texture with one map per probe. The texture is nearly square, because its width and
  /// height are limited.
  static int Columns(int probes);
  /// Number of rows of a texture for a number of maps.
  static int Rows(int maps, int columns);
};
}
