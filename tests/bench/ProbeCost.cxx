// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ProbeCost.h"

#include "CostPlot.h"
#include "Cost.h"

#include "vtkGIDDGI.h"
#include "vtkGIPass.h"
#include "vtkHeadlessRenderWindow.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace bench
{
namespace
{
constexpr int Probes = 1024, Rays = 128; // the defaults
// Minimum of updates and of seconds before the measurement, for shaders to compile, probes' distances to settle and
// GPUs to raise their clock rates.
constexpr int WarmUpdates = 10;
constexpr double WarmSeconds = 0.5;
// Factor that the cost per ray may grow by, because of noise.
constexpr double Noise = 1.25;
constexpr double White[3] = { 0.73, 0.73, 0.73 };

struct Update
{
  int Probes;
  vtkIdType Triangles; // of the ball
  double Milliseconds; // median
};

vtkSmartPointer<vtkActor> AddActor(
  vtkRenderer* renderer, vtkPolyDataAlgorithm* source, const double (&color)[3])
{
  source->Update();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(source->GetOutput());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetInterpolationToFlat();
  renderer->AddActor(actor);
  return actor;
}

void AddWall(vtkRenderer* renderer, const double (&origin)[3], const double (&one)[3],
  const double (&other)[3], const double (&color)[3])
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(origin[0], origin[1], origin[2]);
  plane->SetPoint1(one[0], one[1], one[2]);
  plane->SetPoint2(other[0], other[1], other[2]);
  AddActor(renderer, plane, color);
}

void AddBox(
  vtkRenderer* renderer, double width, double height, const double (&position)[2], double angle)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(-width / 2, width / 2, -width / 2, width / 2, 0.0, height);
  const auto actor = AddActor(renderer, cube, White);
  actor->SetPosition(position[0], position[1], 0.0);
  actor->SetOrientation(0.0, 0.0, angle);
}

// Add a room from 0 to 1 along each axis, open at y = 0.
void AddRoom(vtkRenderer* renderer)
{
  AddWall(renderer, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, White);
  AddWall(renderer, { 0, 0, 1 }, { 0, 1, 1 }, { 1, 0, 1 }, White);
  AddWall(renderer, { 0, 1, 0 }, { 1, 1, 0 }, { 0, 1, 1 }, White);
  AddWall(renderer, { 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.65, 0.05, 0.05 });
  AddWall(renderer, { 1, 0, 0 }, { 1, 0, 1 }, { 1, 1, 0 }, { 0.12, 0.45, 0.15 });
  AddBox(renderer, 0.3, 0.6, { 0.33, 0.68 }, 20.0);
  AddBox(renderer, 0.28, 0.28, { 0.65, 0.3 }, 0.0);
}

vtkIdType AddBall(vtkRenderer* renderer, double triangles)
{
  const int resolution = static_cast<int>(std::lround(0.5 + std::sqrt(0.25 + 0.5 * triangles)));
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.25);
  ball->SetCenter(0.5, 0.5, 0.4);
  ball->SetThetaResolution(resolution);
  ball->SetPhiResolution(resolution);
  AddActor(renderer, ball, White);
  return ball->GetOutput()->GetNumberOfPolys();
}

vtkSmartPointer<vtkLight> AddLamp(vtkRenderer* renderer)
{
  auto lamp = vtkSmartPointer<vtkLight>::New();
  lamp->SetLightTypeToSceneLight();
  lamp->PositionalOn();
  lamp->SetConeAngle(180.0);
  renderer->AddLight(lamp);
  return lamp;
}

double MillisecondsOfUpdate(vtkGIPass* pass)
{
  const auto statistics = nlohmann::json::parse(pass->GetStatistics());
  double milliseconds = 0.0;
  for (const auto& row : statistics.at("passes"))
  {
    const std::string name = row.at("name");
    const bool ofUpdate =
      name.compare(0, 5, "ddgi-") == 0 && name.compare(0, 10, "ddgi-balls") != 0;
    milliseconds += ofUpdate ? row.at("milliseconds").get<double>() : 0.0;
  }
  return milliseconds;
}

