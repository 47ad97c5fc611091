// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkHeadlessRenderWindow with each of its backends: pictures, sizes, no messages in normal use, and the release of all
// resources.

#include "HeadlessTesting.h"

#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

using namespace penumbra_test;

namespace
{
INSTANTIATE_TEST_SUITE_P(Backends, HeadlessWindow, testing::Values(EGL, OSMesa),
  [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------
TEST_P(HeadlessWindow, NamesBackendAndRenderer)
{
  Window window = MakeWindow(GetParam().Value);
  EXPECT_STREQ(GetParam().Name, window->GetBackendName());
  const std::string description = window->GetDescription();
  EXPECT_EQ(0u, description.find(GetParam().Name)) << description;
  EXPECT_NE(std::string::npos, description.find("OpenGL 4.")) << description;
  EXPECT_STREQ("", window->GetContextError());
  EXPECT_NE(nullptr, window->GetGenericContext());
  EXPECT_NE(nullptr, strstr(window->ReportCapabilities(), "OpenGL version string"));
  int major = 0;
  int minor = 0;
  window->GetOpenGLVersion(major, minor);
  EXPECT_GE(10 * major + minor, 43);
}

TEST_P(HeadlessWindow, DrawsASphere)
{
  Window window = MakeWindow(GetParam().Value);
  window->AddRenderer(MakeScene());
  auto image = Grab(window);
  EXPECT_EQ(Background, At(image, 0, 0));
  // The centre of a sphere under a headlight has the sphere's own colour.
  EXPECT_NEAR(255, Centre(image)[0], 3);
  EXPECT_NEAR(128, Centre(image)[1], 3);
  EXPECT_NEAR(64, Centre(image)[2], 3);
}

// A surfaceless context has no default framebuffer that could be queried.
TEST_P(HeadlessWindow, KnowsTheSizesOfItsBuffers)
{
  Window window = MakeWindow(GetParam().Value);
  EXPECT_EQ(24, window->GetDepthBufferSize());
  window->AddRenderer(MakeScene());
  Grab(window);
  while (glGetError() != GL_NO_ERROR)
  {
  }
  EXPECT_GE(window->GetDepthBufferSize(), 24);
  int rgba[4];
  EXPECT_EQ(32, window->GetColorBufferSizes(rgba));
  EXPECT_EQ(8, rgba[0]);
  EXPECT_EQ(8, rgba[3]);
  EXPECT_EQ(static_cast<GLenum>(GL_NO_ERROR), glGetError());
}

TEST(HeadlessBackends, DrawTheSamePicture)
{
  Window egl = MakeWindow(EGL.Value);
  Window osmesa = MakeWindow(OSMesa.Value);
  testing::internal::CaptureStderr();
  const bool both = egl->SupportsOpenGL() && osmesa->SupportsOpenGL();
  testing::internal::GetCapturedStderr();
  if (!both || !strstr(egl->GetDescription(), "llvmpipe"))
  {
    GTEST_SKIP() << "needs both backends on the same software driver";
  }
  egl->AddRenderer(MakeScene());
  osmesa->AddRenderer(MakeScene());
  EXPECT_EQ(0, LargestDifference(Grab(egl), Grab(osmesa)));
}

TEST_P(HeadlessWindow, FollowsItsSize)
{
  ExpectSilence silence;
  Window window = MakeWindow(GetParam().Value, 64, 48);
  silence.Watch(window);
  window->AddRenderer(MakeScene());
  for (const auto& [width, height] : { std::pair(64, 48), std::pair(301, 97), std::pair(16, 16) })
  {
    window->SetSize(width, height);
    auto image = Grab(window);
    EXPECT_EQ(width, image->GetDimensions()[0]);
    EXPECT_EQ(height, image->GetDimensions()[1]);
    EXPECT_EQ(Background, At(image, 0, 0));
    EXPECT_EQ(Background, At(image, width - 1, height - 1));
    EXPECT_NEAR(255, Centre(image)[0], 3);
  }
}

TEST_P(HeadlessWindow, BehavesAsAnOffscreenWindow)
{
  Window window = MakeWindow(GetParam().Value);
  window->SetOffScreenRendering(0);
  EXPECT_FALSE(window->GetShowWindow());
  EXPECT_TRUE(window->GetOffScreenRendering());
  EXPECT_EQ(8, window->GetMultiSamples());
  EXPECT_EQ(72, window->GetDPI());
  EXPECT_EQ(1920, window->GetScreenSize()[0]);
  EXPECT_EQ(1080, window->GetScreenSize()[1]);
  window->AddRenderer(MakeScene());
  EXPECT_EQ(Background, At(Grab(window), 0, 0));
  // VTK limits the number of samples to the driver's maximum, as in its own windows.
  GLint maximum = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &maximum);
  EXPECT_EQ(std::min(8, maximum), window->GetMultiSamples());
}

TEST_P(HeadlessWindow, MultiSamplesSmoothEdges)
{
  const auto countTones = [](int samples) {
    Window window = MakeWindow(GetParam().Value);
    window->SetMultiSamples(samples);
    auto renderer = vtkSmartPointer<vtkRenderer>::New();
    auto actor = MakeSphere(0, 1, 1, 1);
    actor->GetProperty()->LightingOff();
    renderer->AddActor(actor);
    renderer->ResetCamera();
    window->AddRenderer(renderer);
    auto image = Grab(window);
    int tones = 0;
    for (int x = 0; x < 200; ++x)
    {
      const int value = At(image, x, 75)[0] + At(image, x, 40)[0];
      tones += value != 0 && value != 255 && value != 510;
    }
    return tones;
  };
  EXPECT_EQ(0, countTones(0));
  EXPECT_GT(countTones(4), 0);
}

//------------------------------------------------------------------------------
TEST_P(HeadlessWindow, IsSilentInNormalUse)
{
  ExpectSilence silence;
  Window window = MakeWindow(GetParam().Value);
  silence.Watch(window);

  // Two renderers side by side, one of them peeling translucent spheres.
  auto left = MakeScene();
  left->SetViewport(0, 0, 0.5, 1);
  auto right = MakeScene();
  right->SetViewport(0.5, 0, 1, 1);
  for (int i = 0; i < 3; ++i)
  {
    auto glass = MakeSphere(0.3 * i, 0.2, 0.4 * i, 1);
    glass->GetProperty()->SetOpacity(0.4);
    right->AddActor(glass);
  }
  right->SetMaximumNumberOfPeels(20);
  right->SetOcclusionRatio(0);
  window->SetAlphaBitPlanes(1);
  window->AddRenderer(left);
  window->AddRenderer(right);
  // Peeling and FXAA are tested without multisampling. VTK 9.1 to 9.6 copy a multisampled framebuffer by resolving 32
  // bits of depth to 24, which OpenGL forbids and Mesa rejects, in every kind of window.
  for (const int samples : { 8, 0 })
  {
    window->SetMultiSamples(samples);
    right->SetUseDepthPeeling(samples == 0);
    left->SetUseFXAA(samples == 0);
    window->Render();
    EXPECT_EQ(Background, At(Grab(window), 0, 0));
  }

  // Read back in all the usual ways. A magnified picture is drawn in tiles, and VTK's translucent
  // passes fail in a tile that their renderer does not cover.
  right->RemoveAllViewProps();
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->SetScale(2);
  filter->SetInputBufferTypeToRGBA();
  filter->ReadFrontBufferOff();
  filter->Update();
  EXPECT_EQ(400, filter->GetOutput()->GetDimensions()[0]);
  vtkNew<vtkWindowToImageFilter> depth;
  depth->SetInput(window);
  depth->SetInputBufferTypeToZBuffer();
  depth->Update();
  const auto* z = static_cast<float*>(depth->GetOutput()->GetScalarPointer());
  EXPECT_EQ(1.0f, z[0]);
  EXPECT_LT(z[75 * 200 + 50], 1.0f);

  // Most scripts use an interactor.
  vtkRenderWindowInteractor* interactor = window->MakeRenderWindowInteractor();
  interactor->Initialize();
  interactor->Start();
  window->SetInteractor(nullptr);
}

TEST_P(HeadlessWindow, SelectsAnArea)
{
  ExpectSilence silence;
  Window window = MakeWindow(GetParam().Value);
  silence.Watch(window);
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  auto sphere = MakeSphere(-1, 1, 0, 0);
  renderer->AddActor(sphere);
  renderer->AddActor(MakeSphere(1, 0, 1, 0));
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(0, 0, 99, 149);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  vtkSmartPointer<vtkSelection> selection;
  selection.TakeReference(selector->Select());
  ASSERT_NE(nullptr, selection);
  ASSERT_EQ(1u, selection->GetNumberOfNodes());
  vtkSelectionNode* node = selection->GetNode(0);
  EXPECT_EQ(sphere, node->GetProperties()->Get(vtkSelectionNode::PROP()));
  EXPECT_GT(node->GetSelectionList()->GetNumberOfTuples(), 100);
}

//------------------------------------------------------------------------------
TEST_P(HeadlessWindow, FreesEveryObject)
{
  ExpectSilence silence;
  Window window = MakeWindow(GetParam().Value);
  silence.Watch(window);
  window->SetMultiSamples(0);
  auto renderer = MakeScene();
  auto glass = MakeSphere(0.3, 0, 0, 1);
  glass->GetProperty()->SetOpacity(0.5);
  renderer->AddActor(glass);
  renderer->UseDepthPeelingOn();
  renderer->UseFXAAOn();
  window->AddRenderer(renderer);
  window->Render();
  EXPECT_GT(CountObjects(), 10);

  // Finalize() does this before it destroys the context.
  window->ReleaseGraphicsResources(window);
  window->MakeCurrent();
  EXPECT_EQ(0, CountObjects());

  // The window can draw again, in the same context and in a new one.
  EXPECT_NEAR(255, Centre(Grab(window))[0], 60);
  window->Finalize();
  EXPECT_EQ(nullptr, window->GetGenericContext());
  EXPECT_NEAR(255, Centre(Grab(window))[0], 60);
}

TEST_P(HeadlessWindow, LeavesNoContextBehind)
{
  {
    Window window = MakeWindow(GetParam().Value);
    window->AddRenderer(MakeScene());
    window->Render();
    EXPECT_TRUE(window->IsCurrent());
    window->ReleaseCurrent();
    EXPECT_FALSE(window->IsCurrent());
    window->Render();
    EXPECT_NE(nullptr, glGetString(GL_VERSION));
  }
  EXPECT_EQ(nullptr, glGetString(GL_VERSION));
}

TEST_P(HeadlessWindow, RecreatedFiftyTimesWithoutGrowth)
{
  ExpectSilence silence;
  auto renderer = MakeScene();
  double start = 0;
  for (int i = 0; i < 60; ++i)
  {
    // The first ten windows fill the driver's and VTK's caches.
    if (i == 10)
    {
      start = ResidentMegabytes();
    }
    Window window = MakeWindow(GetParam().Value);
    window->AddRenderer(renderer);
    EXPECT_NEAR(255, Centre(Grab(window))[0], 3);
    window->ReleaseGraphicsResources(window);
    window->MakeCurrent();
    ASSERT_EQ(0, CountObjects());
    window->RemoveRenderer(renderer);
  }
  const double growth = ResidentMegabytes() - start;
  RecordProperty("ResidentMegabytes", std::to_string(start));
  RecordProperty("GrowthMegabytes", std::to_string(growth));
  EXPECT_LT(growth, 4.0);
}
}
