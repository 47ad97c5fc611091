// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Triangles and attributes of polygonal data as VTK draws them.
 */
#pragma once

#include "rays/parts/Gatherers.h"
#include "rays/parts/ScalarColors.h"

class vtkMapper;
class vtkPolyData;

namespace penumbra
{
/// Polygons as fans from their first corner, as VTK's mapper splits them, then strips.
RayGeometry PolyDataGeometry(vtkPolyData* data);

/// The part that a mapper draws from this data for an actor, with the data's normals and these
/// colours.
RayPart PolyDataPart(
  const GatherContext& context, vtkMapper* mapper, vtkPolyData* data, const ScalarColors& colors);
}
