// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Accumulation over frames: noise falls in scenes at rest, and no ghosts remain.
#include "Picture.h"
#include "Studio.h"

#include <vtkActor2D.h>
#include <vtkActorCollection.h>
#include <vtkMath.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper2D.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <utility>

using namespace penumbra_test;

namespace
{
// Share of the difference between two pictures that remains in a third one. Noise has no part in it.
double RemainingShare(const Values& with, const Values& without, const Values& current)
{
  double shared = 0.0;
  double whole = 0.0;
  for (std::size_t i = 0; i < current.size(); ++i)
  {
    const double pattern = with[i] - without[i];
    shared += (current[i] - without[i]) * pattern;
    whole += pattern * pattern;
  }
  return shared / whole;
}

// Slope of a line through points on logarithmic axes.
double Slope(const std::vector<std::pair<double, double>>& points)
{
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const auto& point : points)
  {
    const double a = std::log(point.first);
    const double b = std::log(point.second);
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  const double n = static_cast<double>(points.size());
  return (n * xy - x * y) / (n * xx - x * x);
}
}

TEST(TemporalAccumulation, ErrorAtRestFallsWithTheSquareRoot)
{
  // The reference is the mean of frames with other noise than the measured ones.
  constexpr int others = 256;
  Studio reference(false);
  Values expected = reference.Frames(64);
  std::fill(expected.begin(), expected.end(), 0.0);
  for (int frame = 0; frame < others; ++frame)
  {
    const Values values = reference.Frame();
    std::transform(values.begin(), values.end(), expected.begin(), expected.begin(),
      [](double value, double sum) { return sum + value / others; });
  }
  Studio studio(true);
  std::vector<std::pair<double, double>> points;
  for (int frame = 1; frame <= 64; ++frame)
  {
    const double error = Error(studio.Frame(), expected);
    if ((frame & (frame - 1)) == 0)
    {
      points.emplace_back(frame, error);
      std::printf("still frame %2d: rms error %.3f / 255\n", frame, error);
    }
  }
  const double slope = Slope(points);
  std::printf("slope %.3f\n", slope);
  EXPECT_LE(slope, -0.48);
  EXPECT_LT(points.back().second, 0.24);
}

// Ridges narrower than a pixel, under a low sun: slopes that face it are bright, and half of each is in shadow. The product of a
// pixel's mean shadow and mean brightness is not the mean of their product.
TEST(TemporalAccumulation, AveragedStillFramesAverageProductsWithinAPixel)
{
  constexpr int ridges = 60;
  const double height = std::tan(vtkMath::RadiansFromDegrees(9.0)) / 2.0;
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetPoint1(ridges, 0.0, 0.0);
  plane->SetPoint2(0.0, ridges, 0.0);
  plane->SetResolution(2 * ridges, 1);
  plane->Update();
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(plane->GetOutput()->GetPoints());
  surface->SetPolys(plane->GetOutput()->GetPolys());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double at[3];
    surface->GetPoint(i, at);
    at[2] = i % (2 * ridges + 1) % 2 != 0 ? height : 0.0;
    surface->GetPoints()->SetPoint(i, at);
  }
  std::array<double, 2> means{};
  for (const bool accumulates : { false, true })
  {
    Studio studio(accumulates, 1, 60);
    vtkRenderer* renderer = studio.Scene.Renderer;
    renderer->RemoveAllViewProps();
    studio.Scene.Add(surface)->GetProperty()->SetInterpolationToFlat();
    studio.Occlusion->EnabledOff();
    studio.Shadows->SetParameter("light-angle", 0.0);
    studio.Sun->SetPosition(1.0, 0.0, std::tan(vtkMath::RadiansFromDegrees(5.0)));
    studio.Pass->GetTechnique("anti-aliasing")->EnabledOn();
    studio.Pass->GetTechnique("anti-aliasing")->SetParameterFromText("mode", "accumulate");
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.3 * ridges);
    camera->SetFocalPoint(0.5 * ridges, 0.5 * ridges, 0.0);
    camera->SetPosition(0.5 * ridges, 0.5 * ridges, ridges);
    camera->SetViewUp(0.0, 1.0, 0.0);
    renderer->ResetCameraClippingRange();
    const Values values = studio.Frames(64);
    means[accumulates] = std::accumulate(values.begin(), values.end(), 0.0) / values.size();
  }
  std::printf("ridges: mean %.3f / 255, accumulated %.3f\n", means[0], means[1]);
  EXPECT_GT(means[0], 1.0);
  EXPECT_NEAR(means[1], means[0], 0.02 * means[0]);
}

