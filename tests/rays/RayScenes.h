// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes for tests of rays, each difficult in its own way.
#pragma once

#include "rays/RayGeometry.h"

#include <random>
#include <string>

class vtkPolyData;

namespace penumbra_test
{
struct RayWorld
{
  struct Placement
  {
    std::size_t Mesh;
    glm::dmat4 MeshToWorld{ 1.0 };
  };
  std::string Name;
  std::vector<penumbra::RayGeometry> Meshes;
  std::vector<Placement> Instances;
  glm::dvec3 Center{ 0.0 }; ///< the origin that rays are relative to
  double Radius = 1.0;      ///< of a ball around the centre that holds the scene

  /// Set centre and radius from the contents.
  void Measure();
};

/// Spheres of triangles at random positions, with a number of rings of latitude each.
penumbra::RayGeometry SphereField(int spheres, int rings, unsigned int seed = 1);
/// One closed sphere of triangles of radius 1.
penumbra::RayGeometry ClosedSphere(int rings);
/// Triangles a thousand to a million times longer than wide.
penumbra::RayGeometry Slivers(int count);
/// Good triangles among others without area, duplicated, not finite, or with bad indices.
penumbra::RayGeometry Degenerate(int spheres);
/// Triangles of polygonal data, with points in double precision.
penumbra::RayGeometry FromPolyData(vtkPolyData* data);
/// An isosurface of a smooth function on a grid, from VTK's filters.
penumbra::RayGeometry Isosurface(int resolution);

/// A world of one mesh in its own coordinates.
RayWorld Single(const std::string& name, penumbra::RayGeometry geometry);
/// The sphere field a million units away along each axis, as doubles.
RayWorld FarAway();
/// Many rotated and stretched instances of a mesh, and of slivers.
RayWorld Scattered(const std::string& name, penumbra::RayGeometry mesh, int count);
/// The same of small spheres.
RayWorld Glyphs(int count);
/// A world of each kind.
std::vector<RayWorld> AllWorlds();
}
