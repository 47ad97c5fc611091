// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Actors of an object.
#pragma once

#include "scene/build/Framing.h"
#include "scene/build/Surfaces.h"

#include <vtkLookupTable.h>

namespace penumbra::tool
{
struct ObjectActors
{
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  DefaultView View;
  vtkIdType Triangles = 0;
  vtkIdType Balls = 0;
  vtkSmartPointer<vtkLookupTable> Coloring; ///< for a scalar bar; null if there is none
};

/// Reads or makes an object. Surfaces without a material get the default materials from paletteIndex on, which is
/// advanced. Adds the points that must be visible.
ObjectActors MakeActors(const Object& object, bool underEnvironment, std::size_t& paletteIndex,
  std::vector<Vec3>& points, const TriangleBudget& budget, Reporter& reporter);
}
