// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Triangles and attributes of polygonal data as VTK draws them.
 */
#pragma once

#include "private/rays/RayPart.h"

class vtkActor;
class vtkMapper;
class vtkPolyData;

namespace penumbra
{
/// Polygons as fans from their first corner, as VTK's mapper splits them, then strips.
RayGeometry PolyDataGeometry(vtkPolyData* data);

/// The part of an actor that a mapper draws from this data. The surface takes the mapper's scalar
/// colours and the data's normals.
RayPart PolyDataPart(vtkActor* actor, vtkMapper* mapper, vtkPolyData* data, const glm::dmat4& toWorld);
}
