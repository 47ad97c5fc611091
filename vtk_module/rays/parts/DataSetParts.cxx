// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Mappers that draw one dataset's polygons.
#include "rays/parts/PolyDataParts.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkDataSet.h"
#include "vtkDataSetMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#if __has_include("vtkGeometryFilter.h")
#include "vtkGeometryFilter.h"
#endif
#include "vtkDataSetSurfaceFilter.h"

namespace penumbra
{
namespace
{
/// The mapper makes its filter and its inner mapper when it draws for the first time, which is later
/// than rays need them; a derived class may name the members, and it takes those that are there.
struct Inner : public vtkDataSetMapper
{
  template <typename Filter>
  static void Fill(vtkDataSetMapper* mapper, Filter* vtkDataSetMapper::*)
  {
    if (!(mapper->*(&Inner::PolyDataMapper)))
    {
      mapper->*(&Inner::GeometryExtractor) = Filter::New();
      mapper->*(&Inner::PolyDataMapper) = vtkPolyDataMapper::New();
    }
  }

  static vtkPolyData* Surface(vtkDataSetMapper* mapper)
  {
    Fill(mapper, &Inner::GeometryExtractor);
    auto* filter = mapper->*(&Inner::GeometryExtractor);
    vtkPolyDataMapper* inner = mapper->*(&Inner::PolyDataMapper);
    filter->SetInputData(mapper->GetInput());
    inner->SetInputConnection(filter->GetOutputPort());
    filter->Update();
    return filter->GetOutput();
  }
};
}

bool GatherPolyData(vtkMapper* mapper, const Drawn& drawn)
{
  UpdateInput(mapper);
  if (vtkPolyData* data = static_cast<vtkPolyDataMapper*>(mapper)->GetInput())
  {
    const ScalarColors& colors = MapScalarColors(drawn.Cache, mapper, data);
    drawn.Parts.push_back(PolyDataPart(drawn, mapper, data, colors));
  }
  return true;
}

bool GatherDataSet(vtkMapper* mapper, const Drawn& drawn)
{
  UpdateInput(mapper);
  auto* source = static_cast<vtkDataSetMapper*>(mapper);
  vtkPolyData* data = vtkPolyData::SafeDownCast(source->GetInput());
  if (!data && source->GetInput())
  {
    data = Inner::Surface(source);
  }
  if (data)
  {
    const ScalarColors& colors = MapScalarColors(drawn.Cache, mapper, data);
    drawn.Parts.push_back(PolyDataPart(drawn, mapper, data, colors));
  }
  return true;
}
}
