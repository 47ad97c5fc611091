// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Times of the last change of props, more complete than VTK's own modification times.
 */
#pragma once

#include <vtkType.h>

class vtkActor;
class vtkMapper;

namespace penumbra
{
/// Time of the last change of an actor's appearance, regardless of its position: data, colours, textures, clipping
/// planes.
vtkMTimeType AppearanceTime(vtkActor* actor);

/// Time of the last change of a mapper's surface, without its colours if the two can be distinguished.
vtkMTimeType ShapeTime(vtkMapper* mapper);
}
