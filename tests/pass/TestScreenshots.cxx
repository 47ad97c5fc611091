// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Pictures of vtkWindowToImageFilter: alpha, depth, and large pictures in tiles.
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

void ExpectStock(const Options& options, bool glass)
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

TEST(Screenshots, EqualStock)
{
  ExpectStock({ 1, false, false }, true);
}

TEST(Screenshots, WithTransparentBackgroundEqualStock)
{
  ExpectStock({ 1, true, false }, true);
}

TEST(Screenshots, OfDepthEqualStock)
{
  ExpectStock({ 1, false, true }, false);
}

TEST(Screenshots, AtTwiceTheSizeEqualStock)
{
  ExpectStock({ 2, false, false }, false);
}

TEST(Screenshots, AtThreeTimesTheSizeWithAlphaEqualStock)
{
  ExpectStock({ 3, true, false }, false);
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

// Tiles with shadows and ambient occlusion fit together, as in a window of the whole size.
TEST(Screenshots, TilesFitTogether)
{
  const auto prepare = [](Scene& scene) {
    // The default depends on the size of the scene in the picture.
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

// Joined tiles equal the picture of a window of the whole size, also with screen-space techniques, glass and alpha.
void ExpectJoined(const Options& options, bool parallel)
{
  const auto prepare = [&](Scene& scene) {
    scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    vtkGIPass* pass = Prepare(scene, "high");
    pass->GetTechnique("ddgi")->EnabledOff(); // it changes from frame to frame
    return pass;
  };
  Scene small(false);
  vtkGIPass* pass = prepare(small);
  pass->JoinTilesOn();
  const auto tiled = Capture(small, options);
  // The tiles leave no trace in the next frame.
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

TEST(Screenshots, JoinedTilesEqualTheWholePicture)
{
  ExpectJoined({ 3, false, false }, false);
}

TEST(Screenshots, JoinedTilesWithAlphaInParallelProjectionEqualTheWholePicture)
{
  ExpectJoined({ 2, true, false }, true);
}

// A layer is drawn over the layers below, which a separate picture would not contain.
TEST(Screenshots, LayersAreNotJoined)
{
  const auto prepare = [](Scene& scene, bool mixed) {
    scene.Window->SetNumberOfLayers(2);
    vtkRenderer* above = scene.AddRenderer();
    above->SetLayer(1);
    above->SetPreserveDepthBuffer(mixed); // tests against the depth below
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

// Number of textures as wide as a picture of three times the window's size.
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
    if (glGetError() == GL_NO_ERROR) // a texture of this target
    {
      glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    }
    count += width == 960;
  }
  glBindTexture(GL_TEXTURE_2D, 0);
  return count;
}

// The pass releases its textures some frames after their last use.
int CountWideTexturesLater(vtkRenderWindow* window)
{
  for (int i = 0; i < 20; ++i)
  {
    window->Render();
  }
  return CountWideTextures(window);
}

TEST(Screenshots, JoinedTilesAreReleasedInLaterFrames)
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

TEST(Screenshots, JoinedTilesAreReleasedWithTheirRenderer)
{
  Scene scene(false);
  const vtkSmartPointer<vtkGIPass> pass = scene.SetPass();
  pass->JoinTilesOn();
  Capture(scene, { 3, false, false });
  EXPECT_GE(CountWideTextures(scene.Window), 2);
  vtkRenderer* other = scene.AddRenderer();
  other->AddActor(scene.Ball);
  other->SetPass(pass);
  scene.Renderer->SetPass(nullptr); // or the renderer would release everything when it goes
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
