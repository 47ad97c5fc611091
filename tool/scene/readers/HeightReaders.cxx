// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Elevations as images: USGS elevation files, NumPy arrays and pictures.
#include "common/Failure.h"
#include "scene/readers/Completeness.h"
#include "scene/readers/FormatReaders.h"
#include "scene/readers/NumpyFile.h"

#include "image/Picture.h"

#include <vtkDEMReader.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <cmath>

namespace penumbra::tool
{
namespace
{
/// northFirst: rows run from north to south. VTK's y axis points north.
LoadedData MakeHeights(const std::vector<double>& values, std::size_t columns, std::size_t rows,
  double dx, double dy, bool northFirst)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(columns), static_cast<int>(rows), 1);
  image->SetSpacing(dx, dy, 1);
  vtkNew<vtkFloatArray> heights;
  heights->SetName("elevation");
  heights->SetNumberOfTuples(static_cast<vtkIdType>(rows * columns));
  for (std::size_t row = 0; row < rows; ++row)
  {
    const std::size_t source = northFirst ? rows - 1 - row : row;
    for (std::size_t column = 0; column < columns; ++column)
    {
      heights->SetValue(static_cast<vtkIdType>(row * columns + column),
        static_cast<float>(values[source * columns + column]));
    }
  }
  image->GetPointData()->SetScalars(heights);
  LoadedData loaded;
  loaded.Kind = Content::Heights;
  loaded.Data = image.GetPointer();
  return loaded;
}

using Arrays = std::map<std::string, NumpyArray>;

const NumpyArray* FindArray(
  const Arrays& arrays, std::initializer_list<const char*> names, std::size_t axes)
{
  for (const char* name : names)
  {
    const auto found = arrays.find(name);
    if (found != arrays.end() && found->second.Shape.size() == axes &&
      !found->second.Values.empty())
    {
      return &found->second;
    }
  }
  return nullptr;
}

/// Coordinates of the samples along one axis, as far as the archive gives them.
struct Axis
{
  double Step = 1; ///< from sample to sample, negative if coordinates decrease
  double Middle = 0;
  bool Known = false;
};

Axis FindAxis(const Arrays& arrays, std::initializer_list<const char*> vectors,
  std::initializer_list<const char*> steps, std::initializer_list<const char*> starts)
{
  Axis axis;
  if (const NumpyArray* vector = FindArray(arrays, vectors, 1); vector && vector->Values.size() > 1)
  {
    axis.Step = (vector->Values.back() - vector->Values.front()) / (vector->Values.size() - 1);
    axis.Middle = (vector->Values.back() + vector->Values.front()) / 2;
    axis.Known = std::isfinite(axis.Step) && axis.Step != 0;
  }
  else if (const NumpyArray* step = FindArray(arrays, steps, 0))
  {
    const NumpyArray* start = FindArray(arrays, starts, 0);
    axis.Step = step->Values[0];
    axis.Middle = start ? start->Values[0] : 1e30; // without a start they are no degrees
    axis.Known = std::isfinite(axis.Step) && axis.Step != 0;
  }
  return axis;
}
}

LoadedData ReadDemHeights(const std::string& path, Step& step)
{
  RequireCompleteDem(path);
  vtkNew<vtkDEMReader> reader;
  reader->SetFileName(path.c_str());
  step.Observe(reader);
  reader->UpdateInformation();
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  // VTK's reader divides by a hundredth of the number of columns, rounded down.
  constexpr int fewest = 100;
  if (const int columns = extent[1] - extent[0] + 1; columns < fewest)
  {
    Fail("'{}' is damaged or has too few columns of elevations ({}, and VTK's reader needs {})",
      path, columns, fewest);
  }
  reader->Update();
  LoadedData loaded;
  loaded.Kind = Content::Heights;
  loaded.Data = reader->GetOutput();
  return loaded;
}

LoadedData ReadNumpyHeights(const std::string& path, Step& step)
{
  const Arrays arrays = ReadNumpyFile(path);
  const NumpyArray* heights = nullptr;
  for (const auto& [name, array] : arrays)
  {
    const bool larger = !heights || array.Values.size() > heights->Values.size();
    heights = array.Shape.size() == 2 && larger ? &array : heights;
  }
  if (!heights || heights->Shape[0] < 2 || heights->Shape[1] < 2)
  {
    Fail("'{}' holds no two-dimensional array of numbers for elevations", path);
  }
  Axis x = FindAxis(arrays, { "longitude", "lon", "x" }, { "dx" }, { "xmin", "x0" });
  Axis y = FindAxis(arrays, { "latitude", "lat", "y" }, { "dy" }, { "ymin", "y0" });
  // A vector of latitudes gives the order of rows. Otherwise images of land begin in the north.
  const bool northFirst = !(FindArray(arrays, { "latitude", "lat", "y" }, 1) && y.Step > 0);
  double dx = x.Known ? std::abs(x.Step) : 1;
  double dy = y.Known ? std::abs(y.Step) : dx;
  const bool degrees =
    x.Known && y.Known && dx < 1 && dy < 1 && std::abs(x.Middle) <= 360 && std::abs(y.Middle) <= 90;
  if (degrees)
  {
    constexpr double metresPerDegree = 111320; // of latitude; mean earth radius 6371 km
    dx *= metresPerDegree * std::cos(vtkMath::RadiansFromDegrees(y.Middle));
    dy *= metresPerDegree;
    step.Note(fmt::format(
      "'{}' has a sample spacing in degrees, which is {:.1f} by {:.1f} metres at latitude {:.1f}",
      path, dx, dy, y.Middle));
  }
  return MakeHeights(heights->Values, heights->Shape[1], heights->Shape[0], dx, dy, northFirst);
}

LoadedData ReadPictureHeights(const std::string& path, Step&)
{
  const Picture picture = ReadPicture(path);
  std::vector<double> heights(std::size_t(picture.Width) * picture.Height);
  // Heights are in steps of 8-bit pictures, the most common ones, so that relief is of the order of the width.
  constexpr double steps = 255;
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    heights[i] = steps * picture.Luminance(i);
  }
  if (picture.Width < 2 || picture.Height < 2)
  {
    Fail("'{}' has {} by {} pixels: a terrain needs at least 2 by 2", path, picture.Width,
      picture.Height);
  }
  return MakeHeights(heights, picture.Width, picture.Height, 1, 1, true);
}
}
