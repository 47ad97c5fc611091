// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Exposure and tone curves: of lit surfaces and volumes, by rasterizer and path tracer alike, and of nothing else.
 */
#include "Messages.h"
#include "Picture.h"
#include "SceneParts.h"
#include "Stage.h"
#include "ToneCurves.h"
#include "WhiteVolume.h"

#include "vtkGITechnique.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

using namespace penumbra_test;

namespace
{
constexpr int Side = 16; // width of a square in pixels

/// Squares in a row that face a camera in parallel projection, lit along the view direction by a light of the scene.
class ToneMapping : public ::testing::Test
{
protected:
  void SetUp() override
  {
    if (!HasBackend())
    {
      GTEST_SKIP() << "the backend is not available";
    }
    vtkRenderer* renderer = this->Scene.Renderer;
    renderer->AutomaticLightCreationOff();
    renderer->SetBackground(0.9, 0.3, 1.0);
    this->Pass = this->Scene.SetPasses().front();
    this->Tone = this->Pass->GetTechnique("tone-mapping");
    ASSERT_NE(this->Tone, nullptr);
    this->Light = AddLight(this->Scene, 0.0, 0.0, 10.0);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5);
    camera->SetPosition(0.0, 0.0, 10.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    this->Show();
  }

  void TearDown() override { EXPECT_TRUE(TakeMessages().empty()); }

