// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Shadow maps of props that are not opaque: casters with partial coverage, and translucent surfaces and volumes as
 * receivers.
 */
#include "Messages.h"
#include "Picture.h"
#include "SceneParts.h"
#include "Stage.h"

#include "vtkGITechnique.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

using namespace penumbra_test;

namespace
{
/// The camera looks down in parallel projection, x to the right. Light comes from the left at 45 degrees: a caster at
/// height h has its shadow h to the right.
class TranslucentShadows : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Scene.Window->SetSize(400, 200);
    this->Scene.Renderer->AutomaticLightCreationOff();
    this->Pass = this->Scene.SetPasses().front();
    this->Light->SetLightTypeToSceneLight();
    this->Light->SetPosition(-10.0, 0.0, 10.0);
    this->Light->SetFocalPoint(0.0, 0.0, 0.0);
    this->Scene.Renderer->AddLight(this->Light);
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(2.0);
    camera->SetPosition(0.0, 0.0, 10.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
  }

  vtkActor* AddSheet(double left, double right, double height, double opacity)
  {
    vtkActor* sheet = penumbra_test::AddFloor(this->Scene, left, right, -1.0, 1.0, height);
    sheet->GetProperty()->SetColor(1.0, 1.0, 1.0);
    sheet->GetProperty()->SetOpacity(opacity);
    return sheet;
  }
  vtkActor* AddFloor()
  {
    vtkActor* floor = this->AddSheet(-4.0, 4.0, 0.0, 1.0);
    floor->SetScale(1.0, 3.0, 1.0);
    return floor;
  }

  Picture Draw(bool shadows)
  {
    this->Pass->GetTechnique("shadow-maps")->SetEnabled(shadows);
    this->Scene.Renderer->ResetCameraClippingRange();
    return Shoot(this->Scene.Window);
  }
  // Column of the picture at a world x.
  static int Column(double x) { return static_cast<int>(std::lround(200 + 50.0 * x)); }

  Stage Scene;
  vtkNew<vtkLight> Light;
  vtkSmartPointer<vtkGIPass> Pass;
};

struct RatioStatistics
{
  double Mean = 0.0;
  double Deviation = 0.0;
};

// Ratio of two pictures between two columns.
RatioStatistics Ratio(const Picture& a, const Picture& b, int left, int right)
{
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;
  for (int y = 70; y < 130; ++y)
  {
    for (int x = left; x < right; ++x)
    {
      const double ratio = a.Grey(x, y) / b.Grey(x, y);
      sum += ratio;
      squares += ratio * ratio;
      ++count;
    }
  }
  const double mean = sum / count;
  return { mean, std::sqrt(std::max(squares / count - mean * mean, 0.0)) };
}

double LargestDifference(const Picture& a, const Picture& b, int left, int right)
{
  double most = 0.0;
  for (int y = 70; y < 130; ++y)
  {
    for (int x = left; x < right; ++x)
    {
      most = std::max(most, std::abs(a.Grey(x, y) - b.Grey(x, y)));
    }
  }
  return most;
}
}

TEST_F(TranslucentShadows, CastersTransmitTheUncoveredShare)
{
  this->AddFloor();
  vtkActor* sheet = this->AddSheet(-3.0, -1.0, 3.0, 1.0);
  for (const double opacity : { 0.1, 0.25, 0.3, 0.5, 0.7, 0.9, 1.0 })
  {
    sheet->GetProperty()->SetOpacity(opacity);
    const RatioStatistics light =
      Ratio(this->Draw(true), this->Draw(false), Column(0.2), Column(1.8));
    std::printf("opacity %.2f: light %.3f, deviation %.3f\n", opacity, light.Mean, light.Deviation);
    EXPECT_NEAR(light.Mean, 1.0 - opacity, 0.015);
    // Texels set by independent chance would make the filter deviate by 0.2 of the mean.
    EXPECT_LT(light.Deviation, 0.1);
  }
}

TEST_F(TranslucentShadows, LayersTransmitTheProductOfTheirShares)
{
  this->AddFloor();
  constexpr double opacity = 0.4;
  for (int layers = 1; layers <= 4; ++layers)
  {
    const double height = 1.5 + 0.5 * layers;
    this->AddSheet(-height, 2.0 - height, height, opacity);
    const double expected = std::pow(1.0 - opacity, layers);
    const RatioStatistics light =
      Ratio(this->Draw(true), this->Draw(false), Column(0.2), Column(1.8));
    std::printf("%d layers: light %.3f of %.3f\n", layers, light.Mean, expected);
    EXPECT_NEAR(light.Mean, expected, 0.03);
  }
}

TEST_F(TranslucentShadows, TransparentTexelsAreHolesInTheShadow)
{
  this->AddFloor();
  vtkActor* sheet = this->AddSheet(-3.0, -1.0, 3.0, 1.0);
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 4, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int y = 0; y < 4; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      for (int c = 0; c < 4; ++c)
      {
        image->SetScalarComponentFromDouble(x, y, 0, c, c < 3 || x < 32 ? 255.0 : 0.0);
      }
    }
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  sheet->SetTexture(texture);
  const Picture with = this->Draw(true);
  const Picture without = this->Draw(false);
  EXPECT_LT(Ratio(with, without, Column(0.2), Column(0.8)).Mean, 0.001);
  EXPECT_GT(Ratio(with, without, Column(1.2), Column(1.8)).Mean, 0.999);
}

