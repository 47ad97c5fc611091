// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Ray-traced light at half and quarter resolution: pixels share samples in turn, on the same surface only, and a still
 * picture converges to that of full resolution.
 */
#include "RoomStage.h"

#include <cstdio>

using namespace penumbra_test;

namespace
{
class SharedSamples : public RoomStage
{
protected:
  void SetUp() override
  {
    this->Prepare("ray-traced-light", 96, 72);
    this->Pass->GetTechnique("temporal-accumulation")->EnabledOn();
  }

  /// A room lit by the ceiling, with a block.
  void AddRoom()
  {
    this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7);
    this->AddBox(-0.7, -0.2, -0.6, -0.1, -1.0, 0.1, 0.6);
    Paint(AddFloor(this->Scene, -0.3, 0.3, -0.3, 0.3, 0.9), 0.0)->GetProperty()->SetAmbient(1.0);
    this->LookFrom(0.9, 0.8, 0.3, -0.5, -0.5, -0.6);
  }

  Values Draw(const char* resolution, int frames, bool filtered = false)
  {
    this->Pass->GetTechnique("ray-traced-light")->SetParameterFromText("resolution", resolution);
    this->Pass->GetTechnique("denoising")->SetEnabled(filtered);
    this->Pass->Restart();
    return this->After(frames);
  }
};
}

// With as many samples of each pixel the error is that of full resolution.
TEST_F(SharedSamples, ConvergeToThePictureOfFullResolution)
{
  this->Scene.Window->SetSize(64, 48);
  this->AddRoom();
  const Values truth = this->Draw("full", 2000);
  for (const bool filtered : { false, true })
  {
    const int samples = filtered ? 16 : 64;
    const double full = SquaredError(this->Draw("full", samples, filtered), truth);
    for (const int turns : { 4, 16 })
    {
      const char* resolution = turns == 4 ? "half" : "quarter";
      const Values values = this->Draw(resolution, turns * samples, filtered);
      const double shared = SquaredError(values, truth);
      double most = 0.0;
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        most = std::max(most, std::abs(values[i] - truth[i]));
      }
      std::printf(
        "%s, %d samples%s: relMSE %.5f, full %.5f; largest difference %.3f, mean %.4f of %.4f\n",
        resolution, samples, filtered ? ", filtered" : "", shared, full, most, Mean(values),
        Mean(truth));
      EXPECT_LT(shared, 1.3 * full);
      EXPECT_LT(most, 0.1);
      EXPECT_NEAR(Mean(values), Mean(truth), (filtered ? 0.02 : 0.005) * Mean(truth));
    }
  }
}

// One wall shines, all others are black: what turns away from it stays dark.
TEST_F(SharedSamples, DoNotCrossEdges)
{
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.0);
  this->AddBox(0.98, 0.99, -0.9, 0.9, -0.9, 0.9, 0.0)->GetProperty()->SetAmbient(1.0);
  this->AddBox(-0.5, 0.1, -0.3, 0.3, -0.9, 0.0, 0.8);
  this->LookFrom(-0.9, -0.8, 0.7, -0.2, 0.0, -0.4);
  const Values truth = this->Draw("full", 64);
  for (const char* resolution : { "half", "quarter" })
  {
    const Values values = this->Draw(resolution, 1);
    double lit = 0.0;
    double dark = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
      lit += truth[i] > 0.99 ? 0.0 : truth[i];
      dark += truth[i] < 1e-6 ? values[i] : 0.0;
    }
    std::printf("%s: light on dark surfaces %.5f of all\n", resolution, dark / lit);
    EXPECT_GT(lit, 10.0);
    EXPECT_LT(dark, 1e-4 * lit);
  }
}

// Sticks of about a pixel's width in front of nothing, lit from behind the camera. In the first frame most have no ray of their
// own, and few have neighbours on the same surface.
TEST_F(SharedSamples, LeaveNoHolesInThinThings)
{
  for (int i = -5; i <= 5; ++i)
  {
    this->AddBox(-0.7, -0.69, 0.09 * i - 0.005, 0.09 * i + 0.005, -0.8, 0.8, 0.8);
  }
  this->AddBox(0.9, 0.91, -0.9, 0.9, -0.9, 0.9, 0.0)->GetProperty()->SetAmbient(1.0);
  this->LookFrom(0.6, 0.1, 0.1, -0.7, 0.0, 0.0);
  const auto drawn = [](const Values& values) {
    return std::count_if(values.begin(), values.end(), [](double value) { return value > 0.0; });
  };
  const auto all = drawn(this->Draw("full", 64));
  const auto first = drawn(this->Draw("full", 1));
  EXPECT_GT(all, 200);
  for (const int turns : { 4, 16 })
  {
    const char* resolution = turns == 4 ? "half" : "quarter";
    const auto shared = drawn(this->Draw(resolution, 1));
    const auto later = drawn(this->Draw(resolution, turns));
    std::printf("%s: %d of %d pixels lit in the first frame, %d after %d; full %d\n", resolution,
      static_cast<int>(shared), static_cast<int>(all), static_cast<int>(later), turns,
      static_cast<int>(first));
    // Rays that find nothing are as many as at full resolution.
    EXPECT_GE(shared, (turns == 4 ? 0.75 : 0.6) * first);
    EXPECT_GE(later, 0.95 * all);
  }
}
