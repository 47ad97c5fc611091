// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Lights of the scene as VTK lights.
#pragma once

#include "scene/model/SceneModel.h"

class vtkRenderer;

namespace penumbra::tool
{
/// A key light from above left that follows the camera, and a weak headlight to fill its shadows.
std::vector<Light> DefaultLights();

/// Replaces the renderer's lights.
void SetLights(const std::vector<Light>& lights, vtkRenderer* renderer);
}