// VTK encodes PBR materials for display. The mean of encoded samples of a penumbra would be darker than the encoded mean.
TEST(TemporalAccumulation, AveragedStillFramesKeepPenumbraeOnPBR)
{
  std::array<double, 2> means{};
  for (const bool averages : { false, true })
  {
    Studio studio(true, 1, 60);
    studio.Occlusion->EnabledOff();
    studio.Shadows->SetParameter("light-angle", 60.0);
    vtkActorCollection* actors = studio.Scene.Renderer->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor())
    {
      actor->GetProperty()->SetInterpolationToPBR();
      actor->GetProperty()->SetRoughness(1.0);
    }
    studio.Pass->GetTechnique("anti-aliasing")->SetEnabled(averages);
    studio.Pass->GetTechnique("anti-aliasing")->SetParameterFromText("mode", "accumulate");
    studio.Frames(64);
    const Picture picture = Shoot(studio.Scene.Window);
    means[averages] = picture.MeanGrey(0, 0, picture.Width, picture.Height);
  }
  std::printf("PBR: mean %.2f / 255, averaged %.2f\n", means[0], means[1]);
  EXPECT_NEAR(means[1], means[0], 0.01 * means[0]);
}

TEST(TemporalAccumulation, HiddenPropsLeaveNoGhost)
{
  Studio still(true, 16);
  const Values with = still.Frames(16);
  still.Ball->VisibilityOff();
  const Values without = still.Frames(48);

  Studio studio(true);
  studio.Frames(24);
  studio.Ball->VisibilityOff();
  double ghost = 1.0;
  for (int frame = 1; frame <= 8; ++frame)
  {
    ghost = RemainingShare(with, without, studio.Frame());
    std::printf("frame %d after a ball is hidden: %.2f %% of it remains\n", frame, 100.0 * ghost);
  }
  EXPECT_LT(std::abs(ghost), 0.008);
}

// Where penumbrae overlap, clamping would keep the shadow of a prop that has gone, and noise.
TEST(TemporalAccumulation, ShadowsStartFromScratchWhenAPropLeaves)
{
  constexpr int frames = 16;
  Studio fresh(true);
  fresh.Occlusion->EnabledOff();
  fresh.Ball->VisibilityOff();
  const Values beginning = fresh.Frames(frames);
  const Values truth = fresh.Frames(400);
  Studio studio(true);
  studio.Occlusion->EnabledOff();
  // A multiple of the frames that are compared: their samples are distributed as evenly as the first ones.
  studio.Frames(2 * frames);
  studio.Ball->VisibilityOff();
  const double error = Error(studio.Frames(frames), truth);
  const double expected = Error(beginning, truth);
  std::printf("%d frames after a ball is hidden: rms error %.3f / 255, without the ball %.3f\n",
    frames, error, expected);
  EXPECT_LT(error, 1.3 * expected); // 1.5 if the history were clamped
}

// What VTK draws onto the finished picture changes nothing in it.
TEST(TemporalAccumulation, OverlaysLeaveTheMeansAlone)
{
  Studio studio(true);
  const Values first = studio.Frame();
  const Values before = studio.Frames(63);
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor2D> overlay;
  overlay->SetMapper(mapper);
  studio.Scene.Renderer->AddActor2D(overlay);
  const Values after = studio.Frame();
  std::printf("rms change by an overlay %.3f / 255, since the first frame %.3f\n",
    Error(before, after), Error(before, first));
  EXPECT_LT(Error(before, after), 0.05 * Error(before, first));
}

TEST(TemporalAccumulation, ATechniqueSwitchedOnAgainStartsFromScratch)
{
  constexpr int frames = 16;
  const auto start = [](Studio& studio) {
    studio.Shadows->EnabledOff();
    studio.Occlusion->SetParameter("samples", 4);
  };
  Studio fresh(true);
  start(fresh);
  const Values beginning = fresh.Frames(frames);
  const Values truth = fresh.Frames(256);
  const double expected = Error(beginning, truth);
  for (const int pause : { 4, 24 }) // textures of the means are freed during the longer one
  {
    Studio studio(true);
    start(studio);
    studio.Frames(40);
    studio.Occlusion->EnabledOff();
    studio.Frames(pause);
    studio.Occlusion->EnabledOn();
    const double error = Error(studio.Frames(frames), truth);
    std::printf("%d frames off, %d frames on: rms error %.3f / 255, of a fresh pass %.3f\n", pause,
      frames, error, expected);
    EXPECT_LT(error, 1.3 * expected);
  }
}

TEST(TemporalAccumulation, AMovedLightLeavesNoShadowBehind)
{
  Studio still(true, 16);
  const Values with = still.Frames(16);
  still.Sun->SetPosition(-5.0, -4.0, 6.0);
  const Values without = still.Frames(32);

  Studio studio(true);
  studio.Frames(24);
  studio.Sun->SetPosition(-5.0, -4.0, 6.0);
  const double ghost = RemainingShare(with, without, studio.Frame());
  std::printf(
    "first frame after the light moved: %.2f %% of the old light remains\n", 100.0 * ghost);
  EXPECT_LT(std::abs(ghost), 0.0065);
}
