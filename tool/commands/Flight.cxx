// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Flight.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

namespace penumbra::tool
{
namespace
{
constexpr double DegreesPerFrame = 0.25; // a turn in 24 s at 60 frames per second
}

Flight::Flight(vtkRenderer* renderer)
  : Renderer(renderer)
{
  this->End->DeepCopy(renderer->GetActiveCamera());
}

Flight::~Flight() = default;

void Flight::Place(int remaining)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->DeepCopy(this->End);
  if (remaining > 0)
  {
    camera->Azimuth(-DegreesPerFrame * remaining);
    this->Renderer->ResetCameraClippingRange();
  }
}
}
