// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A dataset prepared for ray tracing: its tree, and its records in the order of the leaves.
 */
#pragma once

#include "rays/RayGeometry.h"
#include "rays/RayTree.h"

namespace penumbra
{
class RayMesh
{
public:
  /// Build the tree. Primitives that are not finite are dropped and counted.
  explicit RayMesh(const RayGeometry& geometry);

  /// Update for moved points without changing the tree's structure. This is cheaper than building, but tracing gets
  /// slower the more the shape changed. Returns false and does nothing if the geometry has other primitives.
  bool Refit(const RayGeometry& geometry);

  const RayTree& Tree() const { return this->Bvh; }
  const glm::dvec3& Origin() const { return this->Center; }
  bool HasSpheres() const { return this->Spheres > 0; }
  bool HasCylinders() const { return this->Cylinders > 0; }
  std::size_t Dropped() const { return this->NotFinite; }

  /// The records to upload. ReleaseRecords() frees them, Refit() recreates them.
  const std::vector<shared::RayPrimitive>& Records() const { return this->Primitives; }
  void ReleaseRecords() { std::vector<shared::RayPrimitive>().swap(this->Primitives); }

private:
  std::vector<RayBounds> ItemBounds(const RayGeometry& geometry);
  void WriteRecords(const RayGeometry& geometry, const std::vector<RayBounds>& bounds);

  RayTree Bvh;
  std::vector<shared::RayPrimitive> Primitives;
  glm::dvec3 Center{ 0.0 };
  std::size_t Triangles = 0;
  std::size_t Spheres = 0;
  std::size_t Cylinders = 0;
  std::size_t NotFinite = 0;
  bool Split = false; ///< whether some triangles are split into pieces
};
}
