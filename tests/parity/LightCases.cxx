// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cases.h"
#include "SceneParts.h"

#include "vtkActorCollection.h"
#include "vtkLightKit.h"
#include "vtkPlaneSource.h"
#include "vtkTransform.h"

namespace penumbra_test
{
namespace
{
// A shiny torus over a floor.
void AddScene(Stage& stage)
{
  vtkProperty* property = stage.Add(Torus())->GetProperty();
  property->SetSpecular(0.5);
  property->SetSpecularPower(20.0);
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-2.0, -1.5, -0.5);
  floor->SetPoint1(2.0, -1.5, -0.5);
  floor->SetPoint2(-2.0, 1.5, -0.5);
  floor->SetResolution(4, 4);
  stage.Add(floor)->GetProperty()->SetColor(0.8, 0.8, 0.9);
  Stage::LookAround(stage.Renderer);
}

vtkLight* AddLamp(Stage& stage, double x, double y, double z)
{
  vtkLight* light = AddLight(stage, x, y, z);
  light->PositionalOn();
  return light;
}

vtkLight* AddCone(Stage& stage, double angle, double exponent)
{
  vtkLight* light = AddLamp(stage, 0.5, 0.5, 2.5);
  light->SetConeAngle(angle);
  light->SetExponent(exponent);
  return light;
}

// The scene with lights.
template <void (*Lights)(Stage&)>
void Lit(Stage& stage)
{
  AddScene(stage);
  Lights(stage);
}

void Headlight(Stage& s)
{
  AddLight(s, 0, 0, 1)->SetLightTypeToHeadlight();
}

void HeadlightColoured(Stage& s)
{
  vtkLight* light = AddLight(s, 0, 0, 1);
  light->SetLightTypeToHeadlight();
  light->SetColor(1.0, 0.6, 0.3);
  light->SetIntensity(0.7);
}

void CameraLight(Stage& s)
{
  AddLight(s, 0.6, 0.5, 1.0)->SetLightTypeToCameraLight();
}

void SceneLight(Stage& s)
{
  AddLight(s, 2, 1, 3);
}

void SeveralDirectional(Stage& s)
{
  AddLight(s, 2, 1, 3)->SetColor(1.0, 0.2, 0.2);
  AddLight(s, -2, 1, 3)->SetColor(0.2, 1.0, 0.2);
  AddLight(s, 0, -3, 1)->SetColor(0.2, 0.2, 1.0);
}

void MixedTypes(Stage& s)
{
  AddLight(s, 0, 0, 1)->SetLightTypeToHeadlight();
  AddLight(s, 1, 1, 1)->SetLightTypeToCameraLight();
  AddLamp(s, -1, 1, 1)->SetColor(0.9, 0.9, 0.2);
  AddCone(s, 25.0, 2.0)->SetColor(0.3, 0.5, 1.0);
}

void Positional(Stage& s)
{
  AddLamp(s, 1, 1, 1);
}

void SeveralPositional(Stage& s)
{
  AddLamp(s, 1, 1, 1)->SetColor(1.0, 0.3, 0.3);
  AddLamp(s, -1, 0.5, 0.7)->SetColor(0.3, 1.0, 0.3);
  AddLamp(s, 0, -1, 0.4)->SetColor(0.3, 0.3, 1.0);
}

void PositionalHeadlight(Stage& s)
{
  vtkLight* light = AddLamp(s, 0, 0, 1);
  light->SetLightTypeToHeadlight();
}

void PositionalCameraLight(Stage& s)
{
  vtkLight* light = AddLamp(s, 0.5, 0.5, 0.6);
  light->SetLightTypeToCameraLight();
}

void Attenuation(Stage& s)
{
  AddLamp(s, 1, 1, 1)->SetAttenuationValues(0.2, 0.5, 0.6);
}

void Cone(Stage& s)
{
  AddCone(s, 15.0, 1.0);
}

void ConeWithFalloff(Stage& s)
{
  AddCone(s, 40.0, 20.0)->SetAttenuationValues(0.5, 0.2, 0.0);
}

void ConeWide(Stage& s)
{
  AddCone(s, 89.0, 3.0);
}

void OffFirst(Stage& s)
{
  AddLight(s, -2, -1, 3)->SwitchOff();
  AddLight(s, 2, 1, 3)->SetColor(1.0, 0.8, 0.5);
}

// VTK then adds a headlight, but lights the first frame with another formula than the next. The two differ in
// highlights only, so there are none.
void AllOff(Stage& s)
{
  AddLight(s, 2, 1, 3)->SwitchOff();
  vtkActorCollection* actors = s.Renderer->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    static_cast<vtkActor*>(actors->GetItemAsObject(i))->GetProperty()->SetSpecular(0.0);
  }
}

