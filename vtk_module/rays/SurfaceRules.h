// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Rules of reflection that hold for all surfaces of a scene, in addition to their materials.
 */
#pragma once

#include "gpu/Arguments.h"

namespace penumbra
{
struct SurfaceRules
{
  double Reflectance = 1.0;     ///< diffuse reflectance or base colour of a surface whose colour is white
  bool Compensates = false;     ///< highlights keep the light that microfacets reflect several times
  bool DataKeepsHue = false;    ///< indirect light does not change the hue of surfaces coloured by data
  double DataFloor = 0.0;       ///< share of their colour that surfaces coloured by data show without light

  bool ChangesData() const { return this->DataKeepsHue || this->DataFloor > 0.0; }

  /// Arguments of shaders that include rays/surface.glsl, path_tracing/reflection.glsl or lib/data_colors.glsl.
  Arguments ShaderArguments() const
  {
    return Arguments()
      .Set("giReflectance", this->Reflectance)
      .Set("giCompensates", this->Compensates)
      .Set("giDataKeepsHue", this->DataKeepsHue)
      .Set("giDataFloor", this->DataFloor);
  }
  bool operator==(const SurfaceRules& other) const
  {
    return this->Reflectance == other.Reflectance && this->Compensates == other.Compensates &&
      this->DataKeepsHue == other.DataKeepsHue && this->DataFloor == other.DataFloor;
  }
};
}
