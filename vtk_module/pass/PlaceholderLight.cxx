// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pass/PlaceholderLight.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkOpenGLRenderer.h"

namespace penumbra
{
PlaceholderLight::PlaceholderLight()
{
  this->Light->SetLightTypeToSceneLight();
  this->Light->SetIntensity(0.0);
}

PlaceholderLight::~PlaceholderLight()
{
  this->Remove();
}

void PlaceholderLight::Add(vtkOpenGLRenderer* renderer)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator cookie;
  lights->InitTraversal(cookie);
  while (vtkLight* light = lights->GetNextLight(cookie))
  {
    if (light->GetSwitch())
    {
      return;
    }
  }
  this->Remove();
  this->Renderer = renderer;
  lights->AddItem(this->Light);
  renderer->UpdateLights();
}

void PlaceholderLight::Remove()
{
  if (this->Renderer)
  {
    this->Renderer->GetLights()->RemoveItem(this->Light);
    this->Renderer->UpdateLights();
    this->Renderer = nullptr;
  }
}
}
