// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Baked probes: energy, leaks, moving props, and mismatches with the scene.
 */
#include "BakedStage.h"

#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

using namespace penumbra_test;

namespace
{
class SHProbes : public BakedStage
{
};
}

TEST_F(SHProbes, ClosedEnclosureKeepsItsEnergy)
{
  this->LookFrom(0.7, 0.6, 0.8, -0.5, -0.6, -0.3);
  constexpr double emission = 0.1;
  constexpr double albedo = 0.8;
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, albedo)->GetProperty()->SetAmbient(emission);
  this->Bake(64, 16384);
  this->ExpectRadiosity(emission / (1.0 - albedo), 0.0016, 0.03);
}

TEST_F(SHProbes, ARoomNextDoorStaysDark)
{
  this->Lamp->SetIntensity(1.0);
  for (const double thickness : { 0.1, 0.02 })
  {
    const auto rooms = this->AddTwoRooms(thickness);
    this->Bake(512, 512);
    this->LookFrom(-1.8, -0.8, 0.8, -0.5, 0.5, -0.5);
    const double bright = Mean(this->After(1));
    this->Probes->EnabledOff();
    const double direct = Mean(this->After(1));
    this->Probes->EnabledOn();
    this->LookFrom(1.8, -0.8, 0.8, 0.5, 0.5, -0.5);
    this->Pass->GetTechnique("shadow-maps")->EnabledOn();
    const Values dark = this->After(1);
    this->Probes->EnabledOff();
    const Values without = this->After(1); // light that shadow maps let through
    this->Probes->EnabledOn();
    this->Pass->GetTechnique("shadow-maps")->EnabledOff();
    double largest = 0.0;
    for (std::size_t i = 0; i < dark.size(); ++i)
    {
      largest = std::max(largest, dark[i] - without[i]);
    }
    std::printf("wall of %.2f, cells of %.2f: lit room's indirect light %.4f, dark room %.6f "
                "(%.3f %%), at most %.6f\n",
      thickness, this->Field->GetSpacing()[0], bright - direct, Mean(dark) - Mean(without),
      100.0 * (Mean(dark) - Mean(without)) / (bright - direct), largest);
    EXPECT_LT(thickness, 0.5 * this->Field->GetSpacing()[0]);
    EXPECT_GT(bright - direct, 0.1 * direct);
    EXPECT_LT(Mean(dark) - Mean(without), 1e-5 * (bright - direct));
    EXPECT_LT(largest, 0.01 * (bright - direct));
    for (vtkActor* room : rooms)
    {
      this->Scene.Renderer->RemoveActor(room);
    }
  }
}

TEST_F(SHProbes, AMovingBallMatchesThePathTracer)
{
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7)->GetProperty()->SetColor(1.0, 0.7, 0.5);
  this->AddBox(-0.9, -0.3, -0.9, -0.3, -1.0, 0.1, 0.5);
  this->Lamp->SetPosition(0.4, -0.3, 0.8);
  this->Lamp->SetIntensity(1.0);
  this->Bake(729, 1024);
  // The ball, seen from above, fills the picture.
  constexpr double radius = 0.12;
  constexpr int side = 24;
  this->Scene.Window->SetSize(side, side);
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(radius);
  for (const double x : { -0.3, 0.1, 0.5 })
  {
    const double y = 0.4;
    const double z = 0.5 * x;
    vtkActor* ball = this->AddBall(x, y, z, radius);
    camera->SetPosition(x + 0.3, y + 0.1, z + 0.3);
    camera->SetFocalPoint(x, y, z);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetClippingRange(0.01, 5.0);
    const Values with = this->After(1);
    EXPECT_STREQ(this->Pass->GetNotes(), "");
    this->Probes->EnabledOff();
    const Values without = this->After(1);
    const Values all = this->Traced(32, 256);
    const Values direct = this->Traced(0, 16);
    this->Probes->EnabledOn();
    double error = 0.0;
    double sum = 0.0;
    double sign = 0.0;
    for (int i = 0; i < side * side; ++i)
    {
      const double u = (i % side + 0.5) / side * 2.0 - 1.0;
      const double v = (i / side + 0.5) / side * 2.0 - 1.0;
      if (u * u + v * v < 0.85)
      {
        const double expected = all[i] - direct[i];
        error += std::abs(with[i] - without[i] - expected);
        sign += with[i] - without[i] - expected;
        sum += expected;
      }
    }
    std::printf(
      "ball at %.1f: mean absolute error %.2f %% of the mean irradiance, signed %.2f %%\n", x,
      100.0 * error / sum, 100.0 * sign / sum);
    EXPECT_LT(error / sum, 0.044);
    this->Scene.Renderer->RemoveActor(ball);
  }
}

