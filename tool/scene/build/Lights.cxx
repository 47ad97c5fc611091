// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build/Lights.h"

#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

namespace penumbra::tool
{
namespace
{
void Aim(vtkLight* light, const Light& from)
{
  light->SetLightTypeToSceneLight();
  light->SetPosition(from.Position[0], from.Position[1], from.Position[2]);
  light->SetFocalPoint(from.Target[0], from.Target[1], from.Target[2]);
}

void AddLight(const Light& from, vtkRenderer* renderer)
{
  vtkNew<vtkLight> light;
  switch (from.Kind)
  {
    case LightKind::Key:
      light->SetLightTypeToCameraLight();
      light->SetDirectionAngle(from.Elevation, from.Azimuth);
      break;
    case LightKind::Head:
      light->SetLightTypeToHeadlight();
      break;
    case LightKind::Directional:
      Aim(light, from);
      break;
    case LightKind::Point:
      Aim(light, from);
      light->PositionalOn();
      light->SetConeAngle(90); // no cone, in VTK's convention
      break;
    case LightKind::Cone:
      Aim(light, from);
      light->PositionalOn();
      light->SetConeAngle(from.Angle);
      light->SetExponent(from.Exponent);
      break;
  }
  light->SetAttenuationValues(from.Attenuation[0], from.Attenuation[1], from.Attenuation[2]);
  light->SetColor(from.Color[0], from.Color[1], from.Color[2]);
  light->SetIntensity(from.Intensity);
  light->SetSwitch(from.On);
  renderer->AddLight(light);
}
}

std::vector<Light> DefaultLights()
{
  Light key, fill;
  key.Kind = LightKind::Key;
  key.Intensity = 0.95;
  fill.Kind = LightKind::Head;
  fill.Intensity = 0.15;
  return { key, fill };
}

void SetLights(const std::vector<Light>& lights, vtkRenderer* renderer)
{
  renderer->AutomaticLightCreationOff();
  renderer->RemoveAllLights();
  for (const Light& light : lights)
  {
    AddLight(light, renderer);
  }
}
}
