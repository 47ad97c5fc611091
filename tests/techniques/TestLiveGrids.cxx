// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Live probes in several grids that follow the camera: energy, light that does not depend on the camera's path, and
 * leaks.
 */
#include "RoomStage.h"

#include "vtkGIDDGI.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace penumbra_test;

namespace
{
class LiveGrids : public RoomStage
{
protected:
  void SetUp() override
  {
    this->Prepare("ddgi", 32, 24);
    this->Probes = vtkGIDDGI::SafeDownCast(this->Pass->GetTechnique("ddgi"));
    ASSERT_NE(this->Probes, nullptr);
    this->Probes->SetProbes(3 * 125);
    this->Probes->SetGrids(3);
  }

  /// Place the camera between one end of the room, 0, and the other, 1.
  void PlaceCamera(double along)
  {
    this->LookFrom(-1.6 + 3.0 * along, 0.6, 0.5, -0.8 + 3.0 * along, -0.6, -0.3);
  }

  vtkGIDDGI* Probes = nullptr;
};
}

// The radiosity is E / (1 - r) everywhere, and so is the light of new probes.
TEST_F(LiveGrids, ClosedEnclosureKeepsItsEnergyWhileTheCameraMoves)
{
  constexpr double emission = 0.1;
  constexpr double albedo = 0.8;
  const double expected = emission / (1.0 - albedo);
  this->AddBox(-2.0, 2.0, -1.0, 1.0, -1.0, 1.0, albedo)->GetProperty()->SetAmbient(emission);
  this->PlaceCamera(0.0);
  const double still = LargestError(this->After(200), expected);
  double before[6];
  this->Probes->GetGridBounds(this->Scene.Renderer, 2, before);
  double moving = 0.0;
  constexpr int steps = 40;
  for (int step = 1; step <= steps; ++step)
  {
    this->PlaceCamera(static_cast<double>(step) / steps);
    moving = std::max(moving, LargestError(this->After(1), expected));
  }
  double after[6];
  this->Probes->GetGridBounds(this->Scene.Renderer, 2, after);
  std::printf(
    "largest error against E / (1 - r) %.2f %%, while the camera moves %.2f %%; the finest grid "
    "reaches from %.2f to %.2f, then from %.2f to %.2f\n",
    100.0 * still, 100.0 * moving, before[0], before[1], after[0], after[1]);
  EXPECT_LT(still, 0.02);
  EXPECT_LT(moving, 0.02);
  EXPECT_GT(after[0], before[1]); // all probes are new
  this->Probes->GetGridBounds(this->Scene.Renderer, 3, after);
  EXPECT_GT(after[0], after[1]);
}

// After a move in steps the picture is that of a camera that was there from the start.
TEST_F(LiveGrids, LightDoesNotDependOnTheCamerasPath)
{
  this->AddBox(-2.0, 2.0, -1.0, 1.0, -1.0, 1.0, 0.7);
  this->AddBox(0.6, 1.0, -0.7, -0.3, -1.0, -0.2, 0.5);
  this->Lamp->SetPosition(0.3, -0.2, 0.7);
  this->Lamp->SetIntensity(1.0);
  this->PlaceCamera(1.0);
  const Values reference = this->After(150);
  this->Probes->EnabledOff();
  const double direct = Mean(this->After(1));
  const double indirect = Mean(reference) - direct;
  EXPECT_GT(indirect, 0.2 * direct);
  this->Probes->EnabledOn();
  this->PlaceCamera(0.0);
  this->After(60);
  constexpr int steps = 30;
  for (int step = 1; step <= steps; ++step)
  {
    this->PlaceCamera(static_cast<double>(step) / steps);
    this->After(1);
  }
  const auto error = [&](const Values& values) {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      sum += std::abs(values[i] - reference[i]);
    }
    return sum / (indirect * static_cast<double>(values.size()));
  };
  const double atOnce = error(this->After(1));
  const double settled = error(this->After(100));
  std::printf("mean error, of the mean indirect light: on arrival %.2f %%, then %.2f %%\n",
    100.0 * atOnce, 100.0 * settled);
  EXPECT_LT(atOnce, 0.009);
  EXPECT_LT(settled, 0.0045);
}

TEST_F(LiveGrids, ARoomNextDoorStaysDark)
{
  this->Lamp->SetIntensity(1.0);
  this->AddTwoRooms(0.02);
  this->LookFrom(-1.8, -0.8, 0.8, -0.5, 0.5, -0.5);
  const double bright = Mean(this->After(60));
  this->Probes->EnabledOff();
  const double direct = Mean(this->After(1));
  this->Probes->EnabledOn();
  this->Pass->GetTechnique("shadow-maps")->EnabledOn();
  // Away from the wall, through the dark room.
  double largest = 0.0;
  for (int step = 0; step < 20; ++step)
  {
    this->LookFrom(0.2 + 0.08 * step, -0.8, 0.8, 0.2, 0.5, -0.5);
    largest = std::max(largest, Mean(this->After(1)));
  }
  std::printf(
    "dark room: %.3f %% of the lit one's indirect light\n", 100.0 * largest / (bright - direct));
  EXPECT_LT(largest, 3e-4 * (bright - direct));
}
