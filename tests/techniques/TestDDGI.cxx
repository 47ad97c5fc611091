// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Probes that are updated every frame: energy, leaks, response to changes, and stability.
 */
#include "RoomStage.h"

#include "vtkGIDDGI.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace penumbra_test;

namespace
{
class DDGI : public RoomStage
{
protected:
  void SetUp() override
  {
    this->Prepare("ddgi", 96, 72);
    this->Probes = vtkGIDDGI::SafeDownCast(this->Pass->GetTechnique("ddgi"));
    ASSERT_NE(this->Probes, nullptr);
  }

  /// A closed room with a lamp in a small picture, whose probes are done after 20 updates.
  void PrepareLitRoom()
  {
    this->Scene.Window->SetSize(48, 36);
    this->Probes->SetProbes(216);
    this->Probes->SetUpdates(20);
    this->LookFrom(0.7, 0.6, 0.8, -0.5, -0.6, -0.3);
    this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7);
    this->Lamp->SetIntensity(0.5);
  }

  vtkGIDDGI* Probes = nullptr;
};
}

TEST_F(DDGI, ClosedEnclosureKeepsItsEnergy)
{
  this->Probes->SetProbes(216);
  this->Scene.Window->SetSize(48, 36);
  this->LookFrom(0.7, 0.6, 0.8, -0.5, -0.6, -0.3);
  for (const double albedo : { 0.5, 0.8 })
  {
    constexpr double emission = 0.1;
    vtkActor* room = this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, albedo);
    room->GetProperty()->SetAmbient(emission);
    const Values values = this->After(384);
    const double expected = emission / (1.0 - albedo);
    const double largest = LargestError(values, expected);
    std::printf("reflectance %.1f: radiosity %.5f of %.5f, largest error %.2f %%\n", albedo,
      Mean(values), expected, 100.0 * largest);
    EXPECT_LT(largest, 0.0045);
    this->Scene.Renderer->RemoveActor(room);
  }
}

// A panel of side w and radiance L at height h gives a floor, at distance r from the point below it, the irradiance
// L w^2 h^2 / (h^2 + r^2)^2. A ray of a probe rarely meets it, so it must be sought.
TEST_F(DDGI, ASmallPanelLightsSmoothly)
{
  constexpr double reflectance = 0.8;
  constexpr double side = 0.05;
  constexpr double radiance = 1.0;
  constexpr double height = 1.5;
  Paint(AddFloor(this->Scene, -1.0, 1.0, -1.0, 1.0), reflectance);
  vtkActor* panel =
    Paint(AddFloor(this->Scene, -side / 2, side / 2, -side / 2, side / 2, height), 0.0);
  panel->GetProperty()->SetAmbient(radiance);
  this->Probes->SetProbes(1000);
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera(); // below the panel
  camera->SetPosition(0.0, 0.0, 0.5);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewAngle(90.0);
  camera->SetClippingRange(0.01, 20.0);
  const Values values = this->After(8);
  double largest = 0.0;
  for (int i = 0; i < 96 * 72; ++i)
  {
    const double x = (i % 96 + 0.5 - 48.0) / 72.0;
    const double y = (i / 96 + 0.5 - 36.0) / 72.0;
    const double square = height * height + x * x + y * y;
    const double expected =
      reflectance * radiance * std::pow(side * height / square, 2.0) / vtkMath::Pi();
    largest = std::max(largest, std::abs(values[i] / expected - 1.0));
  }
  std::printf("light of a small panel: largest error %.2f %%\n", 100.0 * largest);
  EXPECT_LT(largest, 0.25);
}

TEST_F(DDGI, ABudgetOfRaysSpreadsAnUpdateOverFrames)
{
  this->Probes->SetProbes(216);
  this->Probes->SetUpdates(60);
  this->Scene.Window->SetSize(48, 36);
  this->LookFrom(0.7, 0.6, 0.8, -0.5, -0.6, -0.3);
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.5)->GetProperty()->SetAmbient(0.1);
  // One probe more than a third, so that an update ends in the middle of a frame.
  this->Probes->SetRaysPerFrame(73 * this->Probes->GetRays());
  this->After(30);
  EXPECT_EQ(this->Probes->GetUpdatesDone(this->Scene.Renderer), 10);
  EXPECT_FALSE(this->Probes->IsFinished(this->Scene.Renderer));
  this->After(this->Probes->GetRequiredFrames() - 31);
  EXPECT_FALSE(this->Probes->IsFinished(this->Scene.Renderer));
  const Values values = this->After(1);
  EXPECT_TRUE(this->Probes->IsFinished(this->Scene.Renderer));
  for (const double value : values)
  {
    ASSERT_NEAR(value, 0.2, 0.02 * 0.2);
  }
  this->Probes->SetRaysPerFrame(1); // fewer than one probe needs
  EXPECT_EQ(this->Probes->GetRequiredFrames(), 60 * 216);
}

