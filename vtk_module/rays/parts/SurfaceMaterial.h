// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A vtkProperty as the rays need it.
 */
#pragma once

#include "rays/RayPart.h"

class vtkActor;
class vtkProperty;

namespace penumbra
{
/// The same surface in another colour, which VTK's shaders put in place of the property's diffuse and
/// ambient ones.
void Recolor(shared::RaySurface& surface, vtkProperty* property, const glm::vec3& color);

/// Let through what an opacity below one, after the surface's own, says.
void Fade(shared::RaySurface& surface, float opacity);

/// The material of a property, without scalar colours. Flags are set but for those that depend on
/// the mesh (smooth normals, colours).
shared::RaySurface MakeRaySurface(vtkProperty* property);

/// The pictures that VTK shows on an actor's surface, where it has texture coordinates.
std::array<vtkTexture*, PictureSlots> PropertyPictures(vtkActor* actor);
}
