// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What every shader that asks probes needs to know of their grids, see glsl/probes/field.glsl.
 */
#pragma once

#include "gpu/ShaderLibrary.h"
#include "probes/ProbeGrids.h"

namespace penumbra
{
struct ProbeUniforms
{
  ProbeGrids Grids;
  glm::dvec3 Origin{ 0.0 }; ///< of the shaders' coordinates, world
  double Bias = 0.0;        ///< in cells

  /// For shaders that ask probes.
  Arguments ShaderArguments() const;

  /// Of shaders that ask probes.
  Defines Variant() const;

  /// Maps in a row of the textures that hold so many: in a square, as textures are limited by their sides.
  static int Columns(int probes);
  /// Rows that so many maps take.
  static int Rows(int maps, int columns);
};
}
