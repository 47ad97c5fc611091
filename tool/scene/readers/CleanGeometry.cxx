// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/readers/CleanGeometry.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace penumbra::tool
{
namespace
{
/// The square of a larger coordinate overflows a float, and with it lengths and normals.
constexpr double LargestCoordinate = 1e18;

std::vector<char> FindUsable(vtkPoints* points, vtkIdType& bad)
{
  const vtkIdType count = points ? points->GetNumberOfPoints() : 0;
  std::vector<char> usable(static_cast<std::size_t>(count), 1);
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    // The comparison is false for NaN too.
    const bool fine = std::abs(p[0]) < LargestCoordinate && std::abs(p[1]) < LargestCoordinate &&
      std::abs(p[2]) < LargestCoordinate;
    usable[i] = fine;
    bad += fine ? 0 : 1;
  }
  return usable;
}

/// Copies the cells whose points are usable; cell ids run over all four arrays in VTK's order.
vtkSmartPointer<vtkCellArray> Filter(vtkCellArray* cells, const std::vector<char>& usable,
  vtkIdType firstId, vtkCellData* from, vtkCellData* to, vtkIdType& written)
{
  auto kept = vtkSmartPointer<vtkCellArray>::New();
  const vtkIdType points = static_cast<vtkIdType>(usable.size());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cells && cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, ids);
    bool fine = true;
    for (vtkIdType i = 0; fine && i < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType id = ids->GetId(i);
      fine = id >= 0 && id < points && usable[id];
    }
    if (fine)
    {
      kept->InsertNextCell(ids);
      to->CopyData(from, firstId + cell, written++);
    }
  }
  return kept;
}

bool RefersOutside(vtkCellArray* cells, vtkIdType points)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cells && cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      if (ids->GetId(i) < 0 || ids->GetId(i) >= points)
      {
        return true;
      }
    }
  }
  return false;
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
  vtkIdType bad = 0;
  const std::vector<char> usable = FindUsable(geometry->GetPoints(), bad);
  vtkCellArray* groups[4] = { geometry->GetVerts(), geometry->GetLines(), geometry->GetPolys(),
    geometry->GetStrips() };
  bool outside = false;
  for (vtkCellArray* cells : groups)
  {
    outside = outside || RefersOutside(cells, geometry->GetNumberOfPoints());
  }
  if (bad == 0 && !outside)
  {
    return geometry;
  }
  auto clean = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(geometry->GetPoints()->GetDataType());
  clean->GetCellData()->CopyAllocate(geometry->GetCellData());
  // Unusable points stay as unused copies of the first usable one: ids and arrays keep their order.
  points->DeepCopy(geometry->GetPoints());
  vtkIdType stand = 0;
  while (stand + 1 < static_cast<vtkIdType>(usable.size()) && !usable[stand])
  {
    ++stand;
  }
  for (vtkIdType i = 0; i < static_cast<vtkIdType>(usable.size()); ++i)
  {
    if (!usable[i])
    {
      points->SetPoint(
        i, usable[stand] ? points->GetPoint(stand) : std::vector<double>(3, 0.0).data());
    }
  }
  clean->SetPoints(points);
  clean->GetPointData()->ShallowCopy(geometry->GetPointData());
  vtkIdType firstId = 0, written = 0;
  vtkSmartPointer<vtkCellArray> kept[4];
  for (int i = 0; i < 4; ++i)
  {
    kept[i] =
      Filter(groups[i], usable, firstId, geometry->GetCellData(), clean->GetCellData(), written);
    firstId += groups[i] ? groups[i]->GetNumberOfCells() : 0;
  }
  clean->SetVerts(kept[0]);
  clean->SetLines(kept[1]);
  clean->SetPolys(kept[2]);
  clean->SetStrips(kept[3]);
  dropped.Points += bad;
  dropped.Cells += firstId - written;
  return clean;
}
}
