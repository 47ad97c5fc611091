// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build/Surfaces.h"

#include "common/Failure.h"
#include "common/Names.h"

#include <vtkCellDataToPointData.h>
#include <vtkContourFilter.h>
#include <vtkDataArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkPointData.h>
#include <vtkCellData.h>

#include <array>
#include <cmath>

namespace penumbra::tool
{
namespace
{
/// The array to contour: the requested one, the active scalars, or the first one with a single component.
vtkDataArray* ChooseArray(vtkDataSet* data, const Object& object)
{
  vtkPointData* fields = data->GetPointData();
  if (!object.IsoArray.empty())
  {
    vtkDataArray* array = fields->GetArray(object.IsoArray.c_str());
    if (!array)
    {
      FailUsage(
        "{}", UnknownName("point array", object.IsoArray, Describe(object), ArrayNames(fields)));
    }
    return array;
  }
  vtkDataArray* active = fields->GetScalars();
  for (int i = 0; !active && i < fields->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = fields->GetArray(i);
    active = array && array->GetNumberOfComponents() == 1 ? array : nullptr;
  }
  return active;
}

/// Averages cell values to points, where contouring needs them.
vtkSmartPointer<vtkDataSet> WithPointArrays(vtkDataSet* data)
{
  const bool onlyCells =
    data->GetPointData()->GetNumberOfArrays() == 0 && data->GetCellData()->GetNumberOfArrays() > 0;
  if (!onlyCells)
  {
    return data;
  }
  vtkNew<vtkCellDataToPointData> averaged;
  averaged->SetInputData(data);
  averaged->PassCellDataOn();
  averaged->Update();
  return averaged->GetOutput();
}

vtkSmartPointer<vtkDataSet> Smoothed(vtkImageData* image, double deviation, Step& step)
{
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputData(image);
  smooth->SetDimensionality(3);
  smooth->SetStandardDeviation(deviation);
  step.Observe(smooth);
  smooth->Update();
  return smooth->GetOutput();
}

vtkSmartPointer<vtkPolyData> Contour(
  vtkDataSet* data, const std::string& array, double value, Step& step)
{
  const auto run = [&](auto* filter) {
    filter->SetInputData(data);
    filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array.c_str());
    filter->SetValue(0, value);
    filter->ComputeNormalsOn();
    filter->ComputeScalarsOff();
    step.Observe(filter);
    filter->Update();
    return vtkSmartPointer<vtkPolyData>(filter->GetOutput());
  };
  if (vtkImageData::SafeDownCast(data))
  {
    vtkNew<vtkFlyingEdges3D> edges;
    edges->InterpolateAttributesOn();
    return run(edges.GetPointer());
  }
  vtkNew<vtkContourFilter> contour;
  return run(contour.GetPointer());
}

/// The value that best separates the finite values into two classes.
/// Otsu 1979, A Threshold Selection Method from Gray-Level Histograms.
double OtsuThreshold(vtkDataArray* values)
{
  double range[2];
  values->GetFiniteRange(range, 0);
  constexpr int bins = 256;
  std::array<double, bins> histogram{};
  const double width = (range[1] - range[0]) / bins;
  double total = 0, weighted = 0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    if (std::isfinite(value))
    {
      const int bin = std::min(bins - 1, static_cast<int>((value - range[0]) / width));
      histogram[bin] += 1;
      total += 1;
      weighted += bin;
    }
  }
  double below = 0, sumBelow = 0, best = -1;
  int threshold = 0;
  for (int bin = 0; bin < bins - 1; ++bin)
  {
    below += histogram[bin];
    sumBelow += bin * histogram[bin];
    const double above = total - below;
    if (below > 0 && above > 0)
    {
      const double apart = sumBelow / below - (weighted - sumBelow) / above;
      const double between = below * above * apart * apart;
      threshold = between > best ? bin : threshold;
      best = std::max(best, between);
    }
  }
  return range[0] + (threshold + 1) * width;
}

// Computed tomography has integer Hounsfield units: air is -1000, water 0, dense bone well over 1000.
bool IsInHounsfieldUnits(vtkDataArray* values, const double (&range)[2])
{
  const int type = values->GetDataType();
  return type != VTK_FLOAT && type != VTK_DOUBLE && range[0] <= -900.0 && range[1] >= 700.0;
}

// Otsu's threshold for CT lies just above air, and shows mainly the table and the blanket.
constexpr double BoneInHounsfieldUnits = 300.0;
}

std::vector<Part> MakeIsosurfaces(vtkDataSet* given, const Object& object, Reporter& reporter)
{
  vtkSmartPointer<vtkDataSet> data = WithPointArrays(given);
  vtkDataArray* array = ChooseArray(data, object);
  if (!array || array->GetNumberOfTuples() == 0)
  {
    Fail("{} has no values to make an isosurface of", Describe(object));
  }
  const std::string name = array->GetName() ? array->GetName() : "scalars";
  array->SetName(name.c_str());
  double range[2];
  array->GetFiniteRange(range, 0);
  if (!(range[0] < range[1]))
  {
    Fail("{} has no isosurface: every value of '{}' is {:g}", Describe(object), name, range[0]);
  }
  if (object.Smoothing > 0 && vtkImageData::SafeDownCast(data))
  {
    Step step(reporter, fmt::format("smoothing {}", Describe(object)));
    data->GetPointData()->SetActiveScalars(name.c_str());
    data = Smoothed(vtkImageData::SafeDownCast(data), object.Smoothing, step);
    array = data->GetPointData()->GetScalars();
    array->SetName(name.c_str());
  }
  std::vector<double> values = object.IsoValues;
  if (values.empty())
  {
    const bool bone = vtkImageData::SafeDownCast(data) && IsInHounsfieldUnits(array, range);
    values = { bone ? BoneInHounsfieldUnits : OtsuThreshold(array) };
    reporter.Note(
      fmt::format("isovalue {:g} of '{}' (range {:g} to {:g}{}) chosen for {}: give --isovalue "
                  "for another",
        values[0], name, range[0], range[1], bone ? ": bone, in Hounsfield units" : "",
        Describe(object)));
  }
  std::vector<Part> parts;
  for (double value : values)
  {
    if (!(value > range[0] && value < range[1]))
    {
      Fail("the isovalue {:g} is outside the range of '{}' in {}: choose between {:g} and {:g}",
        value, name, Describe(object), range[0], range[1]);
    }
    const std::string label = fmt::format("isosurface {:g} of {}", value, Describe(object));
    Step step(reporter, "making " + label);
    parts.push_back({ Contour(data, name, value, step), label });
  }
  return parts;
}
}