TEST_F(TranslucentShadows, TranslucentSurfacesReceiveShadows)
{
  for (const bool positional : { false, true })
  {
    for (const int interpolation : { VTK_FLAT, VTK_PBR })
    {
      vtkActor* sheet = this->AddSheet(-4.0, 4.0, 0.0, 0.5);
      sheet->GetProperty()->SetAmbient(0.1);
      sheet->GetProperty()->SetInterpolation(interpolation);
      vtkActor* caster = this->AddSheet(-3.0, -1.0, 3.0, 1.0);
      this->Light->SetPositional(positional);
      this->Light->SetConeAngle(120.0);
      // Far away, so that lamp and sun cast the same shadow.
      this->Light->SetPosition(-300.0, 0.0, 300.0);
      const Picture with = this->Draw(true);
      const Picture without = this->Draw(false);
      this->Light->SetIntensity(0.0);
      const Picture dark = this->Draw(false);
      this->Light->SetIntensity(1.0);
      const double inside = LargestDifference(with, dark, Column(0.2), Column(1.8));
      const double outside = LargestDifference(with, without, Column(2.3), Column(3.5));
      std::printf("%s, %s: in shadow %.1f from dark, outside %.1f from lit\n",
        positional ? "lamp" : "sun", interpolation == VTK_PBR ? "PBR" : "Phong", inside, outside);
      EXPECT_LE(inside, 1.0);
      EXPECT_LE(outside, 1.0);
      EXPECT_GT(LargestDifference(with, without, Column(0.2), Column(1.8)), 20.0);
      this->Scene.Renderer->RemoveActor(sheet);
      this->Scene.Renderer->RemoveActor(caster);
    }
  }
}

TEST_F(TranslucentShadows, TranslucentSurfacesDoNotShadowThemselves)
{
  this->AddSheet(-4.0, 4.0, 0.0, 0.5);
  for (const double height : { 10.0, 2.0, 1.0 })
  {
    this->Light->SetPosition(-10.0, 0.0, height);
    EXPECT_LE(
      LargestDifference(this->Draw(true), this->Draw(false), Column(-3.5), Column(3.5)), 1.0);
  }
}

TEST_F(TranslucentShadows, VolumesReceiveShadows)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(33, 17, 17);
  image->SetOrigin(-4.0, -2.0, -2.0);
  image->SetSpacing(0.25, 0.25, 0.125);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    image->GetPointData()->GetScalars()->SetTuple1(i, -p[2] + 0.05 * std::sin(3.0 * p[1]));
  }
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.05f);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.2, 0.0);
  opacity->AddPoint(0.5, 0.6);
  volume->GetProperty()->SetScalarOpacity(opacity);
  vtkNew<vtkColorTransferFunction> white;
  white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  volume->GetProperty()->SetColor(white);
  volume->GetProperty()->ShadeOn();
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.02);
  volume->GetProperty()->SetAmbient(0.1);
  this->Scene.Renderer->AddVolume(volume);
  this->AddSheet(-3.0, -1.0, 3.0, 1.0);
  vtkNew<vtkLight> fill; // of the other type, and not occluded by the sheet
  fill->SetLightTypeToSceneLight();
  fill->SetPosition(300.0, 0.0, 300.0);
  fill->SetFocalPoint(0.0, 0.0, 0.0);
  fill->SetIntensity(0.3);
  fill->SetConeAngle(120.0);
  this->Scene.Renderer->AddLight(fill);
  this->Light->SetPosition(-300.0, 0.0, 300.0);
  this->Light->SetConeAngle(120.0);
  for (const float reduction : { 1.0f, 2.0f })
  {
    mapper->SetImageSampleDistance(reduction);
    for (const bool positional : { false, true })
    {
      this->Light->SetPositional(positional);
      fill->SetPositional(!positional);
      const Picture with = this->Draw(true);
      const Picture without = this->Draw(false);
      this->Light->SetIntensity(0.0);
      const Picture dark = this->Draw(false);
      this->Light->SetIntensity(1.0);
      // The volume's surface is about 0.3 below zero, which moves the shadow that far to the right.
      const double inside = LargestDifference(with, dark, Column(0.8), Column(1.8));
      const double outside = LargestDifference(with, without, Column(3.0), Column(3.5));
      std::printf(
        "%s, pictures reduced %.0f times: in shadow %.1f from dark, outside %.1f from lit\n",
        positional ? "lamp" : "sun", reduction, inside, outside);
      EXPECT_LE(inside, 2.0);
      EXPECT_LE(outside, 2.0);
      EXPECT_GT(LargestDifference(with, without, Column(0.8), Column(1.8)), 20.0);
    }
  }
}
