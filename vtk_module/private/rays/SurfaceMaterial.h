// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A vtkProperty as the rays need it.
 */
#pragma once

#include "ray_surface.h"

class vtkActor;
class vtkProperty;

namespace penumbra
{
/// The material of a property, without scalar colours. Flags are set but for those that depend on
/// the mesh (smooth normals, colours).
shared::RaySurface MakeRaySurface(vtkProperty* property);
}
