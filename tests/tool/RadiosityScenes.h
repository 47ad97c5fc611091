// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Small scenes of known form factors and light.
#pragma once

#include "bake/radiosity/Radiosity.h"

#include <cstdint>

namespace penumbra_test
{
using penumbra::radiosity::Color;
using penumbra::radiosity::PatchMesh;
using penumbra::radiosity::Point;

std::uint32_t AddMatte(
  PatchMesh& mesh, const Color& reflectance, const Color& emission = Color(0.0));
/// Corners counter-clockwise as seen from its front.
void AddQuad(PatchMesh& mesh, const std::array<Point, 4>& corners, std::uint32_t surface);
/// Six quads whose fronts are inside, or outside.
void AddBox(
  PatchMesh& mesh, const Point& low, const Point& high, std::uint32_t surface, bool inside);
/// Of 720 corners, its front up or down.
void AddDisc(PatchMesh& mesh, double radius, double z, bool up, std::uint32_t surface);
void Cut(PatchMesh& mesh, double size);
}
