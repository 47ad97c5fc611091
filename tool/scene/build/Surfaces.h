// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// From what a file holds to the surfaces that are drawn.
#pragma once

#include "common/Reporter.h"
#include "scene/build/TriangleBudget.h"
#include "scene/model/Loaded.h"

#include <vtkPolyData.h>

namespace penumbra::tool
{
/// One surface of an object.
struct Part
{
  vtkSmartPointer<vtkPolyData> Geometry;
  std::string Label;
};

/// Surfaces of an object whose content is data or heights: isosurfaces of volumes, terrain, the outer
/// surface of grids, each block of a composite. Points that are not finite are dropped. Throws a
/// Failure where nothing is left to draw, or more than the budget allows.
std::vector<Part> MakeParts(
  const Loaded& loaded, const Object& object, const TriangleBudget& budget, Reporter& reporter);

/// The object's name for sentences: its file, or the name given in the scene.
std::string Describe(const Object& object);

/// Triangles that drawing the polygons and strips takes.
vtkIdType CountTriangles(vtkPolyData* geometry);
}
