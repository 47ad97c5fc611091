// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "looks/SavedRenderer.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

namespace penumbra
{
SavedRenderer::SavedRenderer(vtkRenderer* renderer)
  : CreatesLights(renderer->GetAutomaticLightCreation())
  , LightsFollowCamera(renderer->GetLightFollowCamera())
{
  vtkCollectionSimpleIterator cookie;
  renderer->GetLights()->InitTraversal(cookie);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(cookie))
  {
    SavedLight saved;
    saved.Light = light;
    saved.Switch = light->GetSwitch();
    light->GetPosition(saved.Position.data());
    light->GetFocalPoint(saved.FocalPoint.data());
    saved.Transform = light->GetTransformMatrix();
    this->Lights.push_back(saved);
  }
  this->SaveBackground(renderer);
}

void SavedRenderer::SaveBackground(vtkRenderer* renderer)
{
  renderer->GetBackground(this->Back.Bottom.data());
  renderer->GetBackground2(this->Back.Top.data());
  this->Back.Alpha = renderer->GetBackgroundAlpha();
  this->Back.Gradient = renderer->GetGradientBackground();
  this->Back.Textured = renderer->GetTexturedBackground();
  this->Back.Texture = renderer->GetBackgroundTexture();
}

void SavedRenderer::SwitchLightsOff() const
{
  for (const SavedLight& saved : this->Lights)
  {
    saved.Light->SwitchOff();
  }
}

void SavedRenderer::RestoreLights() const
{
  for (const SavedLight& saved : this->Lights)
  {
    saved.Light->SetSwitch(saved.Switch);
    // A renderer whose lights stay behind when the camera moves would find them moved by the look's frames.
    if (!this->LightsFollowCamera && !saved.Light->LightTypeIsSceneLight())
    {
      saved.Light->SetPosition(saved.Position.data());
      saved.Light->SetFocalPoint(saved.FocalPoint.data());
      saved.Light->SetTransformMatrix(saved.Transform);
    }
  }
}

void SavedRenderer::Restore(vtkRenderer* renderer) const
{
  renderer->SetAutomaticLightCreation(this->CreatesLights);
  renderer->SetLightFollowCamera(this->LightsFollowCamera);
  renderer->SetBackground(this->Back.Bottom.data());
  renderer->SetBackground2(this->Back.Top.data());
  renderer->SetBackgroundAlpha(this->Back.Alpha);
  renderer->SetGradientBackground(this->Back.Gradient);
  renderer->SetTexturedBackground(this->Back.Textured);
  renderer->SetBackgroundTexture(this->Back.Texture);
}
}
