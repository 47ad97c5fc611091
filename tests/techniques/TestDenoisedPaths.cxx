// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Pictures of the path tracer with few paths per pixel, denoised.
 */
#include "DenoisedStage.h"

#include <cmath>
#include <cstdio>

using namespace penumbra_test;

namespace
{
class DenoisedPaths : public DenoisedStage
{
};
}

TEST_F(DenoisedPaths, LeaveLittleNoise)
{
  this->AddRoomWithPanel();
  const Values truth = this->Draw("", Many, 1);
  const double noise = SquaredError(this->Draw("", Few), truth);
  const double more = SquaredError(this->Draw("", 4 * Few), truth);
  for (const char* method : { "filter", "neural" })
  {
    const Values filtered = this->Draw(method, Few);
    std::printf("relMSE of %d paths %.4f, of %d %.4f, of %d with %s %.4f; mean %.5f of %.5f\n", Few,
      noise, 4 * Few, more, Few, method, SquaredError(filtered, truth), Mean(filtered),
      Mean(truth));
    EXPECT_LT(SquaredError(filtered, truth), more);
    EXPECT_NEAR(Mean(filtered), Mean(truth), 0.02 * Mean(truth));
  }
}

// Steep slopes a few pixels long, between black walls that shine. They would be blurred if the network's factors of standard
// deviations counted, as it was not trained on paths, or if the regression on normals knew the walls: the filter left 0.92.
TEST_F(DenoisedPaths, SpareFineSlopes)
{
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.0)->GetProperty()->SetAmbient(0.5);
  this->AddHills(200, -0.8, 0.1, 40.0);
  this->LookFrom(0.4, 0.4, 0.3, 0.0, 0.0, -0.95);
  const Values truth = this->Draw("", Many, 1);
  const double noise = SquaredError(this->Draw("", Few), truth);
  const double plain = SquaredError(this->Draw("filter", Few), truth);
  const double guided = SquaredError(this->Draw("neural", Few), truth);
  std::printf("relMSE %.4f; of it filtered %.3f, by the network %.3f\n", noise, plain / noise,
    guided / noise);
  EXPECT_LT(plain, 0.85 * noise);
  EXPECT_LT(guided, 0.75 * noise);
}

// A lamp without a size, and light that the walls pass on.
TEST_F(DenoisedPaths, KeepTheEdgesOfShadows)
{
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7);
  this->AddBox(-0.5, 0.1, -0.4, 0.2, -1.0, -0.3, 0.7);
  this->Lamp->SetPosition(0.6, 0.3, 0.7);
  this->Lamp->SetIntensity(0.5);
  this->LookFrom(0.2, 0.9, 0.6, -0.3, -0.3, -0.9);
  const Values truth = this->Draw("", Many, 1);
  const double noise = SquaredError(this->Draw("", Few), truth);
  for (const char* method : { "filter", "neural" })
  {
    const double left = SquaredError(this->Draw(method, Few), truth);
    std::printf("relMSE %.4f; with %s %.3f of it\n", noise, method, left / noise);
    EXPECT_LT(left, 0.1 * noise); // 0.13 if the lamp's light were filtered too
  }
}

// Where slopes are as small as pixels, a lamp's light is known at more points than paths meet.
TEST_F(DenoisedPaths, SmoothFineShading)
{
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.3);
  this->AddHills(200, -0.8, 0.1, 80.0);
  this->Lamp->SetPosition(0.9, 0.0, -0.5);
  this->Lamp->SetIntensity(0.5);
  this->LookFrom(0.4, 0.4, 0.3, 0.0, 0.0, -0.95);
  const Values truth = this->Draw("", Many, 1);
  const double noise = SquaredError(this->Draw("", Few), truth);
  for (const char* method : { "filter", "neural" })
  {
    const double left = SquaredError(this->Draw(method, Few), truth);
    std::printf("relMSE %.4f; with %s %.3f of it\n", noise, method, left / noise);
    EXPECT_LT(left, 0.35 * noise); // 0.59 at the points of the paths only
  }
}

