// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RayScenes.h"

#include "vtkCell.h"
#include "vtkContourFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRTAnalyticSource.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <limits>

using penumbra::RayGeometry;

namespace penumbra_test
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

void AddSphere(RayGeometry& geometry, const glm::dvec3& center, double radius, int rings)
{
  const auto base = static_cast<unsigned int>(geometry.Points.size());
  const int sectors = 2 * rings;
  // One point at each pole, so that the closed surface shares every edge.
  geometry.Points.emplace_back(center + glm::dvec3(0, 0, radius));
  for (int j = 1; j < rings; ++j)
  {
    for (int i = 0; i < sectors; ++i)
    {
      const double theta = Pi * j / rings;
      const double phi = 2.0 * Pi * i / sectors;
      geometry.Points.emplace_back(center +
        radius *
          glm::dvec3(
            std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)));
    }
  }
  geometry.Points.emplace_back(center - glm::dvec3(0, 0, radius));
  const auto last = static_cast<unsigned int>(geometry.Points.size() - 1);
  for (int i = 0; i < sectors; ++i)
  {
    const int next = (i + 1) % sectors;
    geometry.Triangles.emplace_back(base, base + 1 + i, base + 1 + next);
    const unsigned int bottom = base + 1 + (rings - 2) * sectors;
    geometry.Triangles.emplace_back(last, bottom + next, bottom + i);
    for (int j = 0; j < rings - 2; ++j)
    {
      const unsigned int a = base + 1 + j * sectors;
      geometry.Triangles.emplace_back(a + i, a + sectors + i, a + next);
      geometry.Triangles.emplace_back(a + next, a + sectors + i, a + sectors + next);
    }
  }
}
}

void RayWorld::Measure()
{
  glm::dvec3 lower(HUGE_VAL);
  glm::dvec3 upper(-HUGE_VAL);
  for (const Placement& placement : this->Instances)
  {
    const RayGeometry& mesh = this->Meshes[placement.Mesh];
    for (const glm::vec3& point : mesh.Points)
    {
      const glm::dvec3 position(
        placement.MeshToWorld * glm::dvec4(mesh.Origin + glm::dvec3(point), 1.0));
      if (std::isfinite(position.x + position.y + position.z))
      {
        lower = glm::min(lower, position);
        upper = glm::max(upper, position);
      }
    }
  }
  this->Center = 0.5 * (lower + upper);
  this->Radius = 0.5 * glm::length(upper - lower);
}

RayGeometry SphereField(int spheres, int rings, unsigned int seed)
{
  RayGeometry geometry;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < spheres; ++i)
  {
    const double x = unit(random), y = unit(random), z = unit(random);
    AddSphere(geometry, 10.0 * glm::dvec3(x, y, z), 0.3 + 0.5 * unit(random), rings);
  }
  return geometry;
}

RayGeometry ClosedSphere(int rings)
{
  RayGeometry geometry;
  AddSphere(geometry, glm::dvec3(0.0), 1.0, rings);
  return geometry;
}

RayGeometry Slivers(int count)
{
  RayGeometry geometry;
  std::mt19937 random(2);
  std::normal_distribution<float> normal;
  auto vector = [&] {
    const float x = normal(random), y = normal(random);
    return glm::vec3(x, y, normal(random));
  };
  for (int i = 0; i < count; ++i)
  {
    const glm::vec3 a = vector();
    const glm::vec3 along = glm::normalize(vector());
    const glm::vec3 side = glm::normalize(glm::cross(along, vector()));
    const float thin = std::pow(10.0f, -3.0f - 3.0f * static_cast<float>(i % 100) / 100.0f);
    const auto base = static_cast<unsigned int>(geometry.Points.size());
    geometry.Points.push_back(a);
    geometry.Points.push_back(a + along);
    geometry.Points.push_back(a + 0.5f * along + thin * side);
    geometry.Triangles.emplace_back(base, base + 1, base + 2);
  }
  return geometry;
}

