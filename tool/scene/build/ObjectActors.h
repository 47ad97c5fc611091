// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// From one described object to its actors.
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
  vtkSmartPointer<vtkLookupTable> Coloring; ///< where a scalar bar is asked for
};

/// Reads or makes the object. Surfaces without a material take default ones from paletteIndex on,
/// which is advanced. Adds what must be in view to points.
ObjectActors MakeActors(const Object& object, bool underEnvironment, std::size_t& paletteIndex,
  FramedPoints& points, const TriangleBudget& budget, Reporter& reporter);
}
