// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pass/SceneSignature.h"

#include "capture/ChangeTimes.h"
#include "rays/SkyPictures.h"
#include "rays/TexturePixels.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkTexture.h"

#include <cstdint>

namespace penumbra
{
namespace
{
double ToNumber(vtkMTimeType time)
{
  return static_cast<double>(time); // exact up to 2^53
}
}

void SceneSignature::Add(Group group, const double* values, int count)
{
  this->Values[group].insert(this->Values[group].end(), values, values + count);
}

void SceneSignature::AddLight(vtkLight* light)
{
  this->Values[Lights].push_back(light->GetSwitch());
  if (!light->LightTypeIsHeadlight())
  {
    this->Values[Lights].push_back(ToNumber(light->GetMTime()));
    if (light->LightTypeIsCameraLight())
    {
      // The camera's matrix moves it, which does not modify it.
      double position[3];
      double focus[3];
      light->GetTransformedPosition(position);
      light->GetTransformedFocalPoint(focus);
      this->Add(CarriedLights, position, 3);
      this->Add(CarriedLights, focus, 3);
    }
    return;
  }
  // Following the camera modifies a headlight.
  this->Values[CarriedLights].push_back(ToNumber(light->GetMTime()));
  this->Add(Lights, light->GetDiffuseColor(), 3);
  this->Add(Lights, light->GetAttenuationValues(), 3);
  for (const double value : { light->GetIntensity(), light->GetConeAngle(), light->GetExponent(),
         static_cast<double>(light->GetPositional()) })
  {
    this->Values[Lights].push_back(value);
  }
}

void SceneSignature::AddProp(vtkProp* prop)
{
  const bool visible = prop->GetVisibility() != 0;
  for (const Group group : { Props, Looks })
  {
    this->Values[group].push_back(visible);
  }
  if (!visible)
  {
    return;
  }
  this->Values[Presence].push_back(static_cast<double>(reinterpret_cast<std::uintptr_t>(prop)));
  vtkMTimeType changeTime = prop->GetRedrawMTime();
  vtkMTimeType appearanceTime = 0;
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkProp* part = path->GetLastNode()->GetViewProp();
    changeTime = std::max(changeTime, part->GetRedrawMTime());
    if (auto* actor = vtkActor::SafeDownCast(part))
    {
      appearanceTime = std::max(appearanceTime, AppearanceTime(actor));
    }
  }
  this->Values[Props].push_back(ToNumber(std::max(changeTime, appearanceTime)));
  this->Values[Looks].push_back(ToNumber(appearanceTime));
}

SceneSignature SceneSignature::Of(vtkOpenGLRenderer* renderer, const View& view,
  vtkMTimeType techniques, const PlaceholderLight& placeholder)
{
  SceneSignature signature;
  for (const auto* matrix : { &view.WorldToView, &view.ViewToClip })
  {
    signature.Add(Camera, &(*matrix)[0][0], 16);
  }
  const glm::dvec4 viewport(view.Viewport);
  signature.Add(Camera, &viewport[0], 4);
  for (const double* color : { renderer->GetBackground(), renderer->GetBackground2() })
  {
    signature.Add(Looks, color, 3);
  }
  signature.Values[Looks].push_back(renderer->GetGradientBackground());
  signature.Values[Techniques].push_back(ToNumber(techniques));
  if (vtkTexture* environment = renderer->GetEnvironmentTexture())
  {
    signature.Values[Lights].push_back(ToNumber(TextureTime(environment)));
    signature.Values[Lights].push_back(renderer->GetUseImageBasedLighting());
    const SkyDecoding decoding = SkyDecoding::Of(renderer);
    for (const bool flag : { decoding.Harmonics, decoding.MatteToLinear, decoding.GlossToLinear })
    {
      signature.Values[Lights].push_back(flag);
    }
    for (const double* axis : { renderer->GetEnvironmentUp(), renderer->GetEnvironmentRight() })
    {
      signature.Add(Lights, axis, 3);
    }
  }
  vtkCollectionSimpleIterator cookie;
  vtkLightCollection* lights = renderer->GetLights();
  lights->InitTraversal(cookie);
  while (vtkLight* light = lights->GetNextLight(cookie))
  {
    if (!placeholder.Is(light))
    {
      signature.AddLight(light);
    }
  }
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    if (!vtkActor2D::SafeDownCast(prop)) // drawn onto the finished picture
    {
      signature.AddProp(prop);
    }
  }
  return signature;
}

SceneChanges SceneSignature::ChangesSince(const SceneSignature& before) const
{
  const auto differs = [&](Group group) { return this->Values[group] != before.Values[group]; };
  SceneChanges changes;
  const bool camera = differs(Camera);
  changes.CarriedLights = camera && differs(CarriedLights);
  changes.Lights = differs(Lights) || (!camera && differs(CarriedLights));
  changes.Props = differs(Props);
  changes.Presence = differs(Presence);
  changes.Appearance = differs(Looks);
  changes.Techniques = differs(Techniques);
  changes.Any =
    changes.Lights || changes.Props || changes.Appearance || changes.Techniques || camera;
  return changes;
}
}
