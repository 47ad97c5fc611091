// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Probes baked beforehand: energy, leaks, what moves among them, and when they no longer fit.
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
  this->ExpectEverywhere(emission / (1.0 - albedo), 0.0016, 0.03);
}

TEST_F(SHProbes, ARoomNextDoorStaysDark)
{
  // Two rooms of 2 x 2 x 2 with a thin wall between them, a lamp in the left one.
  this->Lamp->SetIntensity(1.0);
  this->Lamp->SetPosition(-1.2, 0.3, 0.4);
  for (const double thickness : { 0.1, 0.02 })
  {
    vtkActor* left = this->AddBox(-2.0, -0.5 * thickness, -1.0, 1.0, -1.0, 1.0, 0.7);
    vtkActor* right = this->AddBox(0.5 * thickness, 2.0, -1.0, 1.0, -1.0, 1.0, 0.7);
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
    const Values none = this->After(1); // what shadow maps leave
    this->Probes->EnabledOn();
    this->Pass->GetTechnique("shadow-maps")->EnabledOff();
    double most = 0.0;
    for (std::size_t i = 0; i < dark.size(); ++i)
    {
      most = std::max(most, dark[i] - none[i]);
    }
    std::printf("wall of %.2f, cells of %.2f: lit room's indirect light %.4f, dark room %.6f "
                "(%.3f %%), at most %.6f\n",
      thickness, this->Field->GetSpacing()[0], bright - direct, Mean(dark) - Mean(none),
      100.0 * (Mean(dark) - Mean(none)) / (bright - direct), most);
    EXPECT_LT(thickness, 0.5 * this->Field->GetSpacing()[0]);
    EXPECT_GT(bright - direct, 0.1 * direct);
    EXPECT_LT(Mean(dark) - Mean(none), 1e-5 * (bright - direct));
    EXPECT_LT(most, 0.01 * (bright - direct));
    this->Scene.Renderer->RemoveActor(left);
    this->Scene.Renderer->RemoveActor(right);
  }
}

TEST_F(SHProbes, AMovingBallIsLitAsThePathTracerLightsIt)
{
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7)->GetProperty()->SetColor(1.0, 0.7, 0.5);
  this->AddBox(-0.9, -0.3, -0.9, -0.3, -1.0, 0.1, 0.5);
  this->Lamp->SetPosition(0.4, -0.3, 0.8);
  this->Lamp->SetIntensity(1.0);
  this->Bake(729, 1024);
  // Seen from above, and nothing else.
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

// A room is a box seen from inside, a block one seen from outside: which side is which says nothing of light.
TEST_F(SHProbes, WindingMakesNoDifference)
{
  this->Lamp->SetPosition(0.4, -0.3, 0.8);
  this->Lamp->SetIntensity(0.7);
  this->LookFrom(0.9, 0.8, 0.8, -0.7, -0.6, -0.3);
  std::vector<double> means;
  const std::array<Winding, 2> windings[] = { { Winding::AsMade, Winding::AsMade },
    { Winding::Reversed, Winding::AsMade }, { Winding::AsMade, Winding::Reversed },
    { Winding::Reversed, Winding::Reversed }, { Winding::Mixed, Winding::Mixed } };
  for (const auto& winding : windings)
  {
    vtkActor* parts[2] = { this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.6),
      this->AddBox(-0.9, -0.2, -0.9, -0.2, -1.0, 0.1, 0.6) };
    for (int i = 0; i < 2; ++i)
    {
      Wind(parts[i], winding[i]);
    }
    this->Bake(512, 1024);
    const double with = Mean(this->After(1));
    this->Probes->EnabledOff();
    means.push_back(with - Mean(this->After(1)));
    this->Probes->EnabledOn();
    constexpr const char* names[] = { "as made", "reversed", "mixed" };
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

// What is kept of radiance is drawn apart from what the window shows.
// Light from one side rings: beside it there is too little, cut off at 0, unless it is windowed.
TEST_F(SHProbes, TheWindowLeavesNoLightBelowZero)
{
  constexpr double glow = 20.0;
  this->AddBox(-0.1, 0.1, -0.1, 0.1, 0.9, 1.0, 0.0)->GetProperty()->SetAmbient(glow);
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.0);
  this->Bake(64, 16384);
  this->AddBall(0.0, 0.0, 0.0, 0.3);
  this->LookFrom(0.0, -0.99, 0.0, 0.0, 0.0, 0.0);
  const auto lit = [this](int window) { // down the ball's middle, of 36 rows
    this->Probes->SetWindow(window);
    const Values values = this->After(1);
    int above = 0;
    for (int row = 12; row < 24; ++row)
    {
      above += values[48 * row + 24] > 1e-5 ? 1 : 0;
    }
    return above;
  };
  EXPECT_LT(lit(0), 6);
  EXPECT_EQ(lit(1), 12);
}

TEST_F(SHProbes, WindowsShowTheLightMultisampledOrNot)
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

