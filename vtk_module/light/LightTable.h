// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The lights of a frame as VTK means them: switched-on lights of a renderer in its order, in view
 * coordinates, with what a shadowing technique needs to know of each.
 */
#pragma once

#include "gpu/Arguments.h"

#include "light.h"

#include <glm/glm.hpp>

#include <vector>

class vtkOpenGLRenderer;

namespace penumbra
{
struct Light
{
  glm::dvec3 Color{ 0.0 };     ///< intensity times diffuse colour
  glm::dvec3 Direction{ 0.0 }; ///< view coordinates, the way the light travels, unit length
  glm::dvec3 Position{ 0.0 };  ///< view coordinates
  glm::dvec3 WorldDirection{ 0.0 };
  glm::dvec3 WorldPosition{ 0.0 };
  glm::dvec3 Attenuation{ 1.0, 0.0, 0.0 };
  double ConeAngle = 90.0; ///< degrees, half aperture; 90 and more shine all round
  double Exponent = 1.0;
  bool Positional = false;
  bool Headlight = false;     ///< shines from the camera: what it does not reach is not seen
  bool FollowsCamera = false; ///< a headlight, or one fixed in the camera's coordinates
  int MaskChannel = -1;       ///< channel of the direct visibility mask, -1 for none

  bool IsCone() const { return this->Positional && this->ConeAngle < 90.0; }
};

class LightTable
{
public:
  /// Read the renderer's lights, after it updated their geometry.
  void Collect(vtkOpenGLRenderer* renderer);

  std::vector<Light>& Lights() { return this->All; }
  const std::vector<Light>& Lights() const { return this->All; }

  /// A single headlight and nothing else, which VTK lights by a formula of its own.
  bool IsSingleHeadlight() const { return this->SingleHeadlight; }
  bool HasPositional() const { return this->Positional; }

  /// Lights that cast shadows, in the order of their channels of the direct visibility mask.
  struct Shadowed
  {
    std::vector<std::size_t> With;
    int Without = 0; ///< how many would but exceed the maximum
  };
  /// Give every light that casts shadows a channel of the mask, the strongest first, unless another
  /// technique did so before: then there are none. Headlights cast no shadow that their eye sees.
  Shadowed AssignMask(int maximum);

  /// The colours of all lights added up.
  glm::dvec3 TotalColor() const;

  /// For shaders that include shared/light.h, with lightCount: in view coordinates, with every light's strength
  /// scaled,
  Arguments InView(double scale);
  /// or in the world's, relative to an origin, one for all who ask.
  Arguments InWorld(const glm::dvec3& origin);
  /// Once all have asked and channels of masks are assigned, before shaders run.
  void Upload();

  void ReleaseGraphicsResources()
  {
    this->ViewBlock = Buffer();
    this->WorldBlock = Buffer();
  }

private:
  shared::LightData Entry(const Light& light, double scale) const;
  Arguments Describe(const Buffer& block) const;

  std::vector<Light> All;
  bool SingleHeadlight = false;
  bool Positional = false;
  double ViewScale = 1.0;
  glm::dvec3 WorldOrigin{ 0.0 };
  Buffer ViewBlock;
  Buffer WorldBlock;
};
}