Update MeasureUpdate(int updates, int probes, int rays, double triangles)
{
  vtkNew<vtkRenderer> renderer;
  AddRoom(renderer);
  const vtkIdType ballTriangles = triangles > 0.0 ? AddBall(renderer, triangles) : 0;
  const auto lamp = AddLamp(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.5, -1.4, 0.5);
  camera->SetFocalPoint(0.5, 0.5, 0.5);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(40.0);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkGIPass> pass;
  auto* ddgi = vtkGIDDGI::SafeDownCast(pass->GetTechnique("ddgi"));
  ddgi->EnabledOn();
  ddgi->SetParameter("probes", probes);
  ddgi->SetParameter("rays", rays);
  pass->CollectStatisticsOn();
  renderer->SetPass(pass);
  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetSize(64, 64);
  window->SetMultiSamples(0);
  window->AddRenderer(renderer);
  int update = 0;
  const auto measureNext = [&] {
    const double angle = 0.02 * update++;
    lamp->SetPosition(0.5 + 0.3 * std::cos(angle), 0.5 + 0.3 * std::sin(angle), 0.8);
    window->Render();
    return MillisecondsOfUpdate(pass);
  };
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  while (update < WarmUpdates ||
    std::chrono::duration<double>(Clock::now() - begin).count() < WarmSeconds)
  {
    measureNext();
  }
  std::vector<double> times;
  for (int i = 0; i < updates; ++i)
  {
    times.push_back(measureNext());
  }
  int counts[3];
  ddgi->GetGrid(renderer, counts);
  return { counts[0] * counts[1] * counts[2], ballTriangles, penumbra_test::MedianOf(times) };
}

struct RayCosts
{
  std::vector<double> Nanoseconds; // per ray
  double DefaultUpdate = 0.0;      // milliseconds
};

RayCosts ReportByRays(int updates)
{
  std::printf("\n%8s %6s %9s %9s\n", "probes", "rays", "ms", "ns/ray");
  RayCosts costs;
  for (const auto& [probes, rays] : { std::pair<int, int>{ Probes / 2, Rays }, { Probes, Rays / 2 },
         { Probes, Rays }, { 2 * Probes, Rays } })
  {
    const Update update = MeasureUpdate(updates, probes, rays, 0.0);
    costs.Nanoseconds.push_back(
      1e6 * update.Milliseconds / (static_cast<double>(update.Probes) * rays));
    if (probes == Probes && rays == Rays)
    {
      costs.DefaultUpdate = update.Milliseconds;
    }
    std::printf(
      "%8d %6d %9.3f %9.2f\n", update.Probes, rays, update.Milliseconds, costs.Nanoseconds.back());
    std::fflush(stdout);
  }
  return costs;
}

std::vector<CostPoint> ReportByTriangles(int updates, double most)
{
  std::printf("\n%9s %9s\n", "triangles", "ms");
  std::vector<CostPoint> points;
  for (double size = LeastTriangles;; size = std::min(10.0 * size, most))
  {
    const Update update = MeasureUpdate(updates, Probes, Rays, size);
    points.push_back({ static_cast<double>(update.Triangles), update.Milliseconds });
    std::printf("%9.0f %9.3f\n", points.back().Triangles, points.back().Milliseconds);
    std::fflush(stdout);
    if (size >= most)
    {
      return points;
    }
  }
}
}

bool ReportProbeCost(const ProbeCostOptions& options)
{
  if (!options.Plot.empty() && !std::ofstream(options.Plot, std::ios::app))
  {
    throw std::runtime_error(options.Plot + " cannot be written.");
  }
  vtkNew<vtkHeadlessRenderWindow> window;
  window->Render();
  if (!window->GetDescription()[0])
  {
    throw std::runtime_error("no OpenGL context could be created.");
  }
  std::printf("%s; medians of %d updates\n", window->GetDescription(), options.Updates);
  const RayCosts rays = ReportByRays(options.Updates);
  const std::vector<CostPoint> points = ReportByTriangles(options.Updates, options.Most);
  if (!options.Plot.empty())
  {
    PlotCost(points, options.Plot);
  }

  std::printf("\nthe default update: %.3f ms\n", rays.DefaultUpdate);
  bool good = true;
  if (options.Limit > 0.0 && rays.DefaultUpdate > options.Limit)
  {
    std::printf("More than %g ms.\n", options.Limit);
    good = false;
  }
  double minimum = rays.Nanoseconds.front();
  for (const double each : rays.Nanoseconds)
  {
    if (each > Noise * minimum)
    {
      std::printf(
        "A ray costs %.2f ns, but %.2f with fewer rays: the cost grows faster than linearly.\n",
        each, minimum);
      good = false;
    }
    minimum = std::min(minimum, each);
  }
  const double growth = points.back().Milliseconds / points.front().Milliseconds;
  const double logarithmic = std::log(points.back().Triangles) / std::log(points.front().Triangles);
  if (growth > std::max(1.1, logarithmic))
  {
    std::printf("%.0f times the triangles cost %.2f times as much: the cost grows faster than "
                "their logarithm.\n",
      points.back().Triangles / points.front().Triangles, growth);
    good = false;
  }
  return good;
}
}
