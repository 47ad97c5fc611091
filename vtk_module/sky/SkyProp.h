// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A skybox that shows an equirectangular environment where VTK's image-based lighting has it.
 */
#pragma once

#include "vtkSmartPointer.h"

class vtkSkybox;
class vtkTexture;

namespace penumbra
{
vtkSmartPointer<vtkSkybox> MakeSkybox(vtkTexture* environment);

/// right, up: the renderer's EnvironmentRight and EnvironmentUp.
void Orient(vtkSkybox* skybox, const double right[3], const double up[3]);
}
