// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build/Surfaces.h"

#include "common/Failure.h"

#include <vtkDataArray.h>
#include <vtkExtractVOI.h>
#include <vtkImageData.h>
#include <vtkImageDataGeometryFilter.h>
#include <vtkPointData.h>
#include <vtkWarpScalar.h>

#include <algorithm>
#include <cmath>

namespace penumbra::tool
{
namespace
{
/// Relief relative to the width of the ground that is easy to see from above.
constexpr double PleasingRelief = 0.09;

vtkSmartPointer<vtkImageData> EveryNth(vtkImageData* image, int stride)
{
  vtkNew<vtkExtractVOI> extract;
  extract->SetInputData(image);
  int extent[6];
  image->GetExtent(extent);
  extract->SetVOI(extent);
  extract->SetSampleRate(stride, stride, 1);
  extract->Update();
  return extract->GetOutput();
}

bool AllFinite(vtkDataArray* heights)
{
  for (vtkIdType i = 0; i < heights->GetNumberOfTuples(); ++i)
  {
    if (!std::isfinite(heights->GetComponent(i, 0)))
    {
      return false;
    }
  }
  return true;
}
}

Part MakeTerrain(
  const LoadedData& loaded, const Object& object, const TriangleBudget& budget, Reporter& reporter)
{
  const Terrain settings = object.Heights.value_or(Terrain());
  Step step(reporter, fmt::format("raising terrain from {}", Describe(object)));
  auto image = vtkSmartPointer<vtkImageData>(vtkImageData::SafeDownCast(loaded.Data));
  int size[3];
  image->GetDimensions(size);
  vtkDataArray* heights = image->GetPointData()->GetScalars();
  if (!heights || size[0] < 2 || size[1] < 2 || size[2] != 1)
  {
    Fail("{} is no terrain: it needs one value for each point of a plane of at least 2 by 2",
      Describe(object));
  }
  if (settings.Stride > 1)
  {
    image = EveryNth(image, settings.Stride);
    heights = image->GetPointData()->GetScalars();
  }
  if (settings.Spacing)
  {
    image->SetSpacing(*settings.Spacing * settings.Stride, *settings.Spacing * settings.Stride, 1);
  }
  if (AllFinite(heights))
  {
    // Otherwise the remaining triangles are counted later.
    image->GetDimensions(size);
    budget.Require(2 * vtkIdType(size[0] - 1) * vtkIdType(size[1] - 1), Describe(object));
  }
  const std::string name = heights->GetName() ? heights->GetName() : "elevation";
  heights->SetName(name.c_str());
  double range[2], bounds[6];
  heights->GetFiniteRange(range, 0);
  image->GetBounds(bounds);
  const double width = std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  double exaggeration = settings.Exaggeration.value_or(1);
  if (!settings.Exaggeration && range[1] > range[0])
  {
    // Two digits are enough for a chosen value.
    const double wanted = PleasingRelief * width / (range[1] - range[0]);
    const double digit = std::pow(10, std::floor(std::log10(wanted)) - 1);
    exaggeration = std::round(wanted / digit) * digit;
    reporter.Note(
      fmt::format("heights of {} ({:g} to {:g}) are drawn times {:g}: give --exaggeration for "
                  "another",
        Describe(object), range[0], range[1], exaggeration));
  }
  vtkNew<vtkImageDataGeometryFilter> plane;
  plane->SetInputData(image);
  plane->OutputTrianglesOn();
  vtkNew<vtkWarpScalar> warp;
  warp->SetInputConnection(plane->GetOutputPort());
  warp->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name.c_str());
  warp->UseNormalOn();
  warp->SetNormal(0, 0, 1);
  warp->SetScaleFactor(exaggeration);
  step.Observe(warp);
  warp->Update();
  return { warp->GetPolyDataOutput(), Describe(object) };
}
}
