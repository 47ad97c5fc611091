// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Windows come and go, passes are shared, set and removed, renders are aborted.
#include "Scenes.h"

#include "vtkCallbackCommand.h"

#include <chrono>
#include <thread>

namespace penumbra_test
{
namespace
{
Picture Stock()
{
  Scene scene;
  return Shoot(scene.Window);
}

TEST(Life, ReleaseAndRenderAgain)
{
  const Picture stock = Stock();
  for (const char* preset : { "off", "balanced" })
  {
    Scene scene;
    vtkGIPass* pass = scene.SetPass();
    SetQuietPreset(pass, preset);
    const Picture first = Shoot(scene.Window);
    for (int i = 0; i < 3; ++i)
    {
      pass->ReleaseGraphicsResources(scene.Window);
      ExpectSame(first, Shoot(scene.Window));
    }
    scene.Window->Finalize();
    ExpectSame(first, Shoot(scene.Window));
    EXPECT_STREQ(pass->GetLastError(), "");
  }
}

TEST(Life, MoveToAnotherWindow)
{
  const Picture stock = Stock();
  Scene scene;
  vtkGIPass* pass = scene.SetPass();
  ExpectSame(stock, Shoot(scene.Window));
  scene.Window->RemoveRenderer(scene.Renderer);
  vtkNew<vtkHeadlessRenderWindow> other;
  other->SetSize(320, 240);
  other->SetMultiSamples(0);
  other->AddRenderer(scene.Renderer);
  ExpectSame(stock, Shoot(other));
  // And back, once the other is gone.
  other->RemoveRenderer(scene.Renderer);
  other->Finalize();
  scene.Window->AddRenderer(scene.Renderer);
  ExpectSame(stock, Shoot(scene.Window));
  EXPECT_STREQ(pass->GetLastError(), "");
}

TEST(Life, PassOutlivesItsWindow)
{
  const Picture stock = Stock();
  auto pass = vtkSmartPointer<vtkGIPass>::New();
  for (int i = 0; i < 3; ++i)
  {
    Scene scene;
    scene.Renderer->SetPass(pass);
    ExpectSame(stock, Shoot(scene.Window));
  }
}

TEST(Life, PassTakenOffAndPutBack)
{
  const Picture stock = Stock();
  Scene scene;
  auto pass = vtkSmartPointer<vtkGIPass>::New();
  for (int i = 0; i < 2; ++i)
  {
    scene.Renderer->SetPass(pass);
    ExpectSame(stock, Shoot(scene.Window));
    scene.Renderer->SetPass(nullptr);
    EXPECT_EQ(Compare(stock, Shoot(scene.Window), 0).Within, 1.0);
  }
}

// One pass, two renderers with their own cameras and sizes.
TEST(Life, SharedByTwoRenderers)
{
  const auto shoot = [](bool withPass, const char* preset) {
    Scene scene;
    vtkRenderer* second = scene.AddRenderer();
    scene.Renderer->SetViewport(0.0, 0.0, 0.6, 1.0);
    second->SetViewport(0.6, 0.3, 1.0, 1.0);
    second->AddActor(scene.Ball);
    Stage::LookAround(second);
    second->GetActiveCamera()->ParallelProjectionOn();
    vtkNew<vtkGIPass> pass;
    SetQuietPreset(pass, preset);
    if (withPass)
    {
      scene.Renderer->SetPass(pass);
      second->SetPass(pass);
    }
    const Picture first = Shoot(scene.Window);
    ExpectSame(first, Shoot(scene.Window));
    EXPECT_STREQ(pass->GetLastError(), "");
    return first;
  };
  ExpectSame(shoot(false, "off"), shoot(true, "off"));
  shoot(true, "balanced");
}

// One pass, two windows in turn.
TEST(Life, SharedByTwoWindows)
{
  const Picture stock = Stock();
  Scene one;
  Scene two;
  vtkNew<vtkGIPass> pass;
  one.Renderer->SetPass(pass);
  two.Renderer->SetPass(pass);
  for (int i = 0; i < 3; ++i)
  {
    ExpectSame(stock, Shoot(one.Window));
    ExpectSame(stock, Shoot(two.Window));
  }
}

TEST(Life, ResizedWindow)
{
  Scene scene;
  scene.SetPass();
  Scene plain;
  for (const auto& size : { std::pair(200, 300), std::pair(500, 120), std::pair(64, 64) })
  {
    scene.Window->SetSize(size.first, size.second);
    plain.Window->SetSize(size.first, size.second);
    ExpectSame(Shoot(plain.Window), Shoot(scene.Window));
  }
}

// VTK asks while it draws whether to go on, but five times a second at most.
struct Impatience
{
  int Questions = 0;
  static void Answer(vtkObject* window, unsigned long, void* self, void*)
  {
    ++static_cast<Impatience*>(self)->Questions;
    static_cast<vtkRenderWindow*>(window)->SetAbortRender(1);
  }
};

TEST(Life, AbortedRenderRecovers)
{
  const Picture stock = Stock();
  for (const char* preset : { "off", "balanced" })
  {
    Scene scene;
    vtkGIPass* pass = scene.SetPass();
    SetQuietPreset(pass, preset);
    const Picture whole = Shoot(scene.Window);
    Impatience impatience;
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(Impatience::Answer);
    command->SetClientData(&impatience);
    const unsigned long tag = scene.Window->AddObserver(vtkCommand::AbortCheckEvent, command);
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
    scene.Window->Render();
    EXPECT_GE(impatience.Questions, 1) << "nobody asked";
    scene.Window->RemoveObserver(tag);
    scene.Window->SetAbortRender(0);
    ExpectSame(whole, Shoot(scene.Window));
    EXPECT_STREQ(pass->GetLastError(), "");
  }
}
}
}
