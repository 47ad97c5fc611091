// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Splits long thin triangles: if they are not aligned with an axis, their bounds are mostly empty and overlap those of
 * many others. Each piece has its own bounds, but a ray still intersects the whole triangle (Ernst and Greiner
 * 2007, Early Split Clipping for Bounding Volume Hierarchies; Karras and Aila 2013, Fast Parallel
 * Construction of High-Quality Bounding Volume Hierarchies, section 5).
 */
#pragma once

#include "rays/RayGeometry.h"
#include "rays/RayTree.h"

#include <cstdint>

namespace penumbra
{
/// Split the long triangles of a geometry. bounds: bounds of its primitives. Those of a split triangle are replaced by
/// the bounds of its first piece; the bounds of the other pieces are appended. Returns the triangle of each appended
/// piece, so nothing if no triangle is split.
std::vector<std::uint32_t> SplitLongTriangles(
  const RayGeometry& geometry, std::vector<RayBounds>& bounds);
}