  /// Show the squares so far, each Side pixels wide, and one more that is background.
  void Show()
  {
    this->Scene.Window->SetSize((this->Count + 1) * Side, Side);
    this->Scene.Renderer->GetActiveCamera()->SetFocalPoint(0.5 * this->Count, 0.0, 0.0);
    this->Scene.Renderer->GetActiveCamera()->SetPosition(0.5 * this->Count, 0.0, 10.0);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  vtkProperty* AddSquare(double r, double g, double b, bool pbr = false)
  {
    const double x = this->Count++;
    vtkProperty* property =
      AddQuad(this->Scene, { x - 0.5, -0.5, 0.0 }, { x + 0.5, -0.5, 0.0 }, { x - 0.5, 0.5, 0.0 })
        ->GetProperty();
    property->SetColor(r, g, b);
    property->SetAmbient(0.0);
    if (pbr)
    {
      property->SetInterpolationToPBR();
      property->SetRoughness(1.0);
      property->SetBaseIOR(1.0); // no highlight
    }
    this->Show();
    return property;
  }

  std::array<int, 4> Square(int number) const
  {
    return this->Last.At(number * Side + Side / 2, Side / 2);
  }

  const Picture& Draw(bool on, const char* curve = "neutral", double exposure = 0.0)
  {
    this->Tone->SetEnabled(on);
    EXPECT_TRUE(this->Tone->SetParameterFromText("curve", curve)) << this->Tone->GetLastError();
    EXPECT_TRUE(this->Tone->SetParameter("exposure", exposure));
    this->Last = Shoot(this->Scene.Window);
    return this->Last;
  }

  int Count = 0;
  Stage Scene;
  vtkSmartPointer<vtkGIPass> Pass;
  vtkGITechnique* Tone = nullptr;
  vtkLight* Light = nullptr;
  Picture Last;
};
}

// Direct light maps what it draws, unless a later pass needs linear values.
TEST_F(ToneMapping, OfDirectLightEqualsThatOfAPass)
{
  this->AddSquare(0.8, 0.4, 0.2);
  this->AddSquare(0.8, 0.4, 0.2, true);
  this->AddSquare(1.0, 1.0, 1.0)->LightingOff();
  this->Light->SetIntensity(3.0);
  this->Pass->CollectStatisticsOn();
  vtkGITechnique* smooth = this->Pass->GetTechnique("anti-aliasing");
  ASSERT_TRUE(smooth->SetParameterFromText("mode", "accumulate"));
  std::array<int, 4> squares[2][4];
  for (const bool apart : { false, true })
  {
    smooth->SetEnabled(apart);
    this->Draw(true, "filmic", -1.0);
    const std::string passes = this->Pass->GetStatistics();
    EXPECT_EQ(passes.find("tone-mapping") != std::string::npos, apart);
    for (int number = 0; number < 4; ++number)
    {
      squares[apart][number] = this->Square(number); // their edges are filtered
    }
  }
  for (int number = 0; number < 4; ++number)
  {
    for (int channel = 0; channel < 4; ++channel)
    {
      EXPECT_NEAR(squares[0][number][channel], squares[1][number][channel], 1) << number;
    }
  }
}

TEST_F(ToneMapping, FollowsTheCurveAtEachExposure)
{
  const glm::dvec3 color(0.8, 0.4, 0.2);
  this->AddSquare(color.r, color.g, color.b);
  this->AddSquare(color.r, color.g, color.b, true);
  constexpr double pi = 3.14159265358979;
  for (const double intensity : { 0.5, 1.0, 3.0 })
  {
    this->Light->SetIntensity(intensity);
    for (const double exposure : { -1.0, 0.0, 1.0 })
    {
      const glm::dvec3 linear = color * intensity * std::pow(2.0, exposure);
      for (const char* curve : { "none", "neutral", "filmic" })
      {
        this->Draw(true, curve, exposure);
        for (int c = 0; c < 3; ++c)
        {
          const auto mapped = [&](const glm::dvec3& x, double fresnel) {
            return *curve == 'f' ? Filmic(x[c])
              : curve[1] == 'e'  ? Neutral(x, fresnel)[c]
                                 : std::min(x[c], 1.0);
          };
          EXPECT_NEAR(this->Square(0)[c], 255.0 * mapped(linear, 0.0), 2.5)
            << curve << ", exposure " << exposure << ", light " << intensity;
          EXPECT_NEAR(
            this->Square(1)[c], 255.0 * std::pow(mapped(linear / pi, 0.04), 1.0 / 2.2), 2.5)
            << curve << ", exposure " << exposure << ", light " << intensity << ", PBR";
        }
      }
    }
  }
}

TEST_F(ToneMapping, KeepsDataColorsBackgroundAndUnlitProps)
{
  this->AddSquare(0.8, 0.1, 0.5);
  this->AddSquare(0.25, 0.8, 0.0);
  this->AddSquare(1.0, 0.9, 0.2)->LightingOff();
  const Picture off = this->Draw(false);
  const Picture on = this->Draw(true);
  EXPECT_EQ(Compare(on, off, 0).Within, 1.0) << "colours up to 0.8 stay as they are";
  this->Draw(true, "filmic", 3.0);
  EXPECT_EQ(this->Square(2), off.At(2 * Side + Side / 2, Side / 2));
  EXPECT_EQ(this->Square(3), off.At(3 * Side + Side / 2, Side / 2));
  EXPECT_NE(this->Square(0), off.At(Side / 2, Side / 2));
}

TEST_F(ToneMapping, AutomaticExposureDoesNotDependOnTheLights)
{
  this->AddSquare(0.3, 0.2, 0.1);
  this->AddSquare(0.6, 0.6, 0.6);
  this->AddSquare(0.3, 0.2, 0.1, true);
  this->AddSquare(0.0, 0.0, 0.0);
  this->Tone->SetParameter("auto-exposure", 1.0);
  const Picture one = this->Draw(true);
  for (const double factor : { 1e3, 1e-3 })
  {
    this->Light->SetIntensity(factor);
    this->Pass->Restart();
    this->Draw(true);
    const Difference difference = Compare(this->Last, one, 1);
    std::printf("lights times %g: largest difference %d / 255\n", factor, difference.Max);
    EXPECT_EQ(difference.Within, 1.0);
  }
  // A still frame adapts at once; a moving one does not.
  this->Light->SetIntensity(100.0);
  EXPECT_LT(Compare(this->Draw(true), one, 1).Within, 0.9);
  EXPECT_EQ(Compare(this->Draw(true), one, 1).Within, 1.0);
  // Each stop doubles what the automatic exposure gives.
  this->Pass->Restart();
  this->Draw(true, "none", -4.0);
  const int before = this->Square(0)[0];
  EXPECT_GT(before, 20);
  this->Pass->Restart();
  this->Draw(true, "none", -5.0);
  EXPECT_NEAR(this->Square(0)[0], 0.5 * before, 1.0);
}

TEST_F(ToneMapping, AutomaticExposureReachesItsBrightness)
{
  this->AddSquare(0.2, 0.2, 0.2);
  this->Tone->SetParameter("auto-exposure", 1.0);
  for (const double brightness : { 0.3, 0.46 })
  {
    this->Tone->SetParameter("auto-brightness", brightness);
    this->Pass->Restart();
    this->Draw(true);
    EXPECT_NEAR(this->Square(0)[1], 255.0 * brightness, 4.0);
  }
  // Where nothing is lit, nothing changes.
  this->Light->SetIntensity(0.0);
  this->Pass->Restart();
  this->Draw(true);
  EXPECT_EQ(this->Square(0)[1], 0);
}

TEST_F(ToneMapping, MapsTranslucentSurfacesAndVolumes)
{
  vtkProperty* sheet = this->AddSquare(0.9, 0.6, 0.3);
  sheet->SetOpacity(0.6);
  vtkProperty* metal = this->AddSquare(0.9, 0.6, 0.3, true);
  metal->SetOpacity(0.6);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 1.0);
  const auto volume = WhiteVolume(
    0.45, [](double distance) { return distance; }, opacity);
  volume->SetPosition(this->Count++, 0.0, 0.0);
  this->Scene.Renderer->AddVolume(volume);
  this->Show();
  this->Scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  for (const bool automatic : { false, true })
  {
    this->Draw(false);
    const std::array<std::array<int, 4>, 3> off = { { this->Square(0), this->Square(1),
      this->Square(2) } };
    EXPECT_GT(off[2][0], 100);
    // Automatic exposure sees no captured surface here, and stays at 1.
    this->Tone->SetParameter("auto-exposure", automatic);
    this->Draw(true, "none", -1.0);
    EXPECT_NEAR(this->Square(0)[0], 0.5 * off[0][0], 2.0);
    EXPECT_NEAR(this->Square(1)[0], std::pow(0.5, 1.0 / 2.2) * off[1][0], 2.0);
    EXPECT_NEAR(this->Square(2)[0], 0.5 * off[2][0], 3.0);
  }
}

