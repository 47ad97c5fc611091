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

// Steep slopes a few pixels long. The network was not trained on paths, so its factors of standard deviations would blur them: 1.13.
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
  EXPECT_LT(plain, 0.7 * noise);
  EXPECT_LT(guided, 1.06 * plain);
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
