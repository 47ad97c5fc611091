// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The filter of light that few rays found: how much noise it takes away, what it keeps, and that it ends.
 */
#include "RoomStage.h"

#include <cstdio>

using namespace penumbra_test;

namespace
{
class Denoising : public RoomStage
{
protected:
  void SetUp() override
  {
    this->Prepare("ray-traced-light", Width, Height);
    this->Pass->GetTechnique("temporal-accumulation")->EnabledOn();
    this->Filter = this->Pass->GetTechnique("denoising");
    ASSERT_NE(this->Filter, nullptr);
    // A room lit by the ceiling, with a block that hides a part of it.
    this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7);
    this->AddBox(-0.7, -0.2, -0.6, -0.1, -1.0, 0.1, 0.6);
    Paint(AddFloor(this->Scene, -0.3, 0.3, -0.3, 0.3, 0.999), 0.0)->GetProperty()->SetAmbient(1.0);
    this->LookFrom(0.9, 0.8, 0.3, -0.5, -0.5, -0.6);
  }

  Values First(bool filtered)
  {
    this->Filter->SetEnabled(filtered);
    this->Pass->Restart();
    return this->After(1);
  }

  static constexpr int Width = 160;
  static constexpr int Height = 120;
  vtkGITechnique* Filter = nullptr;
};

double SquaredError(const Values& values, const Values& truth)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    sum += std::pow(values[i] - truth[i], 2.0) / (truth[i] * truth[i] + 1e-4);
  }
  return sum / static_cast<double>(values.size());
}
}

TEST_F(Denoising, TakesMostNoiseOffTheFirstFrame)
{
  const Values raw = this->First(false);
  const Values filtered = this->First(true);
  this->Filter->EnabledOff();
  this->Pass->Restart();
  const Values truth = this->After(400);
  const double share = SquaredError(filtered, truth) / SquaredError(raw, truth);
  std::printf("relMSE %.4f, filtered %.4f, %.3f of it; mean %.4f of %.4f\n",
    SquaredError(raw, truth), SquaredError(filtered, truth), share, Mean(filtered), Mean(truth));
  EXPECT_LT(share, 0.1);
  EXPECT_NEAR(Mean(filtered), Mean(truth), 0.03 * Mean(truth));
}

TEST_F(Denoising, EndsInAStillPicture)
{
  Values early[2];
  Values late[2];
  for (const int filtered : { 0, 1 })
  {
    this->First(filtered != 0);
    early[filtered] = this->After(20);
    late[filtered] = this->After(60);
  }
  EXPECT_NE(early[0], early[1]);
  EXPECT_EQ(late[0], late[1]);
}

// Where the light is the same everywhere, nothing may be added or lost, at edges neither.
TEST_F(Denoising, KeepsEnergyAtEdges)
{
  this->Scene.Renderer->RemoveAllViewProps();
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.0)->GetProperty()->SetAmbient(0.5);
  this->AddBox(-0.7, -0.2, -0.6, -0.1, -0.9, 0.1, 0.6);
  const Values filtered = this->First(true);
  double sum = 0.0;
  double count = 0.0;
  for (const double value : filtered)
  {
    if (std::abs(value - 0.5) > 1e-4) // the block; walls show their emission
    {
      sum += value;
      count += 1.0;
    }
  }
  std::printf("%.4f of 0.3, on %.0f pixels\n", sum / count, count);
  EXPECT_GT(count, 0.05 * Width * Height);
  EXPECT_NEAR(sum / count, 0.6 * 0.5, 0.02 * 0.3);
}

TEST_F(Denoising, KeepsHistoryWhileTheCameraMoves)
{
  this->First(true);
  const double expected = Mean(this->After(8));
  for (int i = 0; i < 16; ++i)
  {
    this->Scene.Renderer->GetActiveCamera()->Yaw(0.5);
    for (const double value : this->After(1))
    {
      ASSERT_TRUE(std::isfinite(value)) << "frame " << i;
    }
  }
  EXPECT_NEAR(Mean(this->After(1)), expected, 0.2 * expected);
}
