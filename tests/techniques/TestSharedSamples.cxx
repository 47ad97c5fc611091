// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Ray-traced light at lower resolutions: pixels share samples in turn, on the same surface only, and a still
 * picture converges to that of full resolution.
 */
#include "RoomStage.h"

#include <cstdio>
#include <numeric>

using namespace penumbra_test;

namespace
{
struct Sharing
{
  const char* Resolution;
  int Turns; ///< number of pixels that share a sample
  double
    LeastLit; ///< share of thin things that is lit in the first frame at least, of that at full resolution
};
constexpr Sharing Sharings[] = { { "checkerboard", 2, 0.75 }, { "half", 4, 0.75 },
  { "quarter", 16, 0.6 } };

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

  /// Expect that what is lit lends no light to what is not.
  void ExpectDarkness()
  {
    const Values truth = this->Draw("full", 64);
    for (const auto& [resolution, turns, leastLit] : Sharings)
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
};

/// How a picture differs from another, as shares of the other's light. Unlike relMSE these hardly depend on a few dark or
/// bright pixels.
struct Differences
{
  double Absolute = 0.0; ///< sum of the absolute differences
  double Signed = 0.0;   ///< sum of the differences
  double Noise = 0.0;    ///< its standard deviation if pixels differ independently
  double Largest = 0.0;  ///< largest difference, in units of the picture

  Differences(const Values& values, const Values& truth)
  {
    const double light = std::accumulate(truth.begin(), truth.end(), 0.0);
    double squares = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
      const double difference = values[i] - truth[i];
      this->Absolute += std::abs(difference) / light;
      this->Signed += difference / light;
      this->Largest = std::max(this->Largest, std::abs(difference));
      squares += difference * difference;
    }
    this->Noise = std::sqrt(squares) / light;
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
    const Differences full(this->Draw("full", samples, filtered), truth);
    for (const auto& [resolution, turns, leastLit] : Sharings)
    {
      const Differences shared(this->Draw(resolution, turns * samples, filtered), truth);
      std::printf("%s, %d samples%s: differences %.4f of the light, full %.4f; largest %.3f, full "
                  "%.3f; mean off by %.4f, as noise explains %.4f\n",
        resolution, samples, filtered ? ", filtered" : "", shared.Absolute, full.Absolute,
        shared.Largest, full.Largest, shared.Signed, shared.Noise);
      EXPECT_LT(shared.Absolute, 1.14 * full.Absolute); // 1.3 squared
      EXPECT_LT(shared.Largest, 0.2); // a pixel of the wrong surface is off by the panel's 1
      EXPECT_NEAR(shared.Signed, 0.0, filtered ? 0.02 : 4.0 * shared.Noise);
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
  this->ExpectDarkness();
}

// A lit screen before a wall in the dark, both turned to the viewer.
TEST_F(SharedSamples, DoNotCrossGaps)
{
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.0);
  this->AddBox(-0.95, -0.94, -0.9, 0.9, -0.9, 0.9, 0.8);
  this->AddBox(0.1, 0.11, -0.3, 0.1, -0.3, 0.3, 0.8);
  this->AddBox(0.5, 0.6, 0.5, 0.9, -0.4, 0.4, 0.0)->GetProperty()->SetAmbient(1.0);
  this->AddBox(0.08, 0.09, 0.05, 0.99, -0.99, 0.99, 0.0); // keeps light off the wall
  this->LookFrom(0.95, 0.0, 0.0, -0.9, 0.0, 0.0);
  this->ExpectDarkness();
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
  for (const auto& [resolution, turns, leastLit] : Sharings)
  {
    const auto shared = drawn(this->Draw(resolution, 1));
    const int frames = std::max(turns, 4); // one or two rays may find nothing
    const auto later = drawn(this->Draw(resolution, frames));
    std::printf("%s: %d of %d pixels lit in the first frame, %d after %d; full %d\n", resolution,
      static_cast<int>(shared), static_cast<int>(all), static_cast<int>(later), frames,
      static_cast<int>(first));
    // Rays that find nothing are as many as at full resolution.
    EXPECT_GE(shared, leastLit * first);
    EXPECT_GE(later, 0.95 * all);
  }
}
