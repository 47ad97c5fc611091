// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Accumulation over frames: noise falls in scenes at rest and in motion, and no ghosts remain.
#include "Picture.h"
#include "SceneParts.h"
#include "Stage.h"

#include "vtkGITechnique.h"

#include "vtkImageData.h"

#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkPlaneSource.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

using namespace penumbra_test;

namespace
{
using Values = std::vector<double>;

// Objects on a floor under a sun of eight degrees and ambient light.
struct Studio
{
  explicit Studio(bool accumulates, int samples = 1, int width = 160)
  {
    this->Scene.Window->SetSize(width, width * 2 / 3);
    AddFloor(this->Scene, -6.0, 6.0, -6.0, 6.0)->GetProperty()->SetColor(0.8, 0.8, 0.8);
    vtkNew<vtkCubeSource> cube;
    this->Box = this->Scene.Add(cube);
    this->Box->SetPosition(0.0, 0.0, 0.5);
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(48);
    sphere->SetPhiResolution(24);
    sphere->SetRadius(0.6);
    this->Ball = this->Scene.Add(sphere);
    this->Ball->SetPosition(1.6, 0.2, 0.6);
    vtkNew<vtkConeSource> cone;
    cone->SetDirection(0.0, 0.0, 1.0);
    cone->SetHeight(1.6);
    cone->SetResolution(32);
    this->Scene.Add(cone)->SetPosition(-1.5, 0.6, 0.8);
    vtkRenderer* renderer = this->Scene.Renderer;
    renderer->AutomaticLightCreationOff();
    this->Sun->SetLightTypeToSceneLight();
    this->Sun->SetPosition(4.0, -5.0, 6.0);
    this->Sun->SetIntensity(0.9);
    renderer->AddLight(this->Sun);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(0.0, -8.0, 4.0);
    camera->SetFocalPoint(0.0, 0.0, 0.4);
    camera->SetViewUp(0.0, 0.0, 1.0);
    renderer->ResetCameraClippingRange();
    vtkGIPass* pass = this->Pass = this->Scene.SetPasses().front();
    pass->SetPreset("off");
    pass->KeepRadianceOn();
    this->Shadows = pass->GetTechnique("ray-traced-shadows");
    this->Shadows->EnabledOn();
    this->Shadows->SetParameter("light-angle", 8.0);
    this->Shadows->SetParameter("samples", samples);
    this->Occlusion = pass->GetTechnique("ambient-occlusion");
    this->Occlusion->EnabledOn();
    this->Occlusion->SetParameter("samples", std::min(256, 8 * samples));
    pass->GetTechnique("temporal-accumulation")->SetEnabled(accumulates);
    pass->GetTechnique("anti-aliasing")->EnabledOff();
  }

  // Display values of the pixels of the next frame.
  Values Frame()
  {
    this->Scene.Window->Render();
    return this->Last();
  }

  Values Last()
  {
    vtkNew<vtkImageData> radiance;
    this->Pass->GetRadiance(this->Scene.Renderer, radiance);
    const auto* pixels = static_cast<const float*>(radiance->GetScalarPointer());
    Values values;
    for (int i = 0; i < radiance->GetNumberOfPoints(); ++i)
    {
      const float* rgb = pixels + 4 * i;
      values.push_back(255.0 * (rgb[0] + rgb[1] + rgb[2]) / 3.0);
    }
    return values;
  }

  void AddSheet()
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-4.0, -4.0, 0.0);
    plane->SetPoint1(4.0, -4.0, 0.0);
    plane->SetPoint2(-4.0, 4.0, 0.0);
    plane->SetResolution(80, 80);
    plane->Update();
    this->Sheet = plane->GetOutput();
    this->Sheet->GetPointData()->Initialize();
    this->Scene.Add(this->Sheet.Get())->GetProperty()->SetColor(0.9, 0.9, 0.9);
  }

  // Move the sheet's travelling hills to a time, by new points or in place.
  void Wave(double time, bool inPlace)
  {
    vtkPoints* old = this->Sheet->GetPoints();
    vtkSmartPointer<vtkPoints> points = old;
    if (!inPlace)
    {
      points = vtkSmartPointer<vtkPoints>::New();
      points->DeepCopy(old);
    }
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      std::array<double, 3> p;
      points->GetPoint(i, p.data());
      p[2] = 0.5 + 0.4 * std::sin(2.0 * p[0] + 3.0 * time) * std::cos(1.5 * p[1] - 2.0 * time);
      points->SetPoint(i, p.data());
    }
    points->Modified();
    points->GetData()->Modified();
    this->Sheet->SetPoints(points);
    this->Sheet->Modified();
  }

  Values Frames(int count)
  {
    Values last;
    for (int i = 0; i < count; ++i)
    {
      last = this->Frame();
    }
    return last;
  }

  Stage Scene;
  vtkSmartPointer<vtkGIPass> Pass;
  vtkNew<vtkLight> Sun;
  vtkActor* Box = nullptr;
  vtkActor* Ball = nullptr;
  vtkSmartPointer<vtkPolyData> Sheet;
  vtkGITechnique* Shadows = nullptr;
  vtkGITechnique* Occlusion = nullptr;
};

