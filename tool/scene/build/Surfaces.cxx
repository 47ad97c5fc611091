// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build/Surfaces.h"

#include "common/Failure.h"
#include "scene/build/Materials.h"
#include "scene/readers/CleanGeometry.h"

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkReverseSense.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

namespace penumbra::tool
{
namespace
{
/// Angle in degrees above which edges are sharp, on grids and meshes without normals.
constexpr double SharpEdge = 40;

vtkSmartPointer<vtkPolyData> OuterSurface(vtkDataSet* data, Step& step)
{
  if (auto* polygons = vtkPolyData::SafeDownCast(data))
  {
    return polygons;
  }
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(data);
  step.Observe(surface);
  surface->Update();
  return surface->GetOutput();
}

vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* geometry, const Object& object, Step& step)
{
  const bool hasOwn = geometry->GetPointData()->GetNormals() && !object.FeatureAngle;
  const bool flat = object.Appearance && object.Appearance->Shading == VTK_FLAT;
  const bool hasFaces = geometry->GetNumberOfPolys() + geometry->GetNumberOfStrips() > 0;
  if (hasOwn || flat || !hasFaces)
  {
    return geometry;
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(geometry);
  normals->SetFeatureAngle(object.FeatureAngle.value_or(SharpEdge));
  normals->SetSplitting(object.FeatureAngle.value_or(SharpEdge) < 180);
  step.Observe(normals);
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkPolyData> InWorld(vtkPolyData* geometry, vtkMatrix4x4* matrix)
{
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  vtkNew<vtkTransformPolyDataFilter> placed;
  placed->SetInputData(geometry);
  placed->SetTransform(transform);
  if (matrix->Determinant() > 0)
  {
    placed->Update();
    return placed->GetOutput();
  }
  // A reflection turns faces inside out.
  vtkNew<vtkReverseSense> turned;
  turned->SetInputConnection(placed->GetOutputPort());
  turned->ReverseCellsOn();
  turned->ReverseNormalsOff();
  turned->Update();
  return turned->GetOutput();
}

/// Merges points that a reader repeated, so that normals can be smooth across faces. Drops texture coordinates if there is
/// no texture.
vtkSmartPointer<vtkPolyData> Joined(vtkPolyData* geometry, const Object& object, Step& step)
{
  if (geometry->GetPointData()->GetNormals() ||
    (object.Appearance && HasTextures(*object.Appearance)))
  {
    return geometry;
  }
  vtkNew<vtkPolyData> bare;
  bare->ShallowCopy(geometry);
  bare->GetPointData()->SetTCoords(nullptr);
  vtkNew<vtkCleanPolyData> joined;
  joined->SetInputData(bare);
  joined->SetTolerance(0);
  step.Observe(joined);
  joined->Update();
  return joined->GetOutput();
}

bool IsVolume(vtkDataObject* data)
{
  auto* image = vtkImageData::SafeDownCast(data);
  return image && image->GetDataDimension() == 3;
}

void AddDataSet(std::vector<Part>& parts, vtkDataSet* data, const std::string& label,
  const Object& object, Reporter& reporter)
{
  if (!data || data->GetNumberOfPoints() == 0)
  {
    return;
  }
  const bool isosurfaces = IsVolume(data) || !object.IsoValues.empty();
  if (isosurfaces)
  {
    const std::vector<Part> made = MakeIsosurfaces(data, object, reporter);
    parts.insert(parts.end(), made.begin(), made.end());
    return;
  }
  Step step(reporter, fmt::format("extracting the surface of {}", label));
  parts.push_back({ OuterSurface(data, step), label });
}

std::vector<Part> PartsOfData(const LoadedData& loaded, const Object& object, Reporter& reporter)
{
  std::vector<Part> parts;
  auto* composite = vtkCompositeDataSet::SafeDownCast(loaded.Data);
  if (!composite)
  {
    AddDataSet(parts, vtkDataSet::SafeDownCast(loaded.Data), Describe(object), object, reporter);
    return parts;
  }
  auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    const char* name = leaves->HasCurrentMetaData()
      ? leaves->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
      : nullptr;
    const std::string label = fmt::format("{} of {}",
      name ? name : fmt::format("block {}", leaves->GetCurrentFlatIndex()), Describe(object));
    AddDataSet(
      parts, vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject()), label, object, reporter);
  }
  return parts;
}
}

std::vector<std::string> ArrayNames(vtkFieldData* fields)
{
  std::vector<std::string> names;
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    if (const char* name = fields->GetArray(i) ? fields->GetArray(i)->GetName() : nullptr)
    {
      names.emplace_back(name);
    }
  }
  return names;
}

std::string Describe(const Object& object)
{
  if (!object.Path.empty())
  {
    return fmt::format("'{}'", object.Path);
  }
  return object.Name.empty() ? "an object of the scene" : fmt::format("object '{}'", object.Name);
}

std::vector<Part> MakeParts(
  const LoadedData& loaded, const Object& object, const TriangleBudget& budget, Reporter& reporter)
{
  const auto* image = vtkImageData::SafeDownCast(loaded.Data);
  const bool terrain = image && (loaded.Kind == Content::Heights || object.Heights);
  std::vector<Part> parts = terrain
    ? std::vector<Part>{ MakeTerrain(loaded, object, budget, reporter) }
    : PartsOfData(loaded, object, reporter);
  std::vector<Part> visible;
  DroppedPoints dropped;
  vtkIdType triangles = 0;
  for (Part& part : parts)
  {
    Step step(reporter, fmt::format("preparing {}", part.Label));
    part.Geometry = DropNonFinite(part.Geometry, dropped);
    triangles += CountTriangles(part.Geometry);
    budget.Require(triangles, Describe(object));
    part.Geometry = loaded.PointsRepeated ? Joined(part.Geometry, object, step) : part.Geometry;
    part.Geometry = WithNormals(part.Geometry, object, step);
    if (loaded.ToWorld)
    {
      part.Geometry = InWorld(part.Geometry, loaded.ToWorld);
    }
    if (part.Geometry->GetNumberOfCells() > 0 ||
      (object.PointsAsBalls && part.Geometry->GetNumberOfPoints() > 0))
    {
      visible.push_back(part);
    }
  }
  if (!visible.empty())
  {
    dropped.Report(Describe(object), reporter);
    return visible;
  }
  vtkIdType points = 0;
  for (const Part& part : parts)
  {
    points += part.Geometry->GetNumberOfPoints();
  }
  if (dropped.Points + dropped.Cells > 0)
  {
    Fail("{} has nothing to draw: all its cells use points that are not finite or do not exist",
      Describe(object));
  }
  if (points > 0)
  {
    Fail(
      "{} has {} points but no triangles, lines or other cells: give --points to draw the points "
      "as balls",
      Describe(object), points);
  }
  Fail("{} is an empty dataset: there is nothing to draw", Describe(object));
}

vtkIdType CountTriangles(vtkPolyData* geometry)
{
  // A polygon or strip of n corners has n - 2 triangles.
  const auto count = [](vtkCellArray* cells) {
    return cells ? cells->GetNumberOfConnectivityIds() - 2 * cells->GetNumberOfCells() : 0;
  };
  return count(geometry->GetPolys()) + count(geometry->GetStrips());
}
}