TEST_F(ToneMapping, IsTheSameForThePathTracer)
{
  this->Light->SetIntensity(2.0);
  this->AddSquare(0.8, 0.4, 0.2);
  this->AddSquare(0.8, 0.4, 0.2, true);
  vtkNew<vtkSphereSource> source;
  source->SetCenter(this->Count++, 0.0, 0.0);
  source->SetRadius(0.48);
  source->SetThetaResolution(48);
  source->SetPhiResolution(48);
  this->Scene.Add(source);
  this->Show();
  this->Tone->SetParameter("auto-exposure", 1.0);
  for (const char* curve : { "neutral", "filmic" })
  {
    this->Pass->GetTechnique("anti-aliasing")->EnabledOn();
    this->Pass->GetTechnique("anti-aliasing")->SetParameterFromText("mode", "accumulate");
    for (int i = 0; i < 32; ++i)
    {
      this->Draw(true, curve, 0.7);
    }
    const Picture raster = this->Last;
    Save(raster, std::string("tone-raster-") + curve);
    this->Pass->GetTechnique("path-tracing")->EnabledOn();
    this->Pass->GetTechnique("path-tracing")->SetParameter("bounces", 0.0);
    for (int i = 0; i < 64; ++i)
    {
      this->Draw(true, curve, 0.7);
    }
    this->Pass->GetTechnique("path-tracing")->EnabledOff();
    Save(this->Last, std::string("tone-rays-") + curve);
    // Along outlines the two sample pixels differently.
    int smooth = 0;
    int alike = 0;
    for (int y = 1; y < raster.Height - 1; ++y)
    {
      for (int x = 1; x < raster.Width - 1; ++x)
      {
        const double here = raster.Grey(x, y);
        const bool edge = std::abs(raster.Grey(x - 1, y) - here) > 16.0 ||
          std::abs(raster.Grey(x + 1, y) - here) > 16.0 ||
          std::abs(raster.Grey(x, y - 1) - here) > 16.0 ||
          std::abs(raster.Grey(x, y + 1) - here) > 16.0;
        smooth += !edge;
        alike += !edge && std::abs(this->Last.Grey(x, y) - here) <= 2.0;
      }
    }
    std::printf("%s: %d of %d pixels away from outlines within 2 / 255; %.4f of all\n", curve,
      alike, smooth, Compare(raster, this->Last, 2).Within);
    EXPECT_GT(smooth, 600);
    EXPECT_EQ(alike, smooth);
  }
}

TEST_F(ToneMapping, NumbersThatAreNotFiniteDoNotSpread)
{
  this->Pass->KeepRadianceOn(); // in wide formats
  this->AddSquare(0.4, 0.4, 0.4);
  vtkProperty* infinite = this->AddSquare(0.4, 0.4, 0.4);
  infinite->SetAmbient(1.0);
  infinite->SetAmbientColor(std::numeric_limits<double>::infinity(), 1e30, 1e30);
  vtkProperty* nan = this->AddSquare(0.4, 0.4, 0.4);
  nan->SetAmbient(1.0);
  const double none = std::numeric_limits<double>::quiet_NaN();
  nan->SetAmbientColor(none, none, none);
  this->Tone->SetParameter("auto-exposure", 1.0);
  this->Draw(true);
  this->Draw(true);
  EXPECT_GT(this->Square(0)[0], 0);
  EXPECT_LT(this->Square(0)[0], 200);
  EXPECT_GT(this->Square(1)[1], 250);
  EXPECT_EQ(this->Square(2)[0], 0);
  EXPECT_NEAR(this->Square(3)[1], 77, 1) << "the background";
}