// Whether paths pass a surface is a matter of chance, in front of the eye and of a lamp.
TEST_F(DenoisedPaths, SmoothTheNoiseOfTranslucentSurfaces)
{
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7);
  this->AddBox(-0.6, 0.6, -0.6, 0.6, -0.4, -0.35, 0.7)->GetProperty()->SetOpacity(0.5);
  this->Lamp->SetPosition(0.0, 0.0, 0.9);
  this->Lamp->SetIntensity(0.5);
  this->LookFrom(0.9, 0.9, -0.2, -0.2, -0.2, -0.7);
  const Values truth = this->Draw("", Many, 1);
  const Values raw = this->Draw("", Few);
  for (const char* method : { "filter", "neural" })
  {
    const Values picture = this->Draw(method, Few);
    const double left = SquaredError(picture, truth) / SquaredError(raw, truth);
    std::printf(
      "with %s %.3f of the error, mean %.5f of %.5f\n", method, left, Mean(picture), Mean(truth));
    EXPECT_LT(left, 0.15);
    EXPECT_NEAR(Mean(picture), Mean(truth), 0.01 * Mean(truth));
  }
}

// What a surface shines with is no noise: it stays where it is.
TEST_F(DenoisedPaths, KeepTheEdgesOfLamps)
{
  this->AddRoomWithPanel();
  this->LookFrom(0.8, 0.8, -0.8, 0.0, 0.0, 1.0);
  const Values truth = this->Draw("", Many, 1);
  const Values raw = this->Draw("", Few);
  const Values filtered = this->Draw("filter", Few);
  EXPECT_LT(SquaredError(filtered, truth), SquaredError(raw, truth));
  double worst = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    worst = std::max(worst, truth[i] < 0.9 ? std::abs(filtered[i] - truth[i]) : 0.0);
  }
  std::printf("worst difference beside the lamp %.3f\n", worst);
  EXPECT_LT(worst, 0.2);
}

TEST_F(DenoisedPaths, ConvergeToTheUnfilteredMean)
{
  this->Scene.Window->SetSize(24, 18);
  this->AddRoomWithPanel();
  constexpr int paths = 256; // from which nothing is filtered
  const Values expected = this->Draw("", paths);
  EXPECT_EQ(this->Draw("filter", paths), expected);
  EXPECT_EQ(this->Draw("neural", paths), expected);
}

TEST_F(DenoisedPaths, KeepTheMean)
{
  this->Scene.Window->SetSize(40, 30);
  this->AddRoomWithPanel();
  constexpr int seeds = 25;
  const auto sum = [this](const char* method) {
    double found = 0.0;
    for (int seed = 0; seed < seeds; ++seed)
    {
      found += Mean(this->Draw(method, Few, seed));
    }
    return found;
  };
  const double plain = sum("");
  for (const char* method : { "filter", "neural" })
  {
    const double filtered = sum(method);
    std::printf(
      "mean of %d seeds: %s / unfiltered - 1 = %.5f\n", seeds, method, filtered / plain - 1.0);
    EXPECT_NEAR(filtered, plain, 0.005 * plain);
  }
}

// Light may have any unit. Half floats hold dim light with fewer digits.
TEST_F(DenoisedPaths, ScaleWithTheLight)
{
  vtkProperty* panel = this->AddRoomWithPanel();
  for (const char* method : { "filter", "neural" })
  {
    panel->SetAmbientColor(1.0, 1.0, 1.0);
    const Values expected = this->Draw(method, Few);
    for (const double scale : { 1e-3, 1e3 })
    {
      panel->SetAmbientColor(scale, scale, scale);
      const Values scaled = this->Draw(method, Few);
      double difference = 0.0;
      for (std::size_t i = 0; i < expected.size(); ++i)
      {
        difference +=
          std::abs(scaled[i] / scale - expected[i]) / static_cast<double>(expected.size());
      }
      std::printf(
        "%s, times %g: differences %.6f of %.5f\n", method, scale, difference, Mean(expected));
      EXPECT_LT(difference, 0.001 * Mean(expected)) << method << ' ' << scale;
    }
  }
}

TEST_F(DenoisedPaths, LeaveNothingAndOnePixelAsTheyAre)
{
  this->Scene.Renderer->SetBackground(0.2, 0.3, 0.4);
  EXPECT_EQ(this->Draw("neural", 4), this->Draw("", 4)); // nothing but background
  this->AddRoomWithPanel();
  this->Scene.Window->SetSize(1, 1);
  const Values one = this->Draw("", 4);
  const Values filtered = this->Draw("neural", 4);
  ASSERT_EQ(one.size(), filtered.size());
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    EXPECT_NEAR(filtered[i], one[i], 1e-3 * one[i]);
  }
}
