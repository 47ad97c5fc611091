// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Materials as VTK properties and textures.
#pragma once

#include "scene/model/SceneModel.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace penumbra::tool
{
/// The default material of the index-th surface of a scene. The first few have different colours.
Material DefaultMaterial(std::size_t index, bool underEnvironment);

/// Whether the material needs texture coordinates.
bool HasTextures(const Material& material);

/// A shallow copy of the geometry, with tangents for normal maps, and with texture coordinates for emission without a
/// texture.
vtkSmartPointer<vtkPolyData> PrepareGeometry(const Material& material, vtkPolyData* geometry);

/// Sets the actor's property and textures. Throws a Failure if a texture cannot be read.
void ApplyMaterial(const Material& material, vtkActor* actor);
}