double Error(const Values& a, const Values& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return std::sqrt(sum / a.size());
}

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
  // As many that the samples of the next frames are as evenly distributed as those of the first.
  studio.Frames(2 * frames);
  studio.Ball->VisibilityOff();
  const double error = Error(studio.Frames(frames), truth);
  const double expected = Error(beginning, truth);
  std::printf("%d frames after a ball is hidden: rms error %.3f / 255, without the ball %.3f\n",
    frames, error, expected);
  EXPECT_LT(error, 1.3 * expected); // 1.5 if the history were clamped
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

// History follows moving props.
TEST(TemporalAccumulation, NoiseFallsWhilePropsAndCameraMove)
{
  const auto orbit = [](Studio& s) { s.Scene.Renderer->GetActiveCamera()->Azimuth(2.0); };
  const auto props = [](Studio& s) {
    s.Ball->AddPosition(-0.08, -0.08, 0.0);
    s.Box->RotateZ(3.0);
  };
  // A waving sheet covers the scene. Each step gives it new points or writes to the same array.
  int step = 0;
  const auto wave = [&step](Studio& s, bool inPlace) {
    if (!s.Sheet)
    {
      s.AddSheet();
    }
    s.Wave(0.1 * step, inPlace);
  };
  const auto replaced = [&wave](Studio& s) { wave(s, false); };
  const auto rewritten = [&wave](Studio& s) { wave(s, true); };
  using Move = std::function<void(Studio&)>;
  for (const auto& [name, move] :
    { std::pair<const char*, Move>("camera", orbit), std::pair<const char*, Move>("props", props),
      std::pair<const char*, Move>("points", replaced),
      std::pair<const char*, Move>("points in place", rewritten) })
  {
    // Large enough for penumbrae of several pixels.
    Studio raw(false, 1, 300);
    Studio accumulated(true, 1, 300);
    for (int frame = 0; frame < 8; ++frame)
    {
      step = frame;
      for (Studio* studio : { &raw, &accumulated })
      {
        move(*studio);
      }
      accumulated.Scene.Window->Render();
    }
    // Mean of many frames with the same sample count.
    constexpr int others = 96;
    const Values first = raw.Frame();
    Values expected(first.size(), 0.0);
    for (int frame = 0; frame < others; ++frame)
    {
      const Values values = raw.Frame();
      std::transform(values.begin(), values.end(), expected.begin(), expected.begin(),
        [](double value, double sum) { return sum + value / others; });
    }
    const double before = Error(first, expected);
    const double after = Error(accumulated.Last(), expected);
    std::printf("%s moves: rms error %.2f, accumulated %.2f / 255\n", name, before, after);
    EXPECT_LT(after, 0.6 * before);
  }
}

namespace
{
// Values of a frame at fixed points of the floor, interpolated between pixels; -1 outside the picture.
Values Track(Studio& studio, const Values& frame, int width)
{
  vtkRenderer* renderer = studio.Scene.Renderer;
  Values values;
  for (double y = -2.5; y <= 2.5; y += 0.05)
  {
    for (double x = -3.0; x <= 3.0; x += 0.05)
    {
      renderer->SetWorldPoint(x, y, 0.0, 1.0);
      renderer->WorldToDisplay();
      const double* position = renderer->GetDisplayPoint();
      const double u = position[0] - 0.5;
      const double v = position[1] - 0.5;
      const int i = static_cast<int>(std::floor(u));
      const int j = static_cast<int>(std::floor(v));
      if (i < 0 || j < 0 || i + 1 >= width || j + 1 >= width * 2 / 3)
      {
        values.push_back(-1.0);
        continue;
      }
      const double* corner = &frame[static_cast<std::size_t>(j) * width + i];
      const double low = corner[0] + (u - i) * (corner[1] - corner[0]);
      const double high = corner[width] + (u - i) * (corner[width + 1] - corner[width]);
      values.push_back(low + (v - j) * (high - low));
    }
  }
  return values;
}
}

