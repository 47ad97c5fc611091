// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/SceneSignature.h"

#include "private/rays/TexturePixels.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkTexture.h"

namespace penumbra
{
namespace
{
vtkMTimeType DataTime(vtkDataObject* data)
{
  vtkMTimeType time = data ? data->GetMTime() : 0;
  if (auto* tree = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto iterator = vtk::TakeSmartPointer(tree->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      time = std::max(time, iterator->GetCurrentDataObject()->GetMTime());
    }
  }
  return time;
}

// A prop's own time counts a mapper's first input only where that is one dataset, and neither other
// inputs (glyphs' shapes) nor what clipping planes are.
vtkMTimeType MapperTime(vtkMapper* mapper)
{
  vtkMTimeType time = mapper->GetMTime();
  for (int port = 0; port < mapper->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < mapper->GetNumberOfInputConnections(port); ++i)
    {
      if (!mapper->GetStatic())
      {
        mapper->GetInputAlgorithm(port, i)->Update();
      }
      time = std::max(time, DataTime(mapper->GetInputDataObject(port, i)));
    }
  }
  if (vtkScalarsToColors* table =
        mapper->GetScalarVisibility() ? mapper->GetLookupTable() : nullptr)
  {
    time = std::max(time, table->GetMTime());
  }
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    time = std::max(time, planes->GetItem(i)->GetMTime());
  }
  return time;
}

vtkMTimeType PicturesTime(vtkActor* actor)
{
  vtkMTimeType time = actor->GetTexture() ? TextureTime(actor->GetTexture()) : 0;
  for (vtkProperty* property : { actor->GetProperty(), actor->GetBackfaceProperty() })
  {
    if (property)
    {
      for (const auto& named : property->GetAllTextures())
      {
        time = std::max(time, named.second ? TextureTime(named.second) : 0);
      }
    }
  }
  return time;
}

// Of what a prop is made of: an assembly's time does not count its parts' data.
vtkMTimeType PartsTime(vtkProp* prop)
{
  vtkMTimeType time = 0;
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkProp* part = path->GetLastNode()->GetViewProp();
    time = std::max(time, part->GetRedrawMTime());
    if (auto* actor = vtkActor::SafeDownCast(part))
    {
      time = std::max(time, PicturesTime(actor));
      time = std::max(time, actor->GetMapper() ? MapperTime(actor->GetMapper()) : 0);
    }
  }
  return time;
}
}

vtkMTimeType SceneSignature::TimeOf(vtkProp* prop)
{
  return std::max(prop->GetRedrawMTime(), PartsTime(prop));
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
  signature.Numbers.push_back(renderer->GetGradientBackground());
  signature.Times.push_back(techniques);
  if (vtkTexture* environment = renderer->GetEnvironmentTexture())
  {
    signature.Times.push_back(TextureTime(environment));
    signature.Numbers.push_back(renderer->GetUseImageBasedLighting());
    for (const double* axis : { renderer->GetEnvironmentUp(), renderer->GetEnvironmentRight() })
    {
      signature.Numbers.insert(signature.Numbers.end(), axis, axis + 3);
    }
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
      signature.Times.push_back(PartsTime(prop));
    }
  }
  return signature;
}
}