// A room is a box seen from inside, a block a box seen from outside: winding says nothing about light.
TEST_F(SHProbes, WindingMakesNoDifference)
{
  this->Lamp->SetPosition(0.4, -0.3, 0.8);
  this->Lamp->SetIntensity(0.7);
  this->LookFrom(0.9, 0.8, 0.8, -0.7, -0.6, -0.3);
  std::vector<double> means;
  const std::array<Winding, 2> windings[] = { { Winding::Original, Winding::Original },
    { Winding::Reversed, Winding::Original }, { Winding::Original, Winding::Reversed },
    { Winding::Reversed, Winding::Reversed }, { Winding::Mixed, Winding::Mixed } };
  for (const auto& winding : windings)
  {
    vtkActor* parts[2] = { this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.6),
      this->AddBox(-0.9, -0.2, -0.9, -0.2, -1.0, 0.1, 0.6) };
    for (int i = 0; i < 2; ++i)
    {
      SetWinding(parts[i], winding[i]);
    }
    this->Bake(512, 1024);
    const double with = Mean(this->After(1));
    this->Probes->EnabledOff();
    means.push_back(with - Mean(this->After(1)));
    this->Probes->EnabledOn();
    constexpr const char* names[] = { "original", "reversed", "mixed" };
    std::printf("room %s, block %s: indirect light %.4f\n", names[static_cast<int>(winding[0])],
      names[static_cast<int>(winding[1])], means.back());
    for (vtkActor* part : parts)
    {
      this->Scene.Renderer->RemoveActor(part);
    }
  }
  for (const double mean : means)
  {
    EXPECT_GT(mean, 0.05);
    EXPECT_NEAR(mean, means[0], 0.02 * means[0]);
  }
}

// Spherical harmonics of light from one side ring: other sides get negative light, cut off at 0, unless they are
// windowed.
TEST_F(SHProbes, WindowingPreventsNegativeLight)
{
  constexpr double glow = 20.0;
  this->AddBox(-0.1, 0.1, -0.1, 0.1, 0.9, 1.0, 0.0)->GetProperty()->SetAmbient(glow);
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.0);
  this->Bake(64, 16384);
  this->AddBall(0.0, 0.0, 0.0, 0.3);
  this->LookFrom(0.0, -0.99, 0.0, 0.0, 0.0, 0.0);
  const auto litRows = [this](int window) { // of 12 rows down the middle of the ball
    this->Probes->SetWindow(window);
    const Values values = this->After(1);
    int lit = 0;
    for (int row = 12; row < 24; ++row)
    {
      lit += values[48 * row + 24] > 1e-5 ? 1 : 0;
    }
    return lit;
  };
  EXPECT_LT(litRows(0), 6);
  EXPECT_EQ(litRows(1), 12);
}

// Kept radiance is drawn separately from the window's picture.
TEST_F(SHProbes, WindowsShowTheLightWithAndWithoutMultisampling)
{
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.5);
  this->Lamp->SetPosition(0.3, -0.2, 0.4);
  this->Lamp->SetIntensity(0.4);
  this->LookFrom(0.7, 0.6, 0.8, -0.5, -0.6, -0.3);
  this->Bake(64, 64);
  this->Pass->KeepRadianceOff();
  for (const int samples : { 0, 4 })
  {
    this->Scene.Window->SetMultiSamples(samples);
    this->Probes->EnabledOff();
    const double direct = Shoot(this->Scene.Window).MeanGrey(0, 0, 48, 36);
    this->Probes->EnabledOn();
    const double lit = Shoot(this->Scene.Window).MeanGrey(0, 0, 48, 36);
    std::printf("%d samples: %.1f, without probes %.1f\n", samples, lit, direct);
    EXPECT_GT(direct, 20.0);
    EXPECT_GT(lit, 1.3 * direct);
  }
}

