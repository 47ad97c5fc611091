// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/SceneSignature.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkTexture.h"

namespace penumbra
{
namespace
{
// A mapper's time counts its list of clipping planes, not the planes.
vtkMTimeType ClippingTime(vtkProp* prop)
{
  vtkMTimeType time = 0;
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  vtkPlaneCollection* planes = mapper ? mapper->GetClippingPlanes() : nullptr;
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    time = std::max(time, planes->GetItem(i)->GetMTime());
  }
  return time;
}
}

SceneSignature SceneSignature::Of(
  vtkOpenGLRenderer* renderer, const View& view, vtkMTimeType techniques)
{
  SceneSignature signature;
  for (const auto* matrix : { &view.WorldToView, &view.ViewToClip })
  {
    for (int i = 0; i < 16; ++i)
    {
      signature.Numbers.push_back((*matrix)[i / 4][i % 4]);
    }
  }
  for (int i = 0; i < 4; ++i)
  {
    signature.Numbers.push_back(view.Viewport[i]);
  }
  for (const double* color : { renderer->GetBackground(), renderer->GetBackground2() })
  {
    signature.Numbers.insert(signature.Numbers.end(), color, color + 3);
  }
  signature.Times.push_back(techniques);
  if (vtkTexture* environment = renderer->GetEnvironmentTexture())
  {
    signature.Times.push_back(environment->GetMTime());
  }
  vtkCollectionSimpleIterator cookie;
  vtkLightCollection* lights = renderer->GetLights();
  lights->InitTraversal(cookie);
  while (vtkLight* light = lights->GetNextLight(cookie))
  {
    signature.Times.push_back(light->GetMTime());
    signature.Numbers.push_back(light->GetSwitch());
  }
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    signature.Numbers.push_back(prop->GetVisibility());
    if (prop->GetVisibility())
    {
      signature.Times.push_back(prop->GetRedrawMTime());
      signature.Times.push_back(ClippingTime(prop));
    }
  }
  return signature;
}
}
