// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * When what is drawn last changed, beyond what VTK's own modification times tell.
 */
#pragma once

#include <vtkType.h>

class vtkActor;
class vtkMapper;

namespace penumbra
{
/// Of all that an actor shows, wherever it is: data, colours, textures, clipping planes.
vtkMTimeType LookTime(vtkActor* actor);

/// Of the surface that a mapper shows, not of its colours where the two can be told apart.
vtkMTimeType ShapeTime(vtkMapper* mapper);
}
