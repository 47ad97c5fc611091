// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Camera and window of a frame, and the changes since the previous frame.
 */
#pragma once

#include "gpu/Arguments.h"

#include <glm/glm.hpp>

#include <array>

namespace penumbra
{
/// Changes since the previous frame.
struct SceneChanges
{
  bool Any = true;
  bool Lights = true; ///< a light or the environment changed, other than by following the camera
  bool CarriedLights = true; ///< the camera moved, and with it lights that follow it
  bool Props = true;      ///< a prop moved, appeared, disappeared or changed its appearance
  bool Presence = true;   ///< a prop appeared or disappeared
  bool Appearance = true; ///< a shape or colour changed
  bool Techniques = true; ///< a technique was switched, or a parameter set
};

/// Camera and window of a frame, in double precision where it matters.
struct View
{
  glm::ivec2 WindowSize{ 0 };
  glm::ivec4 Viewport{ 0 }; ///< x, y, width, height
  glm::dmat4 WorldToView{ 1.0 };
  glm::dmat4 ViewToWorld{ 1.0 };
  glm::dmat4 ViewToClip{ 1.0 }; ///< with jitter
  bool Parallel = false;
  glm::dvec2 Jitter{ 0.0 }; ///< in pixels
  std::array<double, 6> Bounds{ { 1, -1, 1, -1, 1,
    -1 } };              ///< of all visible props, in world coordinates
  double Diagonal = 0.0; ///< of Bounds
  std::array<double, 6> SurfaceBounds{ { 1, -1, 1, -1, 1, -1 } }; ///< of surfaces that are no props
  /// Window depths of the camera's clipping planes. Others than 0 and 1 where a technique looks beyond them.
  glm::dvec2 DepthWindow{ 0.0, 1.0 };
  int StillFrames = 0; ///< number of frames since the scene last changed, without this one
  int FrameNumber = 0;
  int FirstFrame = 0;       ///< number of the frame with which averages over frames began
  bool StandsAlone = false; ///< whether the picture must not use results of earlier frames
  int Sequence = 0;         ///< index in the noise sequences
  SceneChanges Changes;
  GLenum DepthFormat = 0; ///< depth format of the window, for copies; 0 if depth cannot be copied
  bool KeepsRadiance = false;     ///< whether values above 1 matter
  bool WantsAntiAliasing = false; ///< whether the window is multisampled or FXAA is requested

  /// Arguments viewToScene and eye, for shaders that transform view coordinates to world coordinates relative to an
  /// origin.
  Arguments ToScene(const glm::dvec3& origin) const
  {
    return Arguments()
      .Set("viewToScene", glm::mat3(glm::dmat3(this->ViewToWorld)))
      .Set("eye", glm::vec3(glm::dvec3(this->ViewToWorld[3]) - origin));
  }
};
}
