// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The frame budget of the pass: what it lowers and when, that it leaves no trace in settings and still pictures, and
// that it is no part of a pass without one. Nothing here depends on how fast the machine is.
#include "Scenes.h"

#include "vtkCallbackCommand.h"
#include "vtkMapper.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

using namespace penumbra_test;

namespace
{
// Longer than the pause after which a picture counts as still.
void Rest()
{
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
}

struct BudgetScene : public Scene
{
  explicit BudgetScene(double milliseconds)
    : Pass(this->SetPass())
  {
    this->Pass->SetPreset("balanced");
    this->Pass->CollectStatisticsOn();
    EXPECT_TRUE(this->Pass->SetFrameBudget(milliseconds));
  }

  void Turn(int frames = 1)
  {
    for (int i = 0; i < frames; ++i)
    {
      this->Renderer->GetActiveCamera()->Azimuth(0.5);
      this->Window->Render();
    }
  }
  nlohmann::json Budget() const
  {
    return nlohmann::json::parse(this->Pass->GetStatistics()).value("budget", nlohmann::json());
  }
  /// The level of a technique, counted from the lowest; -1 if it has none.
  int LevelOf(const std::string& technique) const
  {
    const auto budget = this->Budget();
    for (const auto& knob : budget.at("knobs"))
    {
      if (knob.at("technique") == technique)
      {
        return knob.at("level");
      }
    }
    return -1;
  }

  vtkGIPass* Pass;
};
}

TEST(Budget, IsOffByDefaultAndRefusesWhatIsNoBudget)
{
  vtkNew<vtkGIPass> pass;
  EXPECT_EQ(pass->GetFrameBudget(), 0.0);
  EXPECT_TRUE(pass->SetFrameBudget(16.7));
  const double bad[] = { -1.0, 0.5, 1e9, std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity() };
  for (const double milliseconds : bad)
  {
    EXPECT_FALSE(pass->SetFrameBudget(milliseconds));
    const auto messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find("it must be from 1 to 10000"), std::string::npos) << messages[0];
    EXPECT_EQ(pass->GetFrameBudget(), 16.7);
  }
  EXPECT_TRUE(pass->SetFrameBudget(0.0));
}

TEST(Budget, LowersSettingsWhileTheCameraMovesAndNobodySeesIt)
{
  BudgetScene scene(1.0);
  vtkGITechnique* occlusion = scene.Pass->GetTechnique("ambient-occlusion");
  const auto time = occlusion->GetMTime();
  scene.Turn(3);
  EXPECT_EQ(scene.Budget().at("state"), "moving");
  EXPECT_EQ(scene.LevelOf("ambient-occlusion"), 0);
  EXPECT_EQ(scene.LevelOf("shadow-maps"), -1) << "the only light shines from the camera";
  EXPECT_EQ(occlusion->GetParameter("samples"), 28.0);
  EXPECT_EQ(occlusion->GetParameter("resolution"), 0.0);
  EXPECT_EQ(occlusion->GetMTime(), time);
}

TEST(Budget, KeepsWhatTheUserSetsWhileAFrameIsDrawn)
{
  BudgetScene scene(1.0);
  vtkGITechnique* occlusion = scene.Pass->GetTechnique("ambient-occlusion");
  vtkNew<vtkCallbackCommand> user;
  user->SetClientData(occlusion);
  user->SetCallback([](vtkObject*, unsigned long, void* technique, void*) {
    static_cast<vtkGITechnique*>(technique)->SetParameter("samples", 20);
  });
  scene.Turn(3);
  scene.Ball->GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, user);
  scene.Turn();
  EXPECT_EQ(occlusion->GetParameter("samples"), 20.0);
  EXPECT_EQ(occlusion->GetParameter("resolution"), 0.0) << "which the budget had lowered";
}

TEST(Budget, GivesBackTheSettingsInAStillPicture)
{
  BudgetScene scene(1.0);
  BudgetScene free(0.0);
  scene.Turn(3);
  Rest();
  free.Turn(3);
  constexpr int Frames = 24;
  for (int i = 0; i < Frames; ++i)
  {
    scene.Window->Render();
    free.Window->Render();
  }
  EXPECT_EQ(scene.Budget().at("state"), "settled");
  EXPECT_LT(scene.Pass->GetAccumulatedFrames(scene.Renderer), Frames + 1)
    << "frames with lower settings count";
  EXPECT_GE(Compare(Read(scene.Window), Read(free.Window), 1).Within, 0.999);
}

TEST(Budget, MayBeSwitchedOnWhileNothingMoves)
{
  BudgetScene scene(0.0);
  scene.Window->Render();
  scene.Pass->SetFrameBudget(1.0);
  Rest();
  scene.Window->Render();
  EXPECT_EQ(scene.Budget().at("state"), "settled");
  EXPECT_TRUE(scene.Budget().at("knobs").empty()) << "nothing is known of costs";
  scene.Turn(4);
  EXPECT_FALSE(scene.Budget().at("knobs").empty());
}

