// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Mappers that draw the polygons of a single dataset.
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
/// Access to protected members. The mapper creates its filter and its inner mapper when it draws for the first time,
/// which is too late for rays; it uses them if they exist already.
struct DataSetMapperAccess : public vtkDataSetMapper
{
  template <typename Filter>
  static void Fill(vtkDataSetMapper* mapper, Filter* vtkDataSetMapper::*)
  {
    if (!(mapper->*(&DataSetMapperAccess::PolyDataMapper)))
    {
      mapper->*(&DataSetMapperAccess::GeometryExtractor) = Filter::New();
      mapper->*(&DataSetMapperAccess::PolyDataMapper) = vtkPolyDataMapper::New();
    }
  }

  static vtkPolyData* Surface(vtkDataSetMapper* mapper)
  {
    Fill(mapper, &DataSetMapperAccess::GeometryExtractor);
    auto* filter = mapper->*(&DataSetMapperAccess::GeometryExtractor);
    vtkPolyDataMapper* inner = mapper->*(&DataSetMapperAccess::PolyDataMapper);
    filter->SetInputData(mapper->GetInput());
    inner->SetInputConnection(filter->GetOutputPort());
    filter->Update();
    return filter->GetOutput();
  }
};
}

bool GatherPolyData(vtkMapper* mapper, const GatherContext& context)
{
  UpdateInput(mapper);
  if (vtkPolyData* data = static_cast<vtkPolyDataMapper*>(mapper)->GetInput())
  {
    const ScalarColors& colors = MapScalarColors(context.Cache, mapper, data);
    context.Parts.push_back(PolyDataPart(context, mapper, data, colors));
  }
  return true;
}

bool GatherDataSet(vtkMapper* mapper, const GatherContext& context)
{
  UpdateInput(mapper);
  auto* source = static_cast<vtkDataSetMapper*>(mapper);
  vtkPolyData* data = vtkPolyData::SafeDownCast(source->GetInput());
  if (!data && source->GetInput())
  {
    data = DataSetMapperAccess::Surface(source);
  }
  if (data)
  {
    const ScalarColors& colors = MapScalarColors(context.Cache, mapper, data);
    context.Parts.push_back(PolyDataPart(context, mapper, data, colors));
  }
  return true;
}
}