TEST_F(SHProbes, ReportAMismatchWithTheScene)
{
  vtkActor* room = this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7);
  this->Lamp->SetPosition(0.3, -0.2, 0.4);
  this->Lamp->SetIntensity(1.0);
  this->LookFrom(0.7, 0.6, 0.8, -0.5, -0.6, -0.3);
  this->After(1);
  EXPECT_TRUE(this->HasNote("without a bake"));
  const double direct = Mean(this->After(1));
  this->Bake(64, 128);
  const double lit = Mean(this->After(1));
  EXPECT_GT(lit, 1.2 * direct);
  EXPECT_STREQ(this->Pass->GetNotes(), "");
  // Props unknown to the bake may appear and move.
  vtkActor* ball = this->AddBall(-0.8, -0.8, -0.8, 0.1);
  this->After(1);
  ball->SetPosition(-0.7, -0.7, -0.7);
  EXPECT_GT(Mean(this->After(1)), 1.15 * direct);
  EXPECT_STREQ(this->Pass->GetNotes(), "");
  ball->VisibilityOff();
  // A change of anything in the bake counts in the same frame. DDGI stands in, unless the fallback is off.
  this->Lamp->SetPosition(0.3, -0.2, 0.5);
  this->After(1);
  EXPECT_TRUE(this->Pass->GetTechnique("ddgi")->GetTookPart());
  this->Lamp->SetPosition(0.3, -0.2, 0.4);
  this->Probes->LiveFallbackOff();
  const auto expectStale = [&](const char* words) {
    const double shown = Mean(this->After(1));
    EXPECT_TRUE(this->HasNote(words)) << this->Pass->GetNotes();
    EXPECT_TRUE(this->HasNote("no longer fit"));
    this->Probes->EnabledOff();
    EXPECT_DOUBLE_EQ(shown, Mean(this->After(1)));
    this->Probes->EnabledOn();
  };
  this->Lamp->SetPosition(0.3, -0.2, 0.5);
  expectStale("light");
  EXPECT_NE(this->Probes->GetMismatch(this->Scene.Renderer), "");
  this->Lamp->SetPosition(0.3, -0.2, 0.4);
  EXPECT_NEAR(Mean(this->After(1)), lit, 1e-6);
  EXPECT_STREQ(this->Pass->GetNotes(), "");
  room->GetProperty()->SetColor(0.2, 0.9, 0.2);
  expectStale("object");
  room->GetProperty()->SetColor(1.0, 1.0, 1.0);
  room->SetScale(0.99);
  expectStale("object");
}

TEST_F(SHProbes, RefuseInvalidBakes)
{
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7);
  this->Bake(27, 1);
  const auto expectRefused = [this](vtkImageData* image, const char* reason) {
    EXPECT_FALSE(this->Probes->SetBake(image));
    EXPECT_NE(std::string(this->Probes->GetBakeError()).find(reason), std::string::npos)
      << this->Probes->GetBakeError();
    EXPECT_TRUE(this->Probes->HasBake());
  };
  vtkNew<vtkImageData> other;
  other->SetDimensions(3, 3, 3);
  expectRefused(other, "no field of probes");
  const auto expectRequired = [&](const char* name) {
    vtkNew<vtkImageData> part;
    part->ShallowCopy(this->Field);
    part->GetPointData()->RemoveArray(name);
    part->GetFieldData()->RemoveArray(name);
    expectRefused(part, name);
  };
  for (const char* name : { "format", "light", "distance", "offset", "sight", "backs", "samples" })
  {
    expectRequired(name);
  }
  vtkNew<vtkImageData> newer;
  newer->ShallowCopy(this->Field);
  vtkNew<vtkStringArray> format;
  format->SetName("format");
  format->InsertNextValue("penumbra probes 99");
  newer->GetFieldData()->AddArray(format);
  expectRefused(newer, "probes 99");
  vtkNew<vtkImageData> broken;
  broken->DeepCopy(this->Field);
  broken->SetSpacing(1.0, 0.0, 1.0);
  expectRefused(broken, "spacing");
  vtkNew<vtkImageData> negative;
  negative->DeepCopy(this->Field);
  vtkIntArray::SafeDownCast(negative->GetFieldData()->GetArray("samples"))->SetValue(0, -5);
  expectRefused(negative, "samples");
  EXPECT_FALSE(this->Baker->AddSamples(this->Scene.Renderer, negative, 5));
  EXPECT_STRNE(this->Baker->GetLastError(), "");
  vtkNew<vtkImageData> tooMany;
  tooMany->ShallowCopy(this->Field);
  tooMany->SetDimensions(911, 910, 2);
  expectRefused(tooMany, "to 828100 in all");
  EXPECT_TRUE(this->Probes->SetBake(nullptr));
  EXPECT_FALSE(this->Probes->HasBake());
}

TEST_F(SHProbes, BallsShowVisibleProbes)
{
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.0)->GetProperty()->SetAmbient(1.0);
  this->Bake(125, 1024);
  this->Scene.Window->SetSize(96, 72);
  this->LookFrom(0.7, 0.6, 0.8, -0.5, -0.6, -0.3);
  this->Scene.Renderer->RemoveAllViewProps();
  vtkActor* wall = this->AddBox(0.3, 0.31, -5.0, 5.0, -5.0, 5.0, 0.0);
  wall->VisibilityOff();
  this->AddBox(-9.0, -8.0, -9.0, 9.0, -9.0, 9.0, 0.0); // something to draw
  this->Probes->SetShow(true);
  double largest = 0.0;
  const auto countPixels = [&] {
    int count = 0;
    for (const double value : this->After(1))
    {
      count += value > 0.0;
      largest = std::max(largest, value);
    }
    return count;
  };
  const int all = countPixels();
  wall->VisibilityOn();
  const int before = countPixels();
  std::printf("pixels of balls: %d, before a wall %d, brightest %.3f\n", all, before, largest);
  EXPECT_NEAR(largest, 1.0, 0.05); // a white ball in light of 1
  EXPECT_GT(before, 20);
  EXPECT_GT(all, before + 50);
}