// While only the camera and its headlight move, four frames share an update. After any other change each frame updates all probes.
TEST_F(DDGI, FramesOfAMovingCameraShareUpdates)
{
  this->PrepareLitRoom();
  this->Probes->SetSlices(4);
  const auto updatesAfter = [this](int frames) {
    this->After(frames);
    return this->Probes->GetUpdatesDone(this->Scene.Renderer);
  };
  this->Lamp->SetLightTypeToHeadlight();
  EXPECT_EQ(updatesAfter(20), 20);
  this->Scene.Renderer->GetActiveCamera()->Azimuth(3.0);
  EXPECT_EQ(updatesAfter(4), 1);
  // The camera's matrix moves a camera light without modifying it.
  this->Lamp->SetLightTypeToCameraLight();
  EXPECT_EQ(updatesAfter(20), 20);
  this->Scene.Renderer->GetActiveCamera()->Azimuth(3.0);
  EXPECT_EQ(updatesAfter(3), 0);
  EXPECT_EQ(updatesAfter(1), 1);
  EXPECT_EQ(updatesAfter(4), 2);
  this->Lamp->SetIntensity(0.8);
  EXPECT_EQ(updatesAfter(10), 10);
  // So do the first frames after it, even if the camera moves.
  this->Lamp->SetIntensity(0.5);
  EXPECT_EQ(updatesAfter(1), 1);
  this->Scene.Renderer->GetActiveCamera()->Azimuth(3.0);
  EXPECT_EQ(updatesAfter(4), 4);
}

TEST_F(DDGI, RestartDiscardsEarlierFrames)
{
  this->PrepareLitRoom();
  vtkActor* block = this->AddBox(-0.8, -0.2, -0.8, -0.2, -1.0, 0.2, 0.9);
  block->GetProperty()->SetColor(1.0, 0.05, 0.05);
  for (const int budget : { 0, 50 }) // probes per frame, which the frame after a restart ignores
  {
    this->Probes->SetRaysPerFrame(budget * this->Probes->GetRays());
    block->VisibilityOn();
    this->After(20);
    block->VisibilityOff();
    this->Pass->Restart();
    const Values kept = this->After(1);
    EXPECT_EQ(this->Probes->GetUpdatesDone(this->Scene.Renderer), 20);
    EXPECT_TRUE(this->Probes->IsFinished(this->Scene.Renderer));
    this->Pass->ReleaseGraphicsResources(this->Scene.Window);
    this->Pass->Restart();
    const Values fresh = this->After(1);
    double largest = 0.0;
    for (std::size_t i = 0; i < fresh.size(); ++i)
    {
      largest = std::max(largest, std::abs(kept[i] - fresh[i]));
    }
    std::printf("after the block is hidden: largest error %.6f, mean %.4f\n", largest, Mean(fresh));
    EXPECT_GT(Mean(fresh), 0.1);
    EXPECT_LT(largest, 1e-4);
  }
}

TEST_F(DDGI, APictureThatStandsAloneIgnoresTheBudget)
{
  this->PrepareLitRoom();
  this->Pass->CollectStatisticsOn();
  std::vector<Values> pictures;
  for (const int budget : { 0, 10 }) // probes per frame
  {
    this->Probes->SetRaysPerFrame(budget * this->Probes->GetRays());
    this->Pass->Restart();
    pictures.push_back(this->After(1));
    const std::string statistics = this->Pass->GetStatistics();
    int updates = 0;
    for (std::size_t at = 0;
         (at = statistics.find("\"ddgi-blend-distances\"", at)) != std::string::npos; ++at)
    {
      ++updates;
    }
    EXPECT_EQ(updates, 20);
  }
  EXPECT_EQ(pictures[0], pictures[1]);
}

