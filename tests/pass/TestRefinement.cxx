// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Frames that are drawn while the user does nothing: how many, when they stop and start over, and that nothing is kept alive.
// Timers fire only when a test says so.
#include "Scenes.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkGIRefinement.h"
#include "vtkGenericRenderWindowInteractor.h"

#include <chrono>
#include <functional>
#include <set>
#include <thread>

using namespace penumbra_test;

namespace
{
constexpr int Frames = 5;
constexpr int MostRounds = 200;

/// A scene with an interactor whose timers are kept in a set.
struct RefinedScene : public Scene
{
  RefinedScene()
    : Pass(this->SetPass())
    , Interactor(vtkSmartPointer<vtkGenericRenderWindowInteractor>::New())
    , Refinement(vtkSmartPointer<vtkGIRefinement>::New())
  {
    this->Pass->SetPreset("balanced");
    this->Interactor->AddObserver(vtkCommand::CreateTimerEvent, this, &RefinedScene::OnCreate);
    this->Interactor->AddObserver(vtkCommand::DestroyTimerEvent, this, &RefinedScene::OnDestroy);
    this->Interactor->SetRenderWindow(this->Window);
    this->Interactor->Enable();
    this->Refinement->SetInteractor(this->Interactor);
    this->Refinement->SetPass(this->Pass);
    this->Refinement->SetFrames(Frames);
    this->Refinement->SetPause(1);
    this->Window->AddObserver(vtkCommand::EndEvent, this, &RefinedScene::OnFrame);
  }

  void OnCreate() { this->Timers.insert(this->Interactor->GetTimerEventId()); }
  void OnDestroy()
  {
    this->Timers.erase(this->Interactor->GetTimerEventPlatformId());
    this->Destroyed.insert(this->Interactor->GetTimerEventPlatformId());
  }
  void OnFrame() { ++this->Drawn; }

  /// Let the timers that are set now fire. Returns the number of frames drawn.
  int Fire()
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(this->Refinement ? 2 : 0));
    const int before = this->Drawn;
    for (int timer : std::set<int>(this->Timers))
    {
      this->Interactor->InvokeEvent(vtkCommand::TimerEvent, &timer);
      EXPECT_EQ(this->Destroyed.count(timer), 0u) << "VTK on X11 still uses it";
      this->Timers.erase(timer); // fires once
    }
    return this->Drawn - before;
  }
  /// Let timers fire until there are none. Returns the number of frames drawn.
  int FireAll()
  {
    const int before = this->Drawn;
    for (int round = 0; !this->Timers.empty(); ++round)
    {
      if (round == MostRounds)
      {
        ADD_FAILURE() << "it does not stop";
        break;
      }
      this->Fire();
    }
    return this->Drawn - before;
  }
  int Averaged() { return this->Pass->GetAccumulatedFrames(this->Renderer); }
  void Turn()
  {
    this->Renderer->GetActiveCamera()->Azimuth(1.0);
    this->Window->Render();
  }

  std::set<int> Destroyed;
  std::set<int> Timers; ///< before the interactor, which destroys its last ones
  int Drawn = 0;
  vtkSmartPointer<vtkGIPass> Pass;
  vtkSmartPointer<vtkGenericRenderWindowInteractor> Interactor;
  vtkSmartPointer<vtkGIRefinement> Refinement;
};

/// Calls a function in each event of an object, while it lives.
struct Watch
{
  Watch(vtkObject* object, unsigned long event, std::function<void()> function)
    : Function(std::move(function))
    , Object(object)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<Watch*>(self)->Function(); });
    object->AddObserver(event, this->Command);
  }
  ~Watch() { this->Object->RemoveObserver(this->Command); }

  std::function<void()> Function;
  vtkSmartPointer<vtkObject> Object;
  vtkNew<vtkCallbackCommand> Command;
};
}

TEST(Refinement, DrawsUntilThePictureIsFinished)
{
  RefinedScene scene;
  EXPECT_FALSE(scene.Refinement->IsActive()) << "before the first frame";
  scene.Window->Render();
  EXPECT_TRUE(scene.Refinement->IsActive());
  EXPECT_EQ(scene.FireAll(), Frames - 1);
  EXPECT_EQ(scene.Averaged(), Frames);
  EXPECT_FALSE(scene.Refinement->IsActive());
  scene.Window->Render();
  EXPECT_TRUE(scene.Timers.empty()) << "the same picture is finished";
}

TEST(Refinement, StartsOverWhenTheUserChangesSomething)
{
  RefinedScene scene;
  scene.Window->Render();
  EXPECT_EQ(scene.Fire(), 1);
  EXPECT_EQ(scene.Fire(), 1);
  scene.Turn();
  EXPECT_EQ(scene.Timers.size(), 1u) << "one timer at a time";
  EXPECT_EQ(scene.FireAll(), Frames - 1);
  EXPECT_EQ(scene.Averaged(), Frames);
  scene.Pass->GetTechnique("ambient-occlusion")->SetParameter("samples", 9);
  scene.Window->Render();
  EXPECT_EQ(scene.FireAll(), Frames - 1);
}

TEST(Refinement, WaitsWhileTheUserTurnsTheScene)
{
  RefinedScene scene;
  scene.Refinement->SetPause(10000);
  for (int i = 0; i < 10; ++i)
  {
    scene.Turn();
    EXPECT_EQ(scene.Timers.size(), 1u);
    EXPECT_EQ(scene.Fire(), 0);
  }
  scene.Refinement->SetPause(1);
  EXPECT_EQ(scene.FireAll(), Frames - 1);
}

