// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sky/SkyProp.h"

#include "vtkMath.h"
#include "vtkSkybox.h"
#include "vtkTexture.h"

namespace penumbra
{
vtkSmartPointer<vtkSkybox> MakeSkybox(vtkTexture* environment)
{
  auto skybox = vtkSmartPointer<vtkSkybox>::New();
  skybox->SetProjectionToSphere();
  skybox->SetTexture(environment);
  skybox->GammaCorrectOn();
  return skybox;
}

void Orient(vtkSkybox* skybox, const double right[3], const double up[3])
{
  // VTK's skybox is rotated by a quarter turn relative to its image-based light.
  double aside[3];
  vtkMath::Cross(right, up, aside);
  skybox->SetFloorPlane(
    static_cast<float>(up[0]), static_cast<float>(up[1]), static_cast<float>(up[2]), 0.0f);
  skybox->SetFloorRight(
    static_cast<float>(aside[0]), static_cast<float>(aside[1]), static_cast<float>(aside[2]));
}
}
