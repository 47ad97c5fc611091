// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A frame's camera and window, and what changed since the frame before.
 */
#pragma once

#include "gpu/Arguments.h"

#include <glm/glm.hpp>

#include <array>

namespace penumbra
{
/// What differs from the frame before.
struct SceneChanges
{
  bool Any = true;
  bool Lights = true;
  bool Props = true; ///< one moved, came or went, or looks different
  bool Looks = true; ///< shapes, colours
};

/// The camera and the window of a frame, in double precision where it matters.
struct View
{
  glm::ivec2 WindowSize{ 0 };
  glm::ivec4 Viewport{ 0 }; ///< x, y, width, height
  glm::dmat4 WorldToView{ 1.0 };
  glm::dmat4 ViewToWorld{ 1.0 };
  glm::dmat4 ViewToClip{ 1.0 }; ///< with jitter
  bool Parallel = false;
  glm::dvec2 Jitter{ 0.0 };                                ///< in pixels
  std::array<double, 6> Bounds{ { 1, -1, 1, -1, 1, -1 } }; ///< of all visible props, world
  double Diagonal = 0.0;                                   ///< of Bounds
  int StillFrames = 0; ///< frames drawn since the scene last changed, this one not counted
  int FrameNumber = 0;
  int FirstFrame = 0;       ///< number of the one that averages over frames began with
  bool StandsAlone = false; ///< the picture shows nothing that was found in frames before
  int Sequence = 0;         ///< place in the sequences of noise
  SceneChanges Changes;
  GLenum DepthFormat = 0;         ///< of the window, so that depth can be copied; 0 if it cannot
  bool KeepsRadiance = false;     ///< values above 1 matter
  bool WantsAntiAliasing = false; ///< the window is multisampled, or the renderer asks for FXAA

  /// For shaders that go from view coordinates to the world's, relative to an origin: viewToScene, eye.
  Arguments ToScene(const glm::dvec3& origin) const
  {
    return Arguments()
      .Set("viewToScene", glm::mat3(glm::dmat3(this->ViewToWorld)))
      .Set("eye", glm::vec3(glm::dvec3(this->ViewToWorld[3]) - origin));
  }
};
}
