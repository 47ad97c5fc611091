// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The lights of a frame: the renderer's lights that are switched on, in its order, with what shadowing techniques
 * need.
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
  glm::dvec3 Direction{ 0.0 }; ///< direction of travel, view coordinates, unit length
  glm::dvec3 Position{ 0.0 };  ///< view coordinates
  glm::dvec3 WorldDirection{ 0.0 };
  glm::dvec3 WorldPosition{ 0.0 };
  glm::dvec3 Attenuation{ 1.0, 0.0, 0.0 };
  double ConeAngle = 90.0; ///< half aperture in degrees; 90 and more means omnidirectional
  double Exponent = 1.0;
  int Shape = GI_SHAPE_NONE; ///< as in light.h
  double Size =
    0.0; ///< radius of a sphere; half the angular diameter of a directional light, in radians
  glm::dvec3 Side{ 0.0 }; ///< from the centre of a flat light to its side, view coordinates
  glm::dvec3 Up{ 0.0 };
  glm::dvec3 WorldSide{ 0.0 };
  glm::dvec3 WorldUp{ 0.0 };
  bool Positional = false;
  bool Headlight = false;     ///< at the camera, so that its shadows are hidden
  bool FollowsCamera = false; ///< a headlight, or a light fixed in camera coordinates
  int MaskChannel = -1;       ///< channel of the direct visibility mask, -1 for none

  bool IsCone() const { return this->Positional && this->ConeAngle < 90.0; }
  bool IsFlat() const { return this->Shape >= GI_SHAPE_DISC; }
  /// Area of a flat light.
  double Area() const;
};

class LightTable
{
public:
  /// Read the renderer's lights. Call after the renderer updated their geometry.
  void Collect(vtkOpenGLRenderer* renderer);

  std::vector<Light>& Lights() { return this->Entries; }
  const std::vector<Light>& Lights() const { return this->Entries; }

  /// Whether the only light is a headlight, for which VTK has a special formula.
  bool IsSingleHeadlight() const { return this->SingleHeadlight; }
  bool HasPositional() const { return this->Positional; }
  /// Whether some light's unshadowed light differs from that of a point.
  bool HasAreas() const { return this->Areas; }
  /// Whether some light has a size of its own.
  bool HasShapes() const { return this->Shapes; }
  /// Number of lights whose shape is for the other kind of light, and has no effect.
  int MisshapenLights() const { return this->Misshapen; }

  /// Lights that cast shadows.
  struct Shadowed
  {
    std::vector<std::size_t> With; ///< indices, in the order of their mask channels
    int Without = 0;               ///< number of lights beyond the maximum, which cast none
  };
  /// Give every light that casts shadows a channel of the direct visibility mask, strongest first. Returns none if
  /// another technique already did. Headlights get no channel, because their shadows are hidden.
  Shadowed AssignMask(int maximum);

  /// The sum of all lights' colours.
  glm::dvec3 TotalColor() const;

  /// The lights for shaders that include shared/light.h, and lightCount. In view coordinates, with their strength
  /// scaled:
  Arguments InView(double scale);
  /// In world coordinates relative to an origin, which must be the same in all calls of a frame:
  Arguments InWorld(const glm::dvec3& origin);
  /// Upload the lights after all calls of InView(), InWorld() and AssignMask(), before shaders run.
  void Upload();

  void ReleaseGraphicsResources()
  {
    this->ViewBlock = Buffer();
    this->WorldBlock = Buffer();
  }

private:
  shared::LightData MakeData(const Light& light, double scale) const;
  Arguments Describe(const Buffer& block) const;

  std::vector<Light> Entries;
  bool SingleHeadlight = false;
  bool Positional = false;
  bool Areas = false;
  bool Shapes = false;
  int Misshapen = 0;
  double ViewScale = 1.0;
  glm::dvec3 WorldOrigin{ 0.0 };
  Buffer ViewBlock;
  Buffer WorldBlock;
};
}
