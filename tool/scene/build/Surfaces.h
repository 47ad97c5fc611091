// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Surfaces of loaded data.
#pragma once

#include "common/Reporter.h"
#include "scene/build/TriangleBudget.h"
#include "scene/model/LoadedData.h"

#include <vtkPolyData.h>

namespace penumbra::tool
{
/// One surface of an object.
struct Part
{
  vtkSmartPointer<vtkPolyData> Geometry;
  std::string Label;
};

/// The surfaces of an object of data or heights: isosurfaces of volumes, terrain, the outer surface of grids, and each
/// block of a composite. Points that are not finite are dropped. Throws a Failure if nothing is left to draw, or if there
/// are more triangles than the budget allows.
std::vector<Part> MakeParts(
  const LoadedData& loaded, const Object& object, const TriangleBudget& budget, Reporter& reporter);

/// One part for each of the object's isovalues, or for a chosen isovalue, which is reported.
std::vector<Part> MakeIsosurfaces(vtkDataSet* data, const Object& object, Reporter& reporter);

/// An image warped by its values, which remain the active scalars.
Part MakeTerrain(
  const LoadedData& loaded, const Object& object, const TriangleBudget& budget, Reporter& reporter);

/// Names of the numeric arrays.
std::vector<std::string> ArrayNames(vtkFieldData* fields);

/// The object's name in messages: its file, or its name in the scene.
std::string Describe(const Object& object);

/// Number of triangles in the polygons and strips.
vtkIdType CountTriangles(vtkPolyData* geometry);
}
