// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes that rays are tried on, each hard in its own way.
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

/// Spheres of triangles at random places, `rings` of latitude each.
penumbra::RayGeometry SphereField(int spheres, int rings, unsigned int seed = 1);
/// One closed sphere of triangles of radius 1.
penumbra::RayGeometry ClosedSphere(int rings);
/// Triangles a thousand to a million times longer than wide.
penumbra::RayGeometry Slivers(int count);
/// Good triangles among ones without area, twice the same, not finite, and with bad indices.
penumbra::RayGeometry Degenerate(int spheres);
/// The triangles of polygonal data, points in double precision.
penumbra::RayGeometry FromPolyData(vtkPolyData* data);
/// An isosurface of a smooth function on a grid, from VTK's filters.
penumbra::RayGeometry Isosurface(int resolution);

/// A world of one mesh in its own coordinates.
RayWorld Single(const std::string& name, penumbra::RayGeometry geometry);
/// The sphere field a million units away along each axis, as doubles.
RayWorld FarAway();
/// One glyph placed often, turned and stretched.
RayWorld Glyphs(int count);
/// All of them.
std::vector<RayWorld> AllWorlds();
}
