// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/readers/CleanGeometry.h"

#include <vtkCellArray.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace penumbra::tool
{
namespace
{
/// Squares of larger coordinates overflow floats, and with them lengths and normals.
constexpr double LargestCoordinate = 1e18;

std::vector<char> FindUsable(vtkPoints* points)
{
  std::vector<char> usable(points ? points->GetNumberOfPoints() : 0);
  for (std::size_t i = 0; i < usable.size(); ++i)
  {
    double p[3];
    points->GetPoint(static_cast<vtkIdType>(i), p);
    // The comparison is also false for NaN.
    usable[i] = std::all_of(p, p + 3, [](double c) { return std::abs(c) < LargestCoordinate; });
  }
  return usable;
}

/// Cells with a point that is unusable or does not exist. Their ids count all four arrays in VTK's order.
std::vector<vtkIdType> FindBroken(vtkPolyData* geometry, const std::vector<char>& usable)
{
  const auto points = static_cast<vtkIdType>(usable.size());
  std::vector<vtkIdType> broken;
  vtkIdType id = 0;
  vtkNew<vtkIdList> ids;
  for (vtkCellArray* cells :
    { geometry->GetVerts(), geometry->GetLines(), geometry->GetPolys(), geometry->GetStrips() })
  {
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell, ++id)
    {
      cells->GetCellAtId(cell, ids);
      if (!std::all_of(ids->begin(), ids->end(),
            [&](vtkIdType i) { return i >= 0 && i < points && usable[i]; }))
      {
        broken.push_back(id);
      }
    }
  }
  return broken;
}
}

bool HasValidCells(vtkDataObject* data)
{
  const auto valid = [](vtkCellArray* cells) { return !cells || cells->IsValid(); };
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    return valid(surface->GetVerts()) && valid(surface->GetLines()) && valid(surface->GetPolys()) &&
      valid(surface->GetStrips());
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return valid(grid->GetCells());
  }
  bool all = true;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto iterator = vtk::TakeSmartPointer(composite->NewIterator());
    for (iterator->InitTraversal(); all && !iterator->IsDoneWithTraversal();
         iterator->GoToNextItem())
    {
      all = HasValidCells(iterator->GetCurrentDataObject());
    }
  }
  return all;
}

void DroppedPoints::Report(const std::string& what, Reporter& reporter) const
{
  if (this->Points + this->Cells > 0)
  {
    reporter.Note(
      fmt::format("{}: left out {} points that are not finite and {} cells that use such "
                  "points or ones that do not exist",
        what, this->Points, this->Cells));
  }
}

vtkSmartPointer<vtkPolyData> DropNonFinite(vtkPolyData* geometry, DroppedPoints& dropped)
{
  const std::vector<char> usable = FindUsable(geometry->GetPoints());
  const std::vector<vtkIdType> broken = FindBroken(geometry, usable);
  const auto bad = std::count(usable.begin(), usable.end(), 0);
  if (bad == 0 && broken.empty())
  {
    return geometry;
  }
  auto clean = vtkSmartPointer<vtkPolyData>::New();
  clean->ShallowCopy(geometry);
  clean->BuildCells();
  for (const vtkIdType cell : broken)
  {
    clean->DeleteCell(cell);
  }
  clean->RemoveDeletedCells();
  // Unusable points become unused copies of the first usable one, so that ids and arrays keep their order.
  vtkNew<vtkPoints> points;
  points->DeepCopy(geometry->GetPoints());
  const auto substitute = std::find(usable.begin(), usable.end(), 1);
  double p[3] = {};
  if (substitute != usable.end())
  {
    points->GetPoint(substitute - usable.begin(), p);
  }
  for (std::size_t i = 0; i < usable.size(); ++i)
  {
    if (!usable[i])
    {
      points->SetPoint(static_cast<vtkIdType>(i), p);
    }
  }
  clean->SetPoints(points);
  dropped.Points += bad;
  dropped.Cells += static_cast<vtkIdType>(broken.size());
  return clean;
}
}
