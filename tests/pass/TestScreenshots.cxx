// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkWindowToImageFilter: alpha, tiled large pictures, depth.
#include "Scenes.h"

#include "gpu/GL.h"

#include "vtkCallbackCommand.h"
#include "vtkWindowToImageFilter.h"

namespace penumbra_test
{
namespace
{
struct Options
{
  int Scale = 1;
  bool Alpha = false;
  bool Depth = false;
};

vtkSmartPointer<vtkImageData> Capture(Scene& scene, const Options& options)
{
  if (options.Alpha)
  {
    scene.Window->SetAlphaBitPlanes(1);
    scene.Renderer->SetBackgroundAlpha(0.0);
  }
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(scene.Window);
  filter->SetScale(options.Scale);
  filter->ReadFrontBufferOff();
  if (options.Alpha)
  {
    filter->SetInputBufferTypeToRGBA();
  }
  if (options.Depth)
  {
    filter->SetInputBufferTypeToZBuffer();
  }
  filter->Update();
  return filter->GetOutput();
}

void ExpectEqual(const Options& options, bool glass)
{
  Scene plain;
  plain.Glass->SetVisibility(glass);
  Scene scene;
  scene.Glass->SetVisibility(glass);
  vtkGIPass* pass = scene.SetPass();
  const auto stock = Capture(plain, options);
  const auto ours = Capture(scene, options);
  ASSERT_EQ(stock->GetDimensions()[0], ours->GetDimensions()[0]);
  EXPECT_EQ(ours->GetDimensions()[0], 320 * options.Scale);
  ASSERT_EQ(stock->GetNumberOfScalarComponents(), ours->GetNumberOfScalarComponents());
  const vtkIdType count = stock->GetPointData()->GetScalars()->GetNumberOfValues();
  const double tolerance = options.Depth ? 1e-5 : 2.0;
  vtkIdType within = 0;
  vtkDataArray* a = stock->GetPointData()->GetScalars();
  vtkDataArray* b = ours->GetPointData()->GetScalars();
  const int components = stock->GetNumberOfScalarComponents();
  for (vtkIdType i = 0; i < count; ++i)
  {
    within += std::abs(a->GetComponent(i / components, i % components) -
                b->GetComponent(i / components, i % components)) <= tolerance;
  }
  EXPECT_GE(static_cast<double>(within) / count, 0.999);
  EXPECT_STREQ(pass->GetLastError(), "");
}

TEST(Screenshots, Plain)
{
  ExpectEqual({ 1, false, false }, true);
}

TEST(Screenshots, TransparentBackground)
{
  ExpectEqual({ 1, true, false }, true);
}

TEST(Screenshots, Depth)
{
  ExpectEqual({ 1, false, true }, false);
}

TEST(Screenshots, TwiceTheSize)
{
  ExpectEqual({ 2, false, false }, false);
}

TEST(Screenshots, ThreeTimesTheSizeWithAlpha)
{
  ExpectEqual({ 3, true, false }, false);
}

vtkGIPass* Prepare(Scene& scene, const char* preset)
{
  vtkGIPass* pass = scene.SetPass();
  pass->SetPreset(preset);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(-2.0, 4.0, 3.0);
  scene.Renderer->AddLight(light);
  return pass;
}

double ShareWithin(vtkImageData* one, vtkImageData* other, int limit)
{
  const auto* a = static_cast<unsigned char*>(one->GetScalarPointer());
  const auto* b = static_cast<unsigned char*>(other->GetScalarPointer());
  const vtkIdType count = one->GetPointData()->GetScalars()->GetNumberOfValues();
  vtkIdType within = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    within += std::abs(a[i] - b[i]) <= limit;
  }
  return static_cast<double>(within) / count;
}

// Tiles with shadows and occlusion on fit together: as a window of that size.
TEST(Screenshots, TilesFitTogether)
{
  const auto prepare = [](Scene& scene) {
    // The scene's size in the picture decides the default.
    Prepare(scene, "balanced")->GetTechnique("ambient-occlusion")->SetParameter("radius", 0.3);
    scene.Glass->VisibilityOff();
  };
  Scene small(false);
  prepare(small);
  const auto tiled = Capture(small, { 2, false, false });
  Scene large(false);
  large.Window->SetSize(640, 480);
  prepare(large);
  const auto whole = Capture(large, { 1, false, false });
  EXPECT_GE(ShareWithin(tiled, whole, 8), 0.98);
}

// Joined ones are the picture of a window of that size, whatever techniques find on the screen; glass and alpha too.
void ExpectJoined(const Options& options, bool parallel)
{
  const auto prepare = [&](Scene& scene) {
    scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    vtkGIPass* pass = Prepare(scene, "high");
    pass->GetTechnique("ddgi")->EnabledOff(); // it knows more with each frame
    return pass;
  };
  Scene small(false);
  vtkGIPass* pass = prepare(small);
  pass->JoinTilesOn();
  const auto tiled = Capture(small, options);
  // What was kept for the tiles does not show in the next frame.
  pass->JoinTilesOff();
  pass->Restart();
  const auto after = Capture(small, { 1, options.Alpha, false });
  Scene large(false);
  large.Window->SetSize(320 * options.Scale, 240 * options.Scale);
  prepare(large);
  const auto whole = Capture(large, { 1, options.Alpha, false });
  ASSERT_EQ(tiled->GetDimensions()[0], whole->GetDimensions()[0]);
  ASSERT_EQ(tiled->GetNumberOfScalarComponents(), whole->GetNumberOfScalarComponents());
  EXPECT_GE(ShareWithin(tiled, whole, 2), 0.999);
  Scene plain(false);
  prepare(plain);
  EXPECT_GE(ShareWithin(after, Capture(plain, { 1, options.Alpha, false }), 2), 0.999);
  EXPECT_STREQ(pass->GetLastError(), "");
}

TEST(Screenshots, JoinedTilesAreTheWholePicture)
{
  ExpectJoined({ 3, false, false }, false);
}

TEST(Screenshots, JoinedTilesWithAlphaInParallelProjection)
{
  ExpectJoined({ 2, true, false }, true);
}

// A layer is drawn onto those below, which a picture of its own would not hold.
TEST(Screenshots, LayersAreNotJoined)
{
  const auto prepare = [](Scene& scene, bool mixed) {
    scene.Window->SetNumberOfLayers(2);
    vtkRenderer* above = scene.AddRenderer();
    above->SetLayer(1);
    above->SetPreserveDepthBuffer(mixed); // with what is below
    above->AddActor(scene.Glass);
    above->SetActiveCamera(scene.Renderer->GetActiveCamera());
    scene.Glass->GetProperty()->SetOpacity(1.0);
    for (vtkGIPass* pass : scene.SetPasses())
    {
      pass->JoinTilesOn();
    }
  };
  for (const bool mixed : { false, true })
  {
    Scene small(false);
    prepare(small, mixed);
    const auto tiled = Capture(small, { 2, false, false });
    Scene large(false);
    large.Window->SetSize(640, 480);
    prepare(large, mixed);
    EXPECT_GE(ShareWithin(tiled, Capture(large, { 1, false, false }), 2), 0.999);
  }
}

// Textures as wide as a picture that is three times as large as the window.
int CountWideTextures(vtkRenderWindow* window)
{
  window->MakeCurrent();
  int count = 0;
  for (GLuint name = 1; name < 4096; ++name)
  {
    if (!glIsTexture(name))
    {
      continue;
    }
    GLint width = 0;
    glBindTexture(GL_TEXTURE_2D, name);
    if (glGetError() == GL_NO_ERROR) // not of another target
    {
      glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    }
    count += width == 960;
  }
  glBindTexture(GL_TEXTURE_2D, 0);
  return count;
}

// What the pass keeps of its own goes after some frames that do not use it.
int CountWideTexturesLater(vtkRenderWindow* window)
{
  for (int i = 0; i < 20; ++i)
  {
    window->Render();
  }
  return CountWideTextures(window);
}

TEST(Screenshots, JoinedTilesAreForgottenWithTheNextFrame)
{
  for (const bool joins : { true, false })
  {
    Scene scene(false);
    vtkGIPass* pass = scene.SetPass();
    pass->JoinTilesOn();
    Capture(scene, { 3, false, false });
    EXPECT_GE(CountWideTextures(scene.Window), 2);
    pass->SetJoinTiles(joins);
    EXPECT_EQ(CountWideTexturesLater(scene.Window), 0) << "joins " << joins;
  }
}

TEST(Screenshots, JoinedTilesAreForgottenWithTheirRenderer)
{
  Scene scene(false);
  const vtkSmartPointer<vtkGIPass> pass = scene.SetPass();
  pass->JoinTilesOn();
  Capture(scene, { 3, false, false });
  EXPECT_GE(CountWideTextures(scene.Window), 2);
  vtkRenderer* other = scene.AddRenderer();
  other->AddActor(scene.Ball);
  other->SetPass(pass);
  scene.Renderer->SetPass(nullptr); // which would forget everything as the renderer goes
  scene.Window->RemoveRenderer(scene.Renderer);
  scene.Renderer = nullptr;
  EXPECT_EQ(CountWideTexturesLater(scene.Window), 0);
}

TEST(Screenshots, JoinedTilesAreDrawnOnceAndCopied)
{
  struct Frames
  {
    int All = 0;
    int Copied = 0;
    static void Count(vtkObject* renderer, unsigned long, void* self, void*)
    {
      auto* pass = vtkGIPass::SafeDownCast(static_cast<vtkRenderer*>(renderer)->GetPass());
      auto* frames = static_cast<Frames*>(self);
      ++frames->All;
      frames->Copied += pass->GetCopiedTile();
    }
  } frames;
  Scene scene(false);
  vtkGIPass* pass = scene.SetPass();
  pass->JoinTilesOn();
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(Frames::Count);
  command->SetClientData(&frames);
  scene.Renderer->AddObserver(vtkCommand::EndEvent, command);
  Capture(scene, { 3, false, false });
  EXPECT_EQ(frames.Copied, 8);
  EXPECT_EQ(frames.All - frames.Copied, 1);
  EXPECT_EQ(pass->GetAccumulatedFrames(scene.Renderer), 1);
  Shoot(scene.Window);
  EXPECT_FALSE(pass->GetCopiedTile());
}
}
}
