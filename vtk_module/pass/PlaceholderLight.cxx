// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pass/DarkLamp.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkOpenGLRenderer.h"

namespace penumbra
{
DarkLamp::DarkLamp()
{
  this->Lamp->SetLightTypeToSceneLight();
  this->Lamp->SetIntensity(0.0);
}

DarkLamp::~DarkLamp()
{
  this->Remove();
}

void DarkLamp::Add(vtkOpenGLRenderer* renderer)
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
  lights->AddItem(this->Lamp);
  renderer->UpdateLights();
}

void DarkLamp::Remove()
{
  if (this->Renderer)
  {
    this->Renderer->GetLights()->RemoveItem(this->Lamp);
    this->Renderer->UpdateLights();
    this->Renderer = nullptr;
  }
}
}