// Between frames of an orbit the value of a point changes hardly more than in converged pictures.
TEST(TemporalAccumulation, AnOrbitDoesNotFlicker)
{
  constexpr int width = 300;
  constexpr int frames = 12;
  constexpr double edge = 8.0; // of 255: larger changes are disocclusions or occlusions
  Studio converged(false, 16, width);
  Studio raw(false, 1, width);
  Studio accumulated(true, 1, width);
  const std::array<Studio*, 3> studios = { { &converged, &raw, &accumulated } };
  std::array<double, 3> flicker{};
  std::array<Values, 3> before;
  int count = 0;
  for (int frame = 0; frame < frames; ++frame)
  {
    std::array<Values, 3> current;
    for (int i = 0; i < 3; ++i)
    {
      studios[i]->Scene.Renderer->GetActiveCamera()->Azimuth(1.0);
      current[i] = Track(*studios[i], studios[i]->Frame(), width);
    }
    for (std::size_t p = 0; frame > 4 && p < current[0].size(); ++p)
    {
      if (current[0][p] >= 0.0 && before[0][p] >= 0.0 &&
        std::abs(current[0][p] - before[0][p]) < edge)
      {
        ++count;
        for (int i = 0; i < 3; ++i)
        {
          flicker[i] += (current[i][p] - before[i][p]) * (current[i][p] - before[i][p]);
        }
      }
    }
    before = current;
  }
  for (double& value : flicker)
  {
    value = std::sqrt(value / count);
  }
  std::printf("flicker in an orbit: converged %.3f, one frame %.3f, accumulated %.3f / 255\n",
    flicker[0], flicker[1], flicker[2]);
  // Two frames, each with two visibilities in eight bits: every rounding has a variance of 1 / 12.
  const double rounding = std::sqrt(2.0 * 2.0 / 12.0);
  EXPECT_GT(count, 10000);
  EXPECT_GT(flicker[1], 2.0 * flicker[2]);
  EXPECT_LT(flicker[2], 1.2 * flicker[0] + rounding);
}

namespace
{
constexpr int OrbitWidth = 240;
constexpr int Fine = 4; // pixels of the truth across a pixel

// A studio with shadows of one technique only.
struct ShadowStudio : Studio
{
  ShadowStudio(const char* technique, int width)
    : Studio(true, 1, width)
    , Technique(this->Pass->GetTechnique(technique))
  {
    this->Occlusion->EnabledOff();
    this->Shadows->SetParameter("light-angle", 1.0);
    this->Shadows->EnabledOff();
    this->Technique->EnabledOn();
  }
  vtkGITechnique* Technique;
};

// Mean of the fine values within each pixel, and their range.
struct Areas
{
  explicit Areas(const Values& fine)
  {
    for (int pixel = 0; pixel < OrbitWidth * (OrbitWidth * 2 / 3); ++pixel)
    {
      Values area;
      for (int i = 0; i < Fine * Fine; ++i)
      {
        const int x = Fine * (pixel % OrbitWidth) + i % Fine;
        const int y = Fine * (pixel / OrbitWidth) + i / Fine;
        area.push_back(fine[static_cast<std::size_t>(y * Fine * OrbitWidth + x)]);
      }
      const auto range = std::minmax_element(area.begin(), area.end());
      this->Means.push_back(std::accumulate(area.begin(), area.end(), 0.0) / (Fine * Fine));
      this->Ranges.push_back(*range.second - *range.first);
    }
  }
  Values Means;
  Values Ranges;
};

// Expect that the last frame of an orbit has a share of the error of a frame without a history, and that the picture after the
// still frames that follow differs from one without the orbit by a share of that error. Pixels with an edge of a surface do not
// count.
void ExpectSharpShadows(const char* technique, double share, double restShare)
{
  constexpr int frames = 16;
  constexpr double step = 1.3; // degrees
  ShadowStudio fine(technique, Fine * OrbitWidth);
  fine.Scene.Renderer->GetActiveCamera()->Azimuth(frames * step);
  const Areas truth(fine.Frames(16));
  fine.Technique->EnabledOff();
  const Areas open(fine.Frame());
  ShadowStudio studio(technique, OrbitWidth);
  const auto error = [&](Values values) {
    constexpr double edge = 8.0; // of 255
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = open.Ranges[i] > edge ? truth.Means[i] : values[i];
    }
    return Error(values, truth.Means);
  };
  Values moved;
  for (int frame = 0; frame < frames; ++frame)
  {
    studio.Scene.Renderer->GetActiveCamera()->Azimuth(step);
    moved = studio.Frame();
  }
  const Values rested = studio.Frames(64);
  studio.Pass->Restart();
  const double single = error(studio.Frame());
  const Values still = studio.Frames(63);
  std::printf(
    "%s: rms error %.3f, of a single frame %.3f; at rest %.3f from the picture without motion\n",
    technique, error(moved), single, Error(rested, still));
  EXPECT_LT(error(moved), share * single);
  EXPECT_LT(Error(rested, still), restShare * single);
}
}

// Each frame of motion reads the history between pixels. That must not blur shadows.
TEST(TemporalAccumulation, RayTracedShadowsStaySharpInAnOrbit)
{
  ExpectSharpShadows("ray-traced-shadows", 0.8, 0.35);
}

TEST(TemporalAccumulation, ShadowMapsStaySharpInAnOrbit)
{
  ExpectSharpShadows("shadow-maps", 0.74, 0.2);
}
