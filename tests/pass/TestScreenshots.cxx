// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkWindowToImageFilter: alpha, tiled large pictures, depth.
#include "Scenes.h"

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

// Tiles with shadows and occlusion on fit together: as a window of that size.
TEST(Screenshots, TilesFitTogether)
{
  const auto prepare = [](Scene& scene) {
    vtkGIPass* pass = scene.SetPass();
    pass->SetPreset("balanced");
    // The scene's size in the picture decides the default.
    pass->GetTechnique("ambient-occlusion")->SetParameter("radius", 0.3);
    scene.Glass->VisibilityOff();
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(-2.0, 4.0, 3.0);
    scene.Renderer->AddLight(light);
  };
  Scene small(false);
  prepare(small);
  const auto tiled = Capture(small, { 2, false, false });
  Scene large(false);
  large.Window->SetSize(640, 480);
  prepare(large);
  const auto whole = Capture(large, { 1, false, false });
  const auto* a = static_cast<unsigned char*>(tiled->GetScalarPointer());
  const auto* b = static_cast<unsigned char*>(whole->GetScalarPointer());
  const vtkIdType count = 3 * 640 * 480;
  vtkIdType within = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    within += std::abs(a[i] - b[i]) <= 8;
  }
  EXPECT_GE(static_cast<double>(within) / count, 0.98);
}
}
}
