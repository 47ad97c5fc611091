// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Life of a pass: windows are created and deleted, passes are shared, set and removed, renders are aborted.
#include "Scenes.h"

#include "gpu/GL.h"

#include "vtkCallbackCommand.h"
#include "vtkImageData.h"

#include <array>
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

TEST(Life, AReleasedPassRendersTheSame)
{
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

TEST(Life, ARendererMayMoveToAnotherWindow)
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
  // And back, after the other window is gone.
  other->RemoveRenderer(scene.Renderer);
  other->Finalize();
  scene.Window->AddRenderer(scene.Renderer);
  ExpectSame(stock, Shoot(scene.Window));
  EXPECT_STREQ(pass->GetLastError(), "");
}

TEST(Life, APassMayOutliveItsWindow)
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

// The window is deleted while its renderer has no pass. The object names in its context are void afterwards.
TEST(Life, AWindowMayBeDeletedBeforeItsPass)
{
  Scene kept;
  SetQuietPreset(kept.SetPass(), "balanced");
  const Picture before = Shoot(kept.Window);
  auto pass = vtkSmartPointer<vtkGIPass>::New();
  {
    Scene scene;
    scene.Renderer->SetPass(pass);
    SetQuietPreset(pass, "balanced");
    Shoot(scene.Window);
    scene.Renderer->SetPass(nullptr);
  }
  kept.Window->Render(); // its context is current when the pass is deleted
  pass = nullptr;
  ExpectSame(before, Shoot(kept.Window));
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

// Release for another window, and with another context current.
TEST(Life, ReleaseLeavesOtherWindowsAlone)
{
  Scene one;
  Scene two;
  vtkGIPass* pass = one.SetPass();
  pass->SetPreset("balanced");
  two.SetPass()->SetPreset("balanced");
  const Picture first = Shoot(one.Window);
  const Picture second = Shoot(two.Window);
  const int frames = pass->GetAccumulatedFrames(one.Renderer);
  EXPECT_GT(frames, 0);
  pass->ReleaseGraphicsResources(two.Window);
  EXPECT_EQ(pass->GetAccumulatedFrames(one.Renderer), frames);
  two.Window->MakeCurrent();
  pass->ReleaseGraphicsResources(one.Window);
  EXPECT_TRUE(two.Window->IsCurrent());
  EXPECT_EQ(pass->GetAccumulatedFrames(one.Renderer), 0);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  ExpectSame(second, Shoot(two.Window));
  ExpectSame(first, Shoot(one.Window));
  pass->ReleaseGraphicsResources(nullptr);
  EXPECT_EQ(pass->GetAccumulatedFrames(one.Renderer), 0);
}

TEST(Life, RadianceHasTheSizeOfItsFrame)
{
  Scene scene;
  vtkGIPass* pass = scene.SetPass();
  pass->KeepRadianceOn();
  scene.Window->SetSize(512, 384);
  scene.Window->Render();
  scene.Window->SetSize(64, 48);
  vtkNew<vtkImageData> radiance;
  ASSERT_TRUE(pass->GetRadiance(scene.Renderer, radiance));
  EXPECT_EQ(radiance->GetDimensions()[0], 512);
  EXPECT_EQ(radiance->GetDimensions()[1], 384);
  // A frame without kept radiance discards that of earlier frames.
  pass->KeepRadianceOff();
  scene.Window->Render();
  EXPECT_FALSE(pass->GetRadiance(scene.Renderer, radiance));
  pass->KeepRadianceOn();
  scene.Window->Render();
  ASSERT_TRUE(pass->GetRadiance(scene.Renderer, radiance));
  EXPECT_EQ(radiance->GetDimensions()[0], 64);
}

// Averaging starts in the frame that first keeps radiance; the brightness does not depend on that frame.
TEST(Life, RadianceMayBeKeptLate)
{
  const auto mean = [](int before, int after, int maximum) {
    Scene scene;
    vtkGIPass* pass = scene.SetPass();
    vtkGITechnique* antiAliasing = pass->GetTechnique("anti-aliasing");
    antiAliasing->EnabledOn();
    antiAliasing->SetParameterFromText("mode", "accumulate");
    antiAliasing->SetParameter("maximum-frames", maximum);
    for (int i = 0; i < before; ++i)
    {
      scene.Window->Render();
    }
    pass->KeepRadianceOn();
    for (int i = 0; i < after; ++i)
    {
      scene.Window->Render();
    }
    vtkNew<vtkImageData> radiance;
    EXPECT_TRUE(pass->GetRadiance(scene.Renderer, radiance));
    const auto* values = static_cast<const float*>(radiance->GetScalarPointer());
    double sum = 0.0;
    for (vtkIdType i = 0; i < 4 * radiance->GetNumberOfPoints(); i += 4)
    {
      sum += values[i] + values[i + 1] + values[i + 2];
    }
    return sum / (3.0 * radiance->GetNumberOfPoints());
  };
  const double expected = mean(0, 8, 8);
  ASSERT_GT(expected, 0.05);
  EXPECT_NEAR(mean(5, 1, 256) / expected, 1.0, 0.01);
  EXPECT_NEAR(mean(5, 3, 256) / expected, 1.0, 0.01);
  EXPECT_NEAR(mean(5, 3, 4) / expected, 1.0, 0.01)
    << "the picture's average is complete, that of radiance is not";
}

TEST(Life, APassMayBeRemovedAndSetAgain)
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
TEST(Life, TwoRenderersMayShareAPass)
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
TEST(Life, TwoWindowsMayShareAPass)
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

// The same with techniques that keep textures and buffers.
TEST(Life, TwoWindowsMayShareAPassWithTechniques)
{
  Scene one;
  Scene two;
  vtkNew<vtkGIPass> pass;
  SetQuietPreset(pass, "balanced");
  one.Renderer->SetPass(pass);
  Shoot(two.Window); // makes the object names in its context differ
  two.Renderer->SetPass(pass);
  const Picture first = Shoot(one.Window);
  const Picture second = Shoot(two.Window);
  ExpectSame(first, second);
  ExpectSame(first, Shoot(one.Window));
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  two.Window->Finalize();
  ExpectSame(first, Shoot(one.Window));
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  EXPECT_STREQ(pass->GetLastError(), "");
}

TEST(Life, AResizedWindowEqualsStock)
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

// VTK's translucent stage and its volumes raise OpenGL errors in a view without pixels, so the pass skips them.
TEST(Life, AViewWithoutPixelsRaisesNoGLError)
{
  Scene scene(false);
  vtkGIPass* pass = scene.SetPass();
  SetQuietPreset(pass, "balanced");
  pass->KeepRadianceOn();
  const Picture first = Shoot(scene.Window);
  vtkNew<vtkImageData> radiance;
  EXPECT_TRUE(pass->GetRadiance(scene.Renderer, radiance));
  for (const std::array<double, 4>& viewport : { std::array<double, 4>{ 0.0, 0.0, 0.001, 1.0 },
         std::array<double, 4>{ 0.0, 0.0, 1.0, 0.001 } })
  {
    scene.Renderer->SetViewport(viewport.data());
    scene.Window->Render();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_FALSE(pass->GetRadiance(scene.Renderer, radiance));
  }
  scene.Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  ExpectSame(first, Shoot(scene.Window));
  EXPECT_TRUE(pass->GetRadiance(scene.Renderer, radiance));
}

// Aborts a render at the first check. VTK checks at most five times a second.
struct RenderAbort
{
  int Checks = 0;
  static void Abort(vtkObject* window, unsigned long, void* self, void*)
  {
    ++static_cast<RenderAbort*>(self)->Checks;
    static_cast<vtkRenderWindow*>(window)->SetAbortRender(1);
  }
};

// Render a frame that is aborted.
void RenderAborted(vtkRenderWindow* window)
{
  RenderAbort observer;
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(RenderAbort::Abort);
  command->SetClientData(&observer);
  const unsigned long tag = window->AddObserver(vtkCommand::AbortCheckEvent, command);
  std::this_thread::sleep_for(std::chrono::milliseconds(250));
  window->Render();
  EXPECT_GE(observer.Checks, 1) << "VTK did not check";
  window->RemoveObserver(tag);
  window->SetAbortRender(0);
}

TEST(Life, TheFrameAfterAnAbortIsComplete)
{
  for (const char* preset : { "off", "balanced" })
  {
    Scene scene;
    vtkGIPass* pass = scene.SetPass();
    SetQuietPreset(pass, preset);
    const Picture whole = Shoot(scene.Window);
    RenderAborted(scene.Window);
    ExpectSame(whole, Shoot(scene.Window));
    EXPECT_STREQ(pass->GetLastError(), "");
  }
}

TEST(Life, NoShadowIsMissingAfterAnAbortedFrame)
{
  const auto prepare = [](Scene& scene) {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(-6.0, 0.5, 1.0);
    light->SetFocalPoint(0.5, 0.0, 0.0);
    scene.Renderer->AddLight(light);
    scene.SetPass()->GetTechnique("shadow-maps")->EnabledOn();
  };
  const auto move = [](Scene& scene) { scene.Ball->SetPosition(-0.2, 0.1, 0.1); };
  Scene fresh;
  prepare(fresh);
  move(fresh);
  const Picture expected = Shoot(fresh.Window);
  Scene scene;
  prepare(scene);
  Shoot(scene.Window);
  move(scene);
  RenderAborted(scene.Window);
  ExpectSame(expected, Shoot(scene.Window), 1.0);
}

TEST(Life, FramesStandAloneOnlyOnceAfterARestart)
{
  Scene one;
  Scene two;
  vtkNew<vtkGIPass> pass;
  vtkGITechnique* probes = pass->GetTechnique("ddgi");
  probes->EnabledOn();
  probes->SetParameter("probes", 27);
  probes->SetParameter("updates", 8);
  pass->CollectStatisticsOn();
  const auto countUpdates = [&pass](Scene& scene) {
    scene.Window->Render();
    const std::string statistics = pass->GetStatistics();
    int updates = 0;
    for (std::size_t at = 0;
         (at = statistics.find("\"ddgi-blend-distances\"", at)) != std::string::npos; ++at)
    {
      ++updates;
    }
    return updates;
  };
  one.Renderer->SetPass(pass);
  two.Renderer->SetPass(pass);
  EXPECT_EQ(countUpdates(one), 1);
  pass->Restart();
  EXPECT_EQ(countUpdates(one), 8);
  EXPECT_EQ(countUpdates(two), 8);
  // In turns: each time the other window's resources go.
  EXPECT_EQ(countUpdates(one), 1);
  EXPECT_EQ(countUpdates(two), 1);
}
}
}
