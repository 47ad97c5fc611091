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
/// A pleasing material for the index-th surface of a scene: each of the first few has its own colour.
Material DefaultMaterial(std::size_t index, bool underEnvironment);

/// Whether the material wants texture coordinates.
bool ShowsPictures(const Material& material);

/// A shallow copy of the geometry with what the material needs (tangents for normal maps, texture coordinates for
/// emission without a picture).
vtkSmartPointer<vtkPolyData> PrepareFor(const Material& material, vtkPolyData* geometry);

/// Sets the actor's property and textures; throws a Failure for a texture that cannot be read.
void ApplyMaterial(const Material& material, vtkActor* actor);
}
