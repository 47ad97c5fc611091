// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneCost.h"

#include "Cost.h"
#include "LightmapScene.h"
#include "Picture.h"
#include "WhiteVolume.h"

#include "vtkGIProbeBaker.h"
#include "vtkGISHProbes.h"

#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkGlyph3DMapper.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace bench
{
namespace
{
using penumbra_test::CostRatio;
using penumbra_test::LightmapScene;
using penumbra_test::MedianOf;
using penumbra_test::MinimumOf;
using penumbra_test::SecondsOf;
using penumbra_test::Stage;

// Number of tries. Other programs make a cost look larger more often than smaller.
constexpr int Tries = 4;

void Draw(Stage& stage)
{
  stage.Window->Render();
  stage.Window->WaitForCompletion();
}

// Print the minimum of the tries' medians. Returns whether it keeps the limit.
template <typename With, typename Without>
bool Compare(const char* name, double limit, int turns, const With& with, const Without& without)
{
  with();
  const double ratio = MinimumOf(Tries, limit, [&] { return CostRatio(turns, with, without); });
  std::printf("%-48s %8.3f %8.2f%s\n", name, ratio, limit, ratio <= limit ? "" : "  exceeded");
  std::fflush(stdout);
  return ratio <= limit;
}

struct LightmapFrames : LightmapScene
{
  LightmapFrames()
  {
    this->Scene.Window->SetSize(1280, 720);
    this->UseShadowedLamp();
  }

  double SecondsOfNext(bool map)
  {
    this->Map->SetEnabled(map);
    this->Scene.Renderer->GetActiveCamera()->Azimuth(0.01); // so that no frame is an average
    return SecondsOf([this] { Draw(this->Scene); });
  }

  bool Report(const char* name, double limit, int turns)
  {
    return Compare(
      name, limit, turns, [this] { return this->SecondsOfNext(true); },
      [this] { return this->SecondsOfNext(false); });
  }
};

// A volume in a closed room of glowing walls, with a light of intensity zero.
struct VolumeFrames
{
  VolumeFrames()
  {
    this->Scene.Window->SetSize(120, 120);
    vtkRenderer* renderer = this->Scene.Renderer;
    renderer->AutomaticLightCreationOff();
    vtkNew<vtkLight> dark;
    dark->SetLightTypeToSceneLight();
    dark->SetIntensity(0.0);
    renderer->AddLight(dark);
    vtkNew<vtkCubeSource> cube;
    cube->SetBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
    vtkProperty* walls = this->Scene.Add(cube)->GetProperty();
    walls->SetColor(1.0, 1.0, 1.0);
    walls->SetDiffuse(0.5);
    walls->SetAmbient(0.25);
    walls->SetInterpolationToFlat();
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(0.0, -0.9, 0.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(75.0);
    camera->SetClippingRange(0.01, 20.0);
    this->Pass = this->Scene.SetPasses().front();
    this->Pass->KeepRadianceOn();
    this->Live = this->Pass->GetTechnique("ddgi");
    this->Live->SetParameter("probes", 64);
    this->Live->SetParameter("updates", 2);
    this->Baked = vtkGISHProbes::SafeDownCast(this->Pass->GetTechnique("sh-probes"));
    vtkNew<vtkGIProbeBaker> baker;
    baker->SetProbes(216);
    baker->SetSamples(1024);
    vtkNew<vtkImageData> field;
    if (!baker->Bake(renderer, field) || !this->Baked->SetBake(field))
    {
      throw std::runtime_error("the probes could not be baked.");
    }
    this->AddVolume(0.35);
  }

  void AddVolume(double radius)
  {
    vtkNew<vtkPiecewiseFunction> faint;
    faint->AddPoint(0.0, 0.0);
    faint->AddPoint(1.0, 0.05);
    this->Scene.Renderer->AddVolume(penumbra_test::WhiteVolume(
      radius, [](double distance) { return 1.0 - distance; }, faint));
  }

  // Median of three frames that are read back, after two for shaders to compile and probes to settle.
  double SecondsOfFrame(bool live, bool baked)
  {
    this->Live->SetEnabled(live);
    this->Baked->SetEnabled(baked);
    std::vector<double> seconds;
    for (int i = 0; i < 5; ++i)
    {
      const double measured = SecondsOf([this] { penumbra_test::Shoot(this->Scene.Window); });
      if (i >= 2)
      {
        seconds.push_back(measured);
      }
    }
    return MedianOf(seconds);
  }

  bool Report(const char* name, double limit, int turns, bool live)
  {
    return Compare(
      name, limit, turns, [=] { return this->SecondsOfFrame(live, !live); },
      [this] { return this->SecondsOfFrame(false, false); });
  }

  Stage Scene;
  vtkSmartPointer<vtkGIPass> Pass;
  vtkGITechnique* Live = nullptr;
  vtkGISHProbes* Baked = nullptr;
};

void PrintHeading(const char* text)
{
  std::printf("%-48s %8s %8s\n", text, "ratio", "at most");
}
}

bool ReportLightmapCost(int turns)
{
  PrintHeading("a frame with the map / without");
  LightmapFrames wall;
  wall.FillWithAWall();
  bool good = wall.Report("a picture full of one matte wall", 1.05, turns);
  LightmapFrames room;
  room.MoveIntoARoom();
  good &= room.Report("a closed room of PBR walls", 1.05, turns);
  LightmapFrames glow;
  glow.AddWall(1.9, 0.2)->GetProperty()->SetAmbient(1.0);
  glow.MoveIntoARoom();
  return glow.Report("the room, with a lamp in sight that glows", 1.07, turns) && good;
}

bool ReportVolumeCost(int turns)
{
  VolumeFrames frames;
  PrintHeading("a frame with indirect light / without");
  const bool live = frames.Report("a faint volume under DDGI", 4.0, turns, true);
  return frames.Report("a faint volume under baked probes", 6.0, turns, false) && live;
}

bool ReportGlyphCost()
{
  constexpr int across = 550;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> directions;
  directions->SetName("direction");
  directions->SetNumberOfComponents(3);
  for (int i = 0; i < across * across; ++i)
  {
    points->InsertNextPoint(i % across, i / across, 0.0);
    directions->InsertNextTuple3(std::cos(0.7 * i), std::sin(0.7 * i), 0.3);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->GetPointData()->AddArray(directions);
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(3);
  cone->SetRadius(0.4);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetSourceConnection(cone->GetOutputPort());
  mapper->SetScaleFactor(0.8);
  mapper->SetOrientationArray("direction");
  Stage stage;
  stage.Add(mapper);
  stage.Window->SetSize(16, 16);
  Stage::LookAround(stage.Renderer);
  const auto pass = stage.SetPasses().front();
  vtkGITechnique* paths = pass->GetTechnique("path-tracing");
  paths->SetParameter("bounces", 0);
  std::printf("%d glyphs, seconds\n", across * across);
  for (const char* frame : { "the rasterizer's first frame", "the path tracer's first frame",
         "the path tracer's second frame", "the path tracer's third frame" })
  {
    const auto begin = std::chrono::steady_clock::now();
    Draw(stage);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    std::printf("%-48s %8.3f\n", frame, elapsed.count());
    paths->EnabledOn();
  }
  return true;
}
}
