// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/readers/StandingAxis.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <cmath>

namespace penumbra::tool
{
namespace
{
// A terrain covers the rectangle around it, apart from a border or holes.
constexpr double LeastCover = 0.75;
constexpr double LeastRelief = 0.01; // of its width; a flat plate is looked at from the front

/// Sum of the faces' normals times their areas. It is zero for a closed surface, and the area of the ground for a surface
/// that covers it once.
Vec3 VectorArea(vtkPolyData* polygons)
{
  Vec3 sum = { 0, 0, 0 };
  auto faces = vtk::TakeSmartPointer(polygons->GetPolys()->NewIterator());
  for (faces->GoToFirstCell(); !faces->IsDoneWithTraversal(); faces->GoToNextCell())
  {
    vtkIdType count;
    const vtkIdType* corners;
    faces->GetCurrentCell(count, corners);
    for (vtkIdType i = 2; i < count; ++i)
    {
      Vec3 a, b, c, normal;
      polygons->GetPoint(corners[0], a.data());
      polygons->GetPoint(corners[i - 1], b.data());
      polygons->GetPoint(corners[i], c.data());
      vtkMath::Subtract(b.data(), a.data(), b.data());
      vtkMath::Subtract(c.data(), a.data(), c.data());
      vtkMath::Cross(b.data(), c.data(), normal.data());
      if (std::isfinite(vtkMath::Norm(normal.data())))
      {
        vtkMath::MultiplyScalar(normal.data(), 0.5);
        vtkMath::Add(sum.data(), normal.data(), sum.data());
      }
    }
  }
  return sum;
}

/// Whether arrays hold numbers that are not part of a shape: neither normals nor texture coordinates nor colours.
bool HoldsResults(vtkDataSetAttributes* fields)
{
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = fields->GetArray(i);
    const int use = fields->IsArrayAnAttribute(i);
    const bool shape = use == vtkDataSetAttributes::NORMALS ||
      use == vtkDataSetAttributes::TCOORDS || use == vtkDataSetAttributes::TANGENTS;
    const bool colors = array && array->GetDataType() == VTK_UNSIGNED_CHAR;
    if (array && !shape && !colors)
    {
      return true;
    }
  }
  return false;
}
}

Standing FindStanding(vtkPolyData* polygons, const DefaultView& usual, bool vtkFormat)
{
  double bounds[6];
  polygons->GetBounds(bounds);
  const double size[3] = { bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] };
  const Vec3 area = VectorArea(polygons);
  const auto covers = [&](int axis) {
    const double ground = size[(axis + 1) % 3] * size[(axis + 2) % 3];
    return ground > 0 && std::abs(area[axis]) >= LeastCover * ground &&
      size[axis] < std::sqrt(ground) && size[axis] > LeastRelief * std::sqrt(ground);
  };
  if (covers(2))
  {
    return { LandView, "it covers its ground once, as a terrain does" };
  }
  if (covers(1))
  {
    DefaultView land = ModelView;
    land.Azimuth = LandView.Azimuth;
    land.Elevation = LandView.Elevation;
    return { land, "it covers its ground once, as a terrain does" };
  }
  const bool results =
    HoldsResults(polygons->GetPointData()) || HoldsResults(polygons->GetCellData());
  if (vtkFormat && results)
  {
    return { SimulationView, "it has arrays, as results of simulations do" };
  }
  return { usual, nullptr };
}
}
