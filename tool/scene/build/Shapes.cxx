// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build/Shapes.h"

#include "common/Failure.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkDiskSource.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <algorithm>
#include <map>
#include <type_traits>

namespace penumbra::tool
{
namespace
{
using Geometry = vtkSmartPointer<vtkPolyData>;

template <typename Source>
Geometry Run(Source* source)
{
  source->Update();
  return source->GetOutput();
}

/// Rotates a shape about the origin from an axis to its normal, and moves it to its centre.
Geometry Place(Geometry geometry, const Primitive& shape, Vec3 axis)
{
  Vec3 normal = shape.Normal, about;
  vtkMath::Normalize(normal.data());
  vtkMath::Cross(axis.data(), normal.data(), about.data());
  const double cosine = vtkMath::Dot(axis.data(), normal.data());
  if (vtkMath::Norm(about.data()) < 1e-12)
  {
    // Parallel or opposite: half a turn about any perpendicular axis.
    about = { axis[1], axis[2], axis[0] };
  }
  vtkNew<vtkTransform> transform;
  transform->Translate(shape.Center.data());
  transform->RotateWXYZ(
    vtkMath::DegreesFromRadians(std::acos(std::clamp(cosine, -1.0, 1.0))), about.data());
  vtkNew<vtkTransformPolyDataFilter> placed;
  placed->SetInputData(geometry);
  placed->SetTransform(transform);
  return Run(placed.GetPointer());
}

Geometry MakeSphere(const Primitive& shape)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(shape.Center.data());
  source->SetRadius(shape.Radius);
  source->SetThetaResolution(shape.Resolution);
  source->SetPhiResolution(std::max(3, shape.Resolution / 2 + 1));
  return Run(source.GetPointer());
}

Geometry MakeBox(const Primitive& shape)
{
  vtkNew<vtkCubeSource> source;
  source->SetCenter(shape.Center.data());
  source->SetXLength(shape.Size[0]);
  source->SetYLength(shape.Size[1]);
  source->SetZLength(shape.Size[2]);
  return Run(source.GetPointer());
}

Geometry MakePlane(const Primitive& shape)
{
  const double x = shape.Size[0] / 2, y = shape.Size[1] / 2;
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-x, -y, 0);
  source->SetPoint1(x, -y, 0);
  source->SetPoint2(-x, y, 0);
  return Place(Run(source.GetPointer()), shape, { 0, 0, 1 });
}

Geometry MakeDisk(const Primitive& shape)
{
  vtkNew<vtkDiskSource> source;
  source->SetInnerRadius(shape.InnerRadius);
  source->SetOuterRadius(shape.Radius);
  source->SetCircumferentialResolution(shape.Resolution);
  return Place(Run(source.GetPointer()), shape, { 0, 0, 1 });
}

/// A cylinder or cone, which VTK makes about its own axis.
template <typename Source>
Geometry MakeUpright(const Primitive& shape)
{
  vtkNew<Source> source;
  source->SetRadius(shape.Radius);
  source->SetHeight(shape.Height);
  source->SetResolution(shape.Resolution);
  constexpr bool cone = std::is_same_v<Source, vtkConeSource>;
  return Place(Run(source.GetPointer()), shape, cone ? Vec3{ 1, 0, 0 } : Vec3{ 0, 1, 0 });
}

Geometry MakeTorus(const Primitive& shape)
{
  vtkNew<vtkParametricTorus> torus;
  torus->SetRingRadius(shape.Radius);
  torus->SetCrossSectionRadius(shape.InnerRadius > 0 ? shape.InnerRadius : shape.Radius / 3);
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  source->SetUResolution(shape.Resolution);
  source->SetVResolution(std::max(3, shape.Resolution / 2));
  return Place(Run(source.GetPointer()), shape, { 0, 0, 1 });
}

const std::map<std::string, Geometry (*)(const Primitive&)>& PrimitiveTable()
{
  static const std::map<std::string, Geometry (*)(const Primitive&)> table = {
    { "sphere", MakeSphere }, { "box", MakeBox }, { "plane", MakePlane }, { "disk", MakeDisk },
    { "cylinder", MakeUpright<vtkCylinderSource> }, { "cone", MakeUpright<vtkConeSource> },
    { "torus", MakeTorus }
  };
  return table;
}

vtkSmartPointer<vtkCellArray> MakeCells(const std::vector<std::vector<long long>>& cells,
  std::size_t points, std::size_t corners, const std::string& name)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& cell : cells)
  {
    if (cell.size() < corners)
    {
      FailUsage("{} has a cell of {} points: it needs at least {}", name, cell.size(), corners);
    }
    result->InsertNextCell(static_cast<int>(cell.size()));
    for (const long long id : cell)
    {
      if (id < 0 || static_cast<std::size_t>(id) >= points)
      {
        FailUsage("{} uses point {} but has points 0 to {} only", name, id,
          static_cast<long long>(points) - 1);
      }
      result->InsertCellPoint(id);
    }
  }
  return result;
}

void AddArrays(vtkFieldData* fields, const std::map<std::string, std::vector<double>>& arrays,
  vtkIdType tuples, const std::string& name)
{
  for (const auto& [key, values] : arrays)
  {
    if (tuples == 0 || values.empty() || values.size() % tuples != 0)
    {
      FailUsage("array '{}' of {} has {} values: it needs a multiple of {}", key, name,
        values.size(), tuples);
    }
    vtkNew<vtkDoubleArray> array;
    array->SetName(key.c_str());
    array->SetNumberOfComponents(static_cast<int>(values.size() / tuples));
    array->SetNumberOfTuples(tuples);
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    fields->AddArray(array);
  }
}

template <std::size_t N>
vtkSmartPointer<vtkFloatArray> PerPoint(const std::vector<std::array<double, N>>& values,
  std::size_t points, const char* what, const std::string& name)
{
  if (values.size() != points)
  {
    FailUsage(
      "{} has {} {} for {} points: give one for each point", name, values.size(), what, points);
  }
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(what);
  array->SetNumberOfComponents(N);
  for (const auto& value : values)
  {
    array->InsertNextTuple(value.data());
  }
  return array;
}
}

std::vector<std::string> PrimitiveKinds()
{
  std::vector<std::string> kinds;
  for (const auto& row : PrimitiveTable())
  {
    kinds.push_back(row.first);
  }
  return kinds;
}

vtkSmartPointer<vtkPolyData> MakePrimitive(const Primitive& shape)
{
  return PrimitiveTable().at(shape.Kind)(shape);
}

vtkSmartPointer<vtkPolyData> MakeMesh(const Mesh& mesh, const std::string& name)
{
  auto geometry = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& point : mesh.Points)
  {
    points->InsertNextPoint(point.data());
  }
  geometry->SetPoints(points);
  geometry->SetPolys(MakeCells(mesh.Polygons, mesh.Points.size(), 3, name));
  geometry->SetLines(MakeCells(mesh.Lines, mesh.Points.size(), 2, name));
  if (!mesh.Normals.empty())
  {
    geometry->GetPointData()->SetNormals(
      PerPoint(mesh.Normals, mesh.Points.size(), "normals", name));
  }
  if (!mesh.TextureCoordinates.empty())
  {
    geometry->GetPointData()->SetTCoords(
      PerPoint(mesh.TextureCoordinates, mesh.Points.size(), "texture coordinates", name));
  }
  AddArrays(geometry->GetPointData(), mesh.PointArrays, geometry->GetNumberOfPoints(), name);
  AddArrays(geometry->GetCellData(), mesh.CellArrays, geometry->GetNumberOfCells(), name);
  return geometry;
}
}
