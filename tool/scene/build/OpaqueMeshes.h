// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The opaque triangle meshes of a renderer, as ray tracing sees them.
#pragma once

#include "common/Reporter.h"

#include "rays/RayPart.h"

namespace penumbra::tool
{
struct MeshInstance
{
  const RayPart& Part;
  const RayGeometry& Geometry;
  const RayAttributes& Attributes;
  const RayPlace* Place; ///< null for a single instance
  glm::dmat4 ToWorld;
  bool Mirrored; ///< whether ToWorld reverses the order of corners

  glm::dvec3 PointAt(std::uint32_t index) const
  {
    const glm::dvec3 point = this->Geometry.Origin + glm::dvec3(this->Geometry.Points[index]);
    return glm::dvec3(this->ToWorld * glm::dvec4(point, 1.0));
  }
  /// The position of a triangle's k-th corner in the world's counter-clockwise order.
  int CornerAt(int k) const { return this->Mirrored ? (3 - k) % 3 : k; }
};

/// Calls visit, which returns the number of degenerate triangles, for each instance of a visible opaque mesh. Prints notes
/// on what is left out. unlit: whether to include surfaces that light does not shade.
void ForEachOpaqueMesh(vtkRenderer* renderer, bool unlit, Reporter& reporter,
  const std::function<std::size_t(const MeshInstance&)>& visit);
}
