// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Long thin triangles in pieces: askew, their bounds are nearly all empty, and overlap those of many
 * others. A piece has bounds of its own; what a ray meets stays the whole triangle (Ernst and Greiner
 * 2007, Early Split Clipping for Bounding Volume Hierarchies; Karras and Aila 2013, Fast Parallel
 * Construction of High-Quality Bounding Volume Hierarchies, section 5).
 */
#pragma once

#include "rays/RayGeometry.h"
#include "rays/RayTree.h"

#include <cstdint>

namespace penumbra
{
/// bounds: of the geometry's primitives; those of triangles in pieces become those of their first
/// piece, and the other pieces' are appended. Returns for each appended one the triangle it is of;
/// nothing where all triangles are of a good shape.
std::vector<std::uint32_t> SplitLongTriangles(
  const RayGeometry& geometry, std::vector<RayBounds>& bounds);
}