TEST(Refinement, GivesBackWhatABudgetHasLowered)
{
  RefinedScene scene;
  scene.Pass->SetFrameBudget(1.0);
  for (int i = 0; i < 4; ++i)
  {
    scene.Turn();
  }
  EXPECT_TRUE(scene.Pass->HasLoweredSettings(scene.Renderer));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  const int drawn = scene.FireAll();
  EXPECT_FALSE(scene.Pass->HasLoweredSettings(scene.Renderer));
  EXPECT_EQ(scene.Averaged(), Frames);
  EXPECT_GE(drawn, Frames);
  EXPECT_LE(drawn, Frames + 8);
}

TEST(Refinement, StopsWhereNothingIsEverFinished)
{
  RefinedScene scene;
  const Watch restless(
    scene.Window, vtkCommand::StartEvent, [&] { scene.Renderer->GetActiveCamera()->Azimuth(1.0); });
  scene.Window->Render();
  const int drawn = scene.FireAll();
  EXPECT_GE(drawn, Frames);
  EXPECT_LE(drawn, Frames + 16);
}

TEST(Refinement, DoesNotDrawWithinAFrame)
{
  RefinedScene scene;
  int inside = 0;
  int most = 0;
  {
    const Watch begin(scene.Renderer, vtkCommand::StartEvent, [&] {
      most = std::max(most, ++inside);
      scene.Fire();
    });
    const Watch end(scene.Renderer, vtkCommand::EndEvent, [&] { --inside; });
    scene.Window->Render();
    scene.Turn();
    EXPECT_EQ(scene.Drawn, 2);
    scene.Fire();
  }
  EXPECT_EQ(most, 1);
  scene.FireAll();
  EXPECT_EQ(scene.Averaged(), Frames);
}

TEST(Refinement, StopsWithoutThePass)
{
  RefinedScene scene;
  scene.Window->Render();
  scene.Renderer->SetPass(nullptr);
  EXPECT_EQ(scene.FireAll(), 0);
  scene.Window->Render();
  EXPECT_TRUE(scene.Timers.empty());
  scene.Renderer->SetPass(scene.Pass);
  scene.Turn();
  EXPECT_EQ(scene.Fire(), 1);
  scene.Refinement->Stop();
  EXPECT_TRUE(scene.Timers.empty());
  scene.Turn();
  EXPECT_EQ(scene.Fire(), 1);
  scene.Refinement->SetPass(nullptr);
  EXPECT_TRUE(scene.Timers.empty());
}

TEST(Refinement, FollowsTheInteractorToAnotherWindow)
{
  RefinedScene scene;
  Stage other;
  scene.Window->Render();
  EXPECT_EQ(scene.Timers.size(), 1u);
  scene.Interactor->SetRenderWindow(other.Window);
  scene.Turn();
  EXPECT_TRUE(scene.Timers.empty());
  scene.Turn();
  EXPECT_TRUE(scene.Timers.empty());
  other.Renderer->SetPass(scene.Pass);
  scene.Interactor->Render();
  EXPECT_EQ(scene.Timers.size(), 1u);
  const int before = scene.Drawn;
  scene.FireAll();
  EXPECT_EQ(scene.Drawn, before) << "the first window";
  EXPECT_EQ(scene.Pass->GetAccumulatedFrames(other.Renderer), Frames);
}

TEST(Refinement, OutlivesAndIsOutlivedInAnyOrder)
{
  for (int order = 0; order < 6; ++order)
  {
    RefinedScene scene;
    scene.Turn();
    scene.Fire();
    ASSERT_EQ(scene.Timers.size(), 1u);
    const std::function<void()> removals[] = { [&] {
                                                scene.Renderer->SetPass(nullptr);
                                                scene.Pass = nullptr;
                                                if (scene.Refinement)
                                                {
                                                  EXPECT_EQ(scene.Refinement->GetPass(), nullptr)
                                                    << "kept alive";
                                                }
                                              },
      [&] {
        scene.Timers.clear();
        scene.Window->SetInteractor(nullptr);
        scene.Interactor = nullptr;
        if (scene.Refinement)
        {
          EXPECT_EQ(scene.Refinement->GetInteractor(), nullptr) << "kept alive";
        }
      },
      [&] { scene.Refinement = nullptr; } };
    const int orders[6][3] = { { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 }, { 1, 2, 0 }, { 2, 0, 1 },
      { 2, 1, 0 } };
    for (const int removal : orders[order])
    {
      removals[removal]();
      if (scene.Interactor)
      {
        EXPECT_EQ(scene.Fire(), 0);
      }
      scene.Window->Render();
      if (scene.Refinement)
      {
        EXPECT_FALSE(scene.Refinement->IsActive());
      }
    }
  }
}

TEST(Refinement, MayBeDeletedByAnObserverOfItsFrame)
{
  RefinedScene scene;
  scene.Window->Render();
  const Watch watch(scene.Window, vtkCommand::StartEvent, [&] { scene.Refinement = nullptr; });
  EXPECT_EQ(scene.Fire(), 1);
  EXPECT_EQ(scene.FireAll(), 0);
}
