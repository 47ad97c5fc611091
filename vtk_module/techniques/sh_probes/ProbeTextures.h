// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Textures of a baked field of probes, as glsl/sh_probes/light.glsl reads them.
 */
#pragma once

#include "gpu/GLObjects.h"
#include "probes/ProbeUniforms.h"
#include "techniques/sh_probes/ProbeField.h"

#include <memory>

namespace penumbra
{
class Program;

class ProbeTextures
{
public:
  /// The context must be current. window: smooth harmonics that are negative in some direction.
  ProbeTextures(const ProbeField& field, bool window);

  const Texture* Light() const { return &this->LightTexture; }
  const Texture* Distance() const { return &this->DistanceTexture; }
  const Texture* Probes() const { return &this->ProbeTexture; }

  /// Arguments of shaders that look up these probes. origin: of the shaders' coordinates, in the world.
  Arguments ShaderArguments(double bias, const glm::dvec3& origin) const;
  const glm::dvec3& Origin() const { return this->Grids.Get(0).First; }
  /// Variant of such shaders.
  Defines Variant() const { return this->Uniforms(0.0).Variant(); }

private:
  void FillLight(const ProbeField& field, bool window);
  void FillDistance(const ProbeField& field);
  void FillProbes(const ProbeField& field);

  ProbeUniforms Uniforms(double bias) const { return { this->Grids, this->Origin(), bias }; }

  ProbeGrids Grids;
  int Columns;
  int Rows;
  double Scale = 1.0;
  Texture LightTexture;
  Texture DistanceTexture;
  Texture ProbeTexture;
};
}
