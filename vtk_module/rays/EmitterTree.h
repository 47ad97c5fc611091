// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A tree that chooses among triangles that emit light by their power and distance.
 */
#pragma once

#include "ray_surface.h"

#include <glm/glm.hpp>

#include <vector>

namespace penumbra
{
/// A triangle that emits light, in scene coordinates.
struct EmittingTriangle
{
  glm::dvec3 Corners[3];
  double Power;  ///< relative to others
  int Surface;   ///< its record
  int Primitive; ///< within the surface
};

/// A complete tree above triangles, as rays/emitters.glsl reads it (Conty Estevez and Kulla 2018, Importance Sampling of
/// Many Lights with Adaptive Tree Splitting; Morton 1966, A Computer Oriented Geodetic Data Base and a New Technique in
/// File Sequencing). A node has four children, which take fewer reads than two levels of two.
struct EmitterTree
{
  /// The triangles, ordered along a curve through space, then the children of each node. Empty without triangles.
  std::vector<shared::RayEmitter> Records;
  int Levels = 0;
  glm::vec4 Cube{ 0.0f }; ///< around the triangles; xyz: lowest corner, w: side
};

EmitterTree MakeEmitterTree(std::vector<EmittingTriangle> triangles);
}