TEST_F(DDGI, ARoomNextDoorStaysDark)
{
  this->Scene.Window->SetSize(48, 36);
  this->Lamp->SetIntensity(1.0);
  struct Wall
  {
    double Thickness;
    int Probes; ///< with 180, some are a 30th of a cell from the wall
  };
  for (const auto& [thickness, probes] : { Wall{ 0.1, 512 }, { 0.02, 512 }, { 0.02, 180 } })
  {
    this->Probes->SetProbes(probes);
    const auto rooms = this->AddTwoRooms(thickness);
    this->LookFrom(-1.8, -0.8, 0.8, -0.5, 0.5, -0.5);
    const double bright = Mean(this->After(60));
    this->Pass->GetTechnique("ddgi")->EnabledOff();
    const double direct = Mean(this->After(1));
    this->Pass->GetTechnique("ddgi")->EnabledOn();
    int counts[3];
    this->Probes->GetGrid(this->Scene.Renderer, counts);
    this->LookFrom(1.8, -0.8, 0.8, 0.5, 0.5, -0.5);
    this->Pass->GetTechnique("shadow-maps")->EnabledOn();
    // From the first update on, while probes still move to their positions.
    this->Probes->SetProbes(probes + 1);
    this->After(1);
    this->Probes->SetProbes(probes);
    double largest = 0.0, brightest = 0.0;
    Values dark;
    for (int frame = 0; frame < 60; ++frame)
    {
      dark = this->After(1);
      largest = std::max(largest, Mean(dark));
      brightest = std::max(brightest, *std::max_element(dark.begin(), dark.end()));
    }
    this->Pass->GetTechnique("shadow-maps")->EnabledOff();
    std::printf("wall of %.2f, cells of %.2f: lit room's indirect light %.4f, dark room %.6f "
                "(%.3f %%), at any time at most %.6f, any pixel %.6f\n",
      thickness, 4.0 / (counts[0] - 2), bright - direct, Mean(dark),
      100.0 * Mean(dark) / (bright - direct), largest, brightest);
    EXPECT_LT(thickness, 0.5 * 4.0 / (counts[0] - 2));
    EXPECT_LT(largest, 3e-5 * (bright - direct));
    EXPECT_LT(brightest, 1.2e-3 * (bright - direct));
    for (vtkActor* room : rooms)
    {
      this->Scene.Renderer->RemoveActor(room);
    }
  }
}

TEST_F(DDGI, LightSwitchedOnOrOffArrivesEquallySoon)
{
  this->Probes->SetProbes(216);
  this->Scene.Window->SetSize(48, 36);
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7);
  this->Lamp->SetPosition(0.3, -0.2, 0.4);
  this->Lamp->SetIntensity(1.0);
  this->LookFrom(0.7, 0.6, 0.8, -0.5, -0.6, -0.3);
  const auto indirect = [this] { return Mean(this->After(1)); };
  for (const int rays : { 128, 64 }) // the default, and those of the preset high
  {
    this->Probes->SetRays(rays);
    this->Lamp->SetIntensity(1.0);
    this->After(200);
    const double lit = indirect();
    this->Probes->EnabledOff();
    const double direct = indirect();
    this->Probes->EnabledOn();
    this->After(100);
    const double full = lit - direct;
    EXPECT_GT(full, 0.2 * direct);
    this->Lamp->SetIntensity(0.0);
    int off = 0;
    while (indirect() > 0.1 * full && off < 100)
    {
      ++off;
    }
    this->After(100);
    EXPECT_LT(indirect(), 0.01 * full);
    this->Lamp->SetIntensity(1.0);
    int on = 0;
    while (indirect() - direct < 0.9 * full && on < 100)
    {
      ++on;
    }
    std::printf("%d rays: 90 %% after %d updates when the light goes off, %d when it comes on\n",
      rays, off + 1, on + 1);
    EXPECT_LE(off + 1, 3);
    EXPECT_LE(on + 1, 3);
  }
}