TEST(Budget, DoesNotApplyToPicturesThatAreStillOnes)
{
  BudgetScene scene(1.0);
  BudgetScene free(0.0);
  for (BudgetScene* each : { &scene, &free })
  {
    each->Pass->GetTechnique("temporal-accumulation")
      ->SetEnabled(false); // keeps earlier frames by design
    each->Turn(4);
  }
  scene.Pass->StillPictureOn();
  scene.Turn();
  free.Turn();
  EXPECT_EQ(scene.Budget().at("state"), "settled");
  EXPECT_EQ(Compare(Read(scene.Window), Read(free.Window), 0).Within, 1.0);
  scene.Pass->StillPictureOff();
  scene.Turn();
  EXPECT_EQ(scene.Budget().at("state"), "moving");
}

TEST(Budget, DoesNotTouchAFrameThatStandsAlone)
{
  BudgetScene scene(1.0);
  BudgetScene free(0.0);
  scene.Turn(3);
  free.Turn(3);
  scene.Pass->Restart();
  free.Pass->Restart();
  EXPECT_EQ(Compare(Shoot(scene.Window), Shoot(free.Window), 0).Within, 1.0);
  EXPECT_TRUE(scene.Budget().is_null());
  // Nor the frames that are averaged with it.
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(Compare(Shoot(scene.Window), Shoot(free.Window), 0).Within, 1.0);
  }
  EXPECT_EQ(scene.Budget().at("state"), "settled");
  scene.Turn();
  EXPECT_EQ(scene.Budget().at("state"), "moving");
}

TEST(Budget, RaisesLevelsThatFit)
{
  BudgetScene scene(10000.0);
  scene.Turn(60);
  const auto budget = scene.Budget();
  for (const auto& knob : budget.at("knobs"))
  {
    EXPECT_EQ(knob.at("level").get<std::size_t>() + 1, knob.at("levels").size())
      << knob.at("technique");
  }
}

TEST(Budget, NeverExceedsTheUsersSettings)
{
  BudgetScene scene(10000.0);
  vtkGITechnique* occlusion = scene.Pass->GetTechnique("ambient-occlusion");
  occlusion->SetParameter("samples", 12);
  occlusion->SetParameterFromText("resolution", "half");
  scene.Turn(40);
  EXPECT_EQ(scene.LevelOf("ambient-occlusion"), 1);
  const auto budget = scene.Budget();
  for (const auto& knob : budget.at("knobs"))
  {
    if (knob.at("technique") == "ambient-occlusion")
    {
      EXPECT_EQ(knob.at("levels").size(), 2u) << "8 samples, and the user's 12";
      EXPECT_EQ(knob.at("levels").back().at("name"), "own settings");
    }
  }
}

TEST(Budget, FollowsTheWindowsDesiredRate)
{
  BudgetScene scene(0.0);
  scene.Pass->UseDesiredUpdateRateOn();
  scene.Window->SetDesiredUpdateRate(0.0001);
  scene.Turn();
  EXPECT_TRUE(scene.Budget().is_null());
  scene.Window->SetDesiredUpdateRate(50.0);
  scene.Turn();
  EXPECT_EQ(scene.Budget().at("milliseconds"), 20.0);
}

TEST(Budget, IsSharedByTheRenderersOfAWindow)
{
  BudgetScene scene(30.0);
  vtkNew<vtkRenderer> second;
  second->SetViewport(0.5, 0.0, 1.0, 1.0);
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  second->SetPass(scene.Pass);
  scene.Window->AddRenderer(second);
  scene.Turn();
  EXPECT_EQ(scene.Budget().at("milliseconds"), 15.0);
}

TEST(Budget, IsSharedByBothEyes)
{
  BudgetScene scene(30.0);
  scene.Window->StereoRenderOn();
  scene.Window->SetStereoTypeToRedBlue();
  scene.Turn();
  EXPECT_EQ(scene.Budget().at("milliseconds"), 15.0);
  scene.Window->SetStereoTypeToLeft();
  scene.Turn();
  EXPECT_EQ(scene.Budget().at("milliseconds"), 30.0);
}

TEST(Budget, SaysWhatIsTooExpensive)
{
  BudgetScene scene(1.0);
  int over = 0; // frames in a row
  for (int i = 0; i < 80; ++i)
  {
    scene.Turn();
    over = scene.Budget().at("frame").get<double>() > 1.0 ? over + 1 : 0;
  }
  if (over < 40)
  {
    GTEST_SKIP() << "this machine draws the scene within 1 ms";
  }
  EXPECT_NE(std::string(scene.Pass->GetNotes()).find("of the budget's 1.0 ms"), std::string::npos)
    << scene.Pass->GetNotes();
  scene.Pass->SetFrameBudget(0.0);
  scene.Turn();
  EXPECT_STREQ(scene.Pass->GetNotes(), "");
}