void OffAfterHeadlight(Stage& s)
{
  AddLight(s, 0, 0, 1)->SetLightTypeToHeadlight();
  AddLight(s, 2, 1, 3)->SwitchOff();
}

void None(Stage& s)
{
  s.Renderer->AutomaticLightCreationOff();
}

void Kit(Stage& s)
{
  vtkNew<vtkLightKit> kit;
  kit->AddLightsToRenderer(s.Renderer);
}

void Twelve(Stage& s)
{
  for (int i = 0; i < 12; ++i)
  {
    vtkLight* light = i % 2 ? AddLamp(s, std::cos(i), std::sin(i), 0.8)
                            : AddLight(s, std::cos(i), std::sin(i), 1.0);
    light->SetColor(0.5 + 0.5 * std::cos(i), 0.5 + 0.5 * std::sin(2 * i), 0.4);
    light->SetIntensity(0.3);
  }
}

void Transformed(Stage& s)
{
  vtkNew<vtkTransform> transform;
  transform->RotateZ(60.0);
  transform->Translate(0.3, 0.2, 0.0);
  AddLamp(s, 1, 1, 1)->SetTransformMatrix(transform->GetMatrix());
}

void Bright(Stage& s)
{
  AddLight(s, 1, 1, 3)->SetIntensity(4.0);
}

void DiffuseOnlyColour(Stage& s)
{
  vtkLight* light = AddLight(s, 1, 1, 3);
  light->SetDiffuseColor(0.9, 0.4, 0.1);
  light->SetSpecularColor(0.1, 0.1, 1.0);
  light->SetAmbientColor(0.0, 0.5, 0.0);
}

void NotFollowing(Stage& s)
{
  AddLight(s, 0, 0, 1)->SetLightTypeToHeadlight();
  s.Renderer->LightFollowCameraOff();
}
}

ParityCases LightCases()
{
  return {
    { "headlight", Lit<Headlight> },
    { "headlight, coloured", Lit<HeadlightColoured> },
    { "camera light", Lit<CameraLight> },
    { "scene light", Lit<SceneLight> },
    { "scene lights, coloured", Lit<SeveralDirectional> },
    { "lights of every type", Lit<MixedTypes> },
    { "positional light", Lit<Positional> },
    { "positional lights", Lit<SeveralPositional> },
    { "positional headlight", Lit<PositionalHeadlight> },
    { "positional camera light", Lit<PositionalCameraLight> },
    { "attenuation", Lit<Attenuation> },
    { "cone light", Lit<Cone> },
    { "cone light with falloff", Lit<ConeWithFalloff> },
    { "cone light, nearly a hemisphere", Lit<ConeWide> },
    { "light off, first in the list", Lit<OffFirst> },
    { "light off, after a headlight", Lit<OffAfterHeadlight> },
    { "every light off", Lit<AllOff> },
    { "no light", Lit<None> },
    { "light kit", Lit<Kit> },
    { "twelve lights", Lit<Twelve> },
    { "light with a transform", Lit<Transformed> },
    { "light brighter than white", Lit<Bright> },
    { "light's three colours", Lit<DiffuseOnlyColour> },
    { "light not following the camera", Lit<NotFollowing> },
  };
}
}