RayGeometry Degenerate(int spheres)
{
  RayGeometry geometry = SphereField(spheres, 12, 3);
  const std::size_t good = geometry.Triangles.size();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < good; i += 3)
  {
    const glm::uvec3 corners = geometry.Triangles[i];
    const auto base = static_cast<unsigned int>(geometry.Points.size());
    switch (i / 3 % 6)
    {
      case 0: // a point
        geometry.Triangles.emplace_back(corners.x, corners.x, corners.x);
        break;
      case 1: // a line
        geometry.Triangles.emplace_back(corners.x, corners.y, corners.y);
        break;
      case 2: // a duplicate: a tie everywhere
        geometry.Triangles.push_back(corners);
        break;
      case 3:
        geometry.Points.emplace_back(nan, 0.0f, 0.0f);
        geometry.Triangles.emplace_back(corners.x, corners.y, base);
        break;
      case 4:
        geometry.Points.emplace_back(0.0f, infinite, 0.0f);
        geometry.Triangles.emplace_back(corners.x, base, corners.z);
        break;
      default: // a point that does not exist
        geometry.Triangles.emplace_back(corners.x, corners.y, 4000000000u);
        break;
    }
  }
  // Many at one position, which no split can separate.
  for (int i = 0; i < 1000; ++i)
  {
    geometry.Triangles.push_back(geometry.Triangles[0]);
  }
  return geometry;
}

RayGeometry FromPolyData(vtkPolyData* data)
{
  RayGeometry geometry;
  std::vector<glm::dvec3> points(data->GetNumberOfPoints());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(i), &points[i].x);
  }
  geometry.SetPoints(points);
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    vtkCell* cell = data->GetCell(i);
    for (vtkIdType j = 2; j < cell->GetNumberOfPoints(); ++j)
    {
      geometry.Triangles.emplace_back(
        cell->GetPointId(0), cell->GetPointId(j - 1), cell->GetPointId(j));
    }
  }
  return geometry;
}

RayGeometry Isosurface(int resolution)
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  const int half = resolution / 2;
  wavelet->SetWholeExtent(-half, half, -half, half, -half, half);
  wavelet->SetXFreq(60.0 * 20 / resolution);
  wavelet->SetYFreq(30.0 * 20 / resolution);
  wavelet->SetZFreq(40.0 * 20 / resolution);
  vtkNew<vtkContourFilter> contour;
  contour->SetInputConnection(wavelet->GetOutputPort());
  contour->SetValue(0, 130.0);
  contour->SetValue(1, 170.0);
  contour->ComputeNormalsOff();
  contour->Update();
  return FromPolyData(contour->GetOutput());
}

RayWorld Single(const std::string& name, RayGeometry geometry)
{
  RayWorld world;
  world.Name = name;
  world.Meshes.push_back(std::move(geometry));
  world.Instances.push_back({ 0, glm::dmat4(1.0) });
  world.Measure();
  return world;
}

RayWorld FarAway()
{
  const RayGeometry field = SphereField(60, 16, 4);
  std::vector<glm::dvec3> points;
  for (const glm::vec3& point : field.Points)
  {
    points.push_back(glm::dvec3(1e6, -1e6, 1e6) + 0.1 * glm::dvec3(point));
  }
  RayGeometry moved;
  moved.SetPoints(points);
  moved.Triangles = field.Triangles;
  return Single("coordinates near 1e6", std::move(moved));
}

RayWorld Scattered(const std::string& name, RayGeometry mesh, int count)
{
  RayWorld world;
  world.Name = name;
  world.Meshes.push_back(std::move(mesh));
  world.Meshes.push_back(Slivers(50));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double side = std::cbrt(static_cast<double>(count));
  for (int i = 0; i < count; ++i)
  {
    const double x = unit(random), y = unit(random), z = unit(random);
    glm::dmat4 matrix = glm::translate(glm::dmat4(1.0), 2.0 * side * glm::dvec3(x, y, z));
    matrix = glm::rotate(matrix, 6.0 * unit(random), glm::dvec3(x, 1.0 - y, z));
    const double stretch = 0.2 + unit(random);
    matrix = glm::scale(matrix, glm::dvec3(stretch, 0.3, i % 7 == 0 ? -0.5 : 0.5));
    world.Instances.push_back({ i % 10 == 0 ? std::size_t(1) : std::size_t(0), matrix });
  }
  world.Measure();
  return world;
}

RayWorld Glyphs(int count)
{
  return Scattered("instanced glyphs", ClosedSphere(12), count);
}

std::vector<RayWorld> AllWorlds()
{
  std::vector<RayWorld> worlds;
  worlds.push_back(Single("sphere field", SphereField(160, 18)));
  worlds.push_back(Single("thin slivers", Slivers(20000)));
  worlds.push_back(FarAway());
  worlds.push_back(Single("degenerate input", Degenerate(60)));
  worlds.push_back(Glyphs(1000));
  worlds.push_back(Single("isosurface", Isosurface(60)));
  worlds.push_back(Scattered("deep trees", SphereField(160, 18), 4000));
  return worlds;
}
}