TEST_F(SHProbes, SayWhenTheyNoLongerFit)
{
  vtkActor* room = this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7);
  this->Lamp->SetPosition(0.3, -0.2, 0.4);
  this->Lamp->SetIntensity(1.0);
  this->LookFrom(0.7, 0.6, 0.8, -0.5, -0.6, -0.3);
  this->After(1);
  EXPECT_TRUE(this->Notes("without a bake"));
  const double direct = Mean(this->After(1));
  this->Bake(64, 128);
  const double lit = Mean(this->After(1));
  EXPECT_GT(lit, 1.2 * direct);
  EXPECT_STREQ(this->Pass->GetNotes(), "");
  // What the bake does not know may come and move.
  vtkActor* ball = this->AddBall(-0.8, -0.8, -0.8, 0.1);
  this->After(1);
  ball->SetPosition(-0.7, -0.7, -0.7);
  EXPECT_GT(Mean(this->After(1)), 1.15 * direct);
  EXPECT_STREQ(this->Pass->GetNotes(), "");
  ball->VisibilityOff();
  // What it knows may not, for one frame. DDGI stands in, unless it is not to.
  this->Lamp->SetPosition(0.3, -0.2, 0.5);
  this->After(1);
  EXPECT_TRUE(this->Pass->GetTechnique("ddgi")->GetTookPart());
  this->Lamp->SetPosition(0.3, -0.2, 0.4);
  this->Probes->LiveFallbackOff();
  const auto stale = [&](const char* words) {
    const double now = Mean(this->After(1));
    EXPECT_TRUE(this->Notes(words)) << this->Pass->GetNotes();
    EXPECT_TRUE(this->Notes("no longer fit"));
    this->Probes->EnabledOff();
    EXPECT_DOUBLE_EQ(now, Mean(this->After(1)));
    this->Probes->EnabledOn();
  };
  this->Lamp->SetPosition(0.3, -0.2, 0.5);
  stale("light");
  EXPECT_NE(this->Probes->GetMismatch(this->Scene.Renderer), "");
  this->Lamp->SetPosition(0.3, -0.2, 0.4);
  EXPECT_NEAR(Mean(this->After(1)), lit, 1e-6);
  EXPECT_STREQ(this->Pass->GetNotes(), "");
  room->GetProperty()->SetColor(0.2, 0.9, 0.2);
  stale("object");
  room->GetProperty()->SetColor(1.0, 1.0, 1.0);
  room->SetScale(0.99);
  stale("object");
}

TEST_F(SHProbes, RefuseWhatIsNoBake)
{
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7);
  this->Bake(27, 1);
  const auto refused = [this](vtkImageData* image, const char* reason) {
    EXPECT_FALSE(this->Probes->SetBake(image));
    EXPECT_NE(std::string(this->Probes->GetBakeError()).find(reason), std::string::npos)
      << this->Probes->GetBakeError();
    EXPECT_TRUE(this->Probes->HasBake());
  };
  vtkNew<vtkImageData> other;
  other->SetDimensions(3, 3, 3);
  refused(other, "no field of probes");
  const auto without = [&](const char* name) {
    vtkNew<vtkImageData> part;
    part->ShallowCopy(this->Field);
    part->GetPointData()->RemoveArray(name);
    part->GetFieldData()->RemoveArray(name);
    refused(part, name);
  };
  for (const char* name : { "format", "light", "distance", "offset", "sight", "backs", "samples" })
  {
    without(name);
  }
  vtkNew<vtkImageData> newer;
  newer->ShallowCopy(this->Field);
  vtkNew<vtkStringArray> format;
  format->SetName("format");
  format->InsertNextValue("penumbra probes 99");
  newer->GetFieldData()->AddArray(format);
  refused(newer, "probes 99");
  vtkNew<vtkImageData> broken;
  broken->DeepCopy(this->Field);
  broken->SetSpacing(1.0, 0.0, 1.0);
  refused(broken, "spacing");
  vtkNew<vtkImageData> owing;
  owing->DeepCopy(this->Field);
  vtkIntArray::SafeDownCast(owing->GetFieldData()->GetArray("samples"))->SetValue(0, -5);
  refused(owing, "samples");
  EXPECT_FALSE(this->Baker->AddSamples(this->Scene.Renderer, owing, 5));
  EXPECT_STRNE(this->Baker->GetLastError(), "");
  vtkNew<vtkImageData> many;
  many->ShallowCopy(this->Field);
  many->SetDimensions(911, 910, 2);
  refused(many, "to 828100 in all");
  EXPECT_TRUE(this->Probes->SetBake(nullptr));
  EXPECT_FALSE(this->Probes->HasBake());
}

TEST_F(SHProbes, BallsShowThemUnlessSomethingIsBefore)
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
  double most = 0.0;
  const auto shown = [&] {
    int count = 0;
    for (const double value : this->After(1))
    {
      count += value > 0.0;
      most = std::max(most, value);
    }
    return count;
  };
  const int all = shown();
  wall->VisibilityOn();
  const int before = shown();
  std::printf("pixels of balls: %d, before a wall %d, brightest %.3f\n", all, before, most);
  EXPECT_NEAR(most, 1.0, 0.05); // a white ball in light of 1
  EXPECT_GT(before, 20);
  EXPECT_GT(all, before + 50);
}