TEST_F(DDGI, ASceneAtRestDoesNotFlicker)
{
  this->Probes->SetProbes(343);
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7);
  this->AddBox(-0.6, 0.0, -0.6, 0.0, -1.0, 0.2, 0.5);
  this->Lamp->SetPosition(0.3, -0.2, 0.7);
  this->Lamp->SetIntensity(1.0);
  this->LookFrom(0.7, 0.6, 0.8, -0.5, -0.6, -0.3);
  this->After(20);
  const double with = Mean(this->After(1));
  this->Probes->EnabledOff();
  EXPECT_GT(with, 1.1 * Mean(this->After(1)));
  this->Probes->EnabledOn();
  this->After(150);
  std::vector<Values> frames;
  for (int i = 0; i < 100; ++i)
  {
    frames.push_back(this->After(1));
  }
  double largest = 0.0;
  double sum = 0.0;
  for (std::size_t pixel = 0; pixel < frames.front().size(); ++pixel)
  {
    double mean = 0.0;
    double squares = 0.0;
    for (const auto& frame : frames)
    {
      mean += frame[pixel] / 100.0;
      squares += frame[pixel] * frame[pixel] / 100.0;
    }
    const double deviation = std::sqrt(std::max(squares - mean * mean, 0.0)) / std::max(mean, 1e-6);
    largest = std::max(largest, deviation);
    sum += deviation;
  }
  std::printf(
    "frames 151 to 250: deviation of a pixel %.4f %% of its mean on average, %.4f %% at most\n",
    100.0 * sum / static_cast<double>(frames.front().size()), 100.0 * largest);
  EXPECT_LT(sum / static_cast<double>(frames.front().size()), 0.0003);
  EXPECT_LT(largest, 0.00105);
}

TEST_F(DDGI, OcclusionIsCountedOnce)
{
  this->Probes->SetProbes(343);
  this->Probes->SetUpdates(40);
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7);
  this->AddBox(-0.6, 0.0, -0.6, 0.0, -1.0, 0.2, 0.5);
  this->Lamp->SetPosition(0.3, -0.2, 0.7);
  this->Lamp->SetIntensity(1.0);
  this->LookFrom(0.7, 0.6, 0.8, -0.5, -0.6, -0.3);
  const double without = Mean(this->After(41));
  vtkGITechnique* occlusion = this->Pass->GetTechnique("ambient-occlusion");
  occlusion->EnabledOn();
  const double with = Mean(this->After(1));
  this->Probes->EnabledOff();
  occlusion->EnabledOff();
  const double direct = Mean(this->After(1));
  const double removed = 1.0 - (with - direct) / (without - direct);
  std::printf("ambient occlusion removes %.2f %% of the indirect light\n", 100.0 * removed);
  EXPECT_GT(removed, 0.0005); // creases finer than the probes resolve
  EXPECT_LT(removed, 0.04);
}

// In a closed box of emission E and reflectance r every probe holds E / (1 - r), and a white ball displays it. Indirect
// light of the walls is off, so that balls differ from them.
TEST_F(DDGI, BallsShowTheLightOfVisibleProbes)
{
  constexpr double emission = 0.1;
  constexpr double albedo = 0.5;
  this->Probes->SetProbes(216);
  this->Probes->SetIntensity(0.0);
  this->Scene.Window->SetSize(96, 72);
  this->LookFrom(0.7, 0.6, 0.8, -0.5, -0.6, -0.3);
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, albedo)->GetProperty()->SetAmbient(emission);
  const auto countBalls = [&](int frames) {
    const double expected = emission / (1.0 - albedo);
    double largest = 0.0;
    int lit = 0;
    int resting = 0;
    this->Probes->SetShow(false);
    this->After(frames);
    this->Probes->SetShow(true);
    this->After(1);
    vtkNew<vtkImageData> image;
    EXPECT_TRUE(this->Pass->GetRadiance(this->Scene.Renderer, image));
    vtkDataArray* colors = image->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
    {
      const double* color = colors->GetTuple(i);
      resting += color[2] > 0.9 && color[0] == 0.0;
      if (color[0] > 1.5 * emission && color[2] < 0.9)
      {
        ++lit;
        largest =
          std::max(largest, std::abs((color[0] + color[1] + color[2]) / (3.0 * expected) - 1.0));
      }
    }
    std::printf(
      "pixels of balls %d, largest error against E / (1 - r) %.2f %%; pixels of blue rims %d\n",
      lit, 100.0 * largest, resting);
    EXPECT_LT(largest, 0.0015);
    return std::make_pair(lit, resting);
  };
  const auto [lit, resting] = countBalls(100);
  EXPECT_GT(lit, 100);
  EXPECT_GT(resting, 10); // in the middle of the room
  // A board in front hides most balls.
  this->AddBox(0.5, 0.6, -1.0, 1.0, -1.0, 1.0, albedo)->GetProperty()->SetAmbient(emission);
  EXPECT_LT(countBalls(30).first, lit / 3);
}
