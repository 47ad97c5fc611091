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

/// The triangles, ordered along a curve through space, then the pairs of nodes of a complete binary tree above them, as
/// rays/emitters.glsl reads them (Conty Estevez and Kulla 2018, Importance Sampling of Many Lights with Adaptive Tree
/// Splitting; Morton 1966, A Computer Oriented Geodetic Data Base and a New Technique in File Sequencing). Empty without
/// triangles.
std::vector<shared::RayEmitter> MakeEmitterTree(std::vector<EmittingTriangle> triangles);

/// Number of levels of that tree.
int EmitterTreeLevels(std::size_t triangles);
}
