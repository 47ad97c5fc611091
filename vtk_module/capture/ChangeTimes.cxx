// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "capture/ChangeTimes.h"

#include "rays/TexturePixels.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
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

// A prop's own time includes a mapper's first input only if that is a single dataset. It includes neither other
// inputs (shapes of glyphs) nor the clipping planes' own changes.
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

vtkMTimeType PropertyTime(vtkProperty* property)
{
  vtkMTimeType time = property->GetMTime();
  for (const auto& named : property->GetAllTextures())
  {
    time = std::max(time, named.second ? TextureTime(named.second) : 0);
  }
  return time;
}
}

vtkMTimeType AppearanceTime(vtkActor* actor)
{
  vtkMTimeType time = PropertyTime(actor->GetProperty());
  time = std::max(time, actor->GetMapper() ? MapperTime(actor->GetMapper()) : 0);
  time = std::max(time, actor->GetTexture() ? TextureTime(actor->GetTexture()) : 0);
  vtkProperty* back = actor->GetBackfaceProperty();
  return std::max(time, back ? PropertyTime(back) : 0);
}

vtkMTimeType ShapeTime(vtkMapper* mapper)
{
  vtkDataObject* data = mapper->GetInputDataObject(0, 0);
  auto* surface = vtkPolyData::SafeDownCast(data);
  if (!surface || !surface->GetPoints() || mapper->GetNumberOfInputPorts() > 1)
  {
    return DataTime(data);
  }
  vtkMTimeType time = surface->GetPoints()->GetMTime();
  for (vtkCellArray* cells :
    { surface->GetPolys(), surface->GetStrips(), surface->GetLines(), surface->GetVerts() })
  {
    time = std::max(time, cells ? cells->GetMTime() : 0);
  }
  return time;
}
}
