// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPoints.h>
#include <vtkSphereSource.h>

#include <cmath>
#include <vector>

namespace validate
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

Shape Make(const std::vector<std::array<double, 3>>& points,
  const std::vector<std::vector<vtkIdType>>& faces)
{
  vtkNew<vtkPoints> positions;
  positions->SetDataTypeToDouble();
  for (const auto& point : points)
  {
    positions->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& face : faces)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(face.size()), face.data());
  }
  Shape shape = Shape::New();
  shape->SetPoints(positions);
  shape->SetPolys(cells);
  return shape;
}
}

Shape Quad(const std::array<std::array<double, 3>, 4>& corners)
{
  return Make({ corners.begin(), corners.end() }, { { 0, 1, 2, 3 } });
}

Shape Floor(double xMin, double xMax, double yMin, double yMax, double z)
{
  return Quad({ { { { xMin, yMin, z } }, { { xMax, yMin, z } }, { { xMax, yMax, z } },
    { { xMin, yMax, z } } } });
}

Shape Ceiling(double xMin, double xMax, double yMin, double yMax, double z)
{
  return Quad({ { { { xMin, yMin, z } }, { { xMin, yMax, z } }, { { xMax, yMax, z } },
    { { xMax, yMin, z } } } });
}

Shape Box(const std::array<double, 3>& low, const std::array<double, 3>& high, double angle)
{
  std::vector<std::array<double, 3>> points;
  const double middle[2] = { 0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]) };
  const double c = std::cos(angle * Pi / 180.0);
  const double s = std::sin(angle * Pi / 180.0);
  for (int i = 0; i < 8; ++i)
  {
    const double x = (i & 1 ? high : low)[0] - middle[0];
    const double y = (i & 2 ? high : low)[1] - middle[1];
    points.push_back(
      { { middle[0] + c * x - s * y, middle[1] + s * x + c * y, (i & 4 ? high : low)[2] } });
  }
  return Make(points,
    { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
      { 1, 3, 7, 5 } });
}

Shape Disc(double radius, double z, bool frontUp)
{
  constexpr int corners = 720;
  std::vector<std::array<double, 3>> points = { { { 0.0, 0.0, z } } };
  std::vector<std::vector<vtkIdType>> faces;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * Pi * i / corners;
    points.push_back({ { radius * std::cos(angle), radius * std::sin(angle), z } });
    const vtkIdType a = 1 + i;
    const vtkIdType b = 1 + (i + 1) % corners;
    faces.push_back({ 0, frontUp ? a : b, frontUp ? b : a });
  }
  return Make(points, faces);
}

Shape Sphere(double radius, double z, double fromLatitude, double toLatitude)
{
  vtkNew<vtkSphereSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->SetRadius(radius);
  source->SetCenter(0.0, 0.0, z);
  source->SetThetaResolution(360);
  source->SetPhiResolution(180);
  source->SetStartPhi(fromLatitude);
  source->SetEndPhi(toLatitude);
  source->Update();
  return source->GetOutput();
}

Shape Torus(double ringRadius, double tubeRadius)
{
  vtkNew<vtkParametricTorus> torus;
  torus->SetRingRadius(ringRadius);
  torus->SetCrossSectionRadius(tubeRadius);
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  source->SetUResolution(360);
  source->SetVResolution(180);
  source->Update();
  return source->GetOutput();
}
}
