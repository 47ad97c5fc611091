// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Accumulation over frames in motion: noise falls, and shadows neither flicker nor blur.
#include "Studio.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numeric>
#include <utility>

using namespace penumbra_test;

// History follows moving props.
TEST(TemporalMotion, NoiseFallsWhilePropsAndCameraMove)
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
TEST(TemporalMotion, AnOrbitDoesNotFlicker)
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

using Move = std::function<void(vtkCamera*)>;

// Expect that the last frame of a move has a share of the error of a frame without a history, and that the picture after the
// still frames that follow differs from one without the move by a share of that error. Pixels with an edge of a surface do not
// count.
void ExpectSharpShadows(const char* technique, const char* name, const Move& start,
  const Move& step, double share, double restShare)
{
  constexpr int frames = 16;
  ShadowStudio fine(technique, Fine * OrbitWidth);
  start(fine.Scene.Renderer->GetActiveCamera());
  for (int frame = 0; frame < frames; ++frame)
  {
    step(fine.Scene.Renderer->GetActiveCamera());
  }
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
  start(studio.Scene.Renderer->GetActiveCamera());
  for (int frame = 0; frame < frames; ++frame)
  {
    step(studio.Scene.Renderer->GetActiveCamera());
    moved = studio.Frame();
  }
  const Values rested = studio.Frames(64);
  studio.Pass->Restart();
  const double single = error(studio.Frame());
  const Values still = studio.Frames(63);
  std::printf("%s, %s: rms error %.3f, of a single frame %.3f; at rest %.3f from the picture "
              "without motion\n",
    technique, name, error(moved), single, Error(rested, still));
  EXPECT_LT(error(moved), share * single);
  EXPECT_LT(Error(rested, still), restShare * single);
}

const Move Stays = [](vtkCamera*) {};
const Move Turns = [](vtkCamera* camera) { camera->Azimuth(1.3); };
}

// Each frame of motion reads the history between pixels. That must not blur shadows.
TEST(TemporalMotion, RayTracedShadowsStaySharpInAnOrbit)
{
  ExpectSharpShadows("ray-traced-shadows", "orbit", Stays, Turns, 0.8, 0.35);
}

TEST(TemporalMotion, ShadowMapsStaySharpInAnOrbit)
{
  ExpectSharpShadows("shadow-maps", "orbit", Stays, Turns, 0.74, 0.2);
}

// What was seen from afar or at a sharp angle is too coarse for a closer look.
TEST(TemporalMotion, ShadowsSharpenAsTheCameraApproaches)
{
  const Move far = [](vtkCamera* camera) { camera->Dolly(0.2); };
  const Move nearer = [](vtkCamera* camera) { camera->Dolly(std::pow(5.0, 1.0 / 16.0)); };
  ExpectSharpShadows("ray-traced-shadows", "approach", far, nearer, 0.63, 0.11);
}

TEST(TemporalMotion, ShadowsSharpenAsTheCameraRises)
{
  const Move low = [](vtkCamera* camera) { camera->Elevation(-24.0); };
  const Move higher = [](vtkCamera* camera) { camera->Elevation(1.5); };
  ExpectSharpShadows("ray-traced-shadows", "rise", low, higher, 0.65, 0.19);
}
