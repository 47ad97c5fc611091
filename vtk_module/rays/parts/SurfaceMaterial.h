// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Converts a vtkProperty to a material for ray tracing.
 */
#pragma once

#include "rays/RayPart.h"

class vtkActor;
class vtkProperty;

namespace penumbra
{
/// Replace a surface's colour, as VTK's shaders replace the property's diffuse and
/// ambient colours.
void Recolor(shared::RaySurface& surface, vtkProperty* property, const glm::vec3& color);

/// Multiply a surface's opacity.
void Fade(shared::RaySurface& surface, float opacity);

/// Material of a property, without scalar colours. Flags that depend on
/// the mesh (smooth normals, colours) are not set.
shared::RaySurface MakeRaySurface(vtkProperty* property);

/// Textures that VTK shows on an actor's surface if it has texture coordinates.
std::array<vtkTexture*, PictureSlots> PropertyPictures(vtkActor* actor);
}
