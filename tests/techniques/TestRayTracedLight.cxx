// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Light by rays from each pixel: against closed forms and the path tracer, leaks, and hostile emitters.
 */
#include "RoomStage.h"

#include <cstdio>
#include <limits>

using namespace penumbra_test;

namespace
{
class RayTracedLight : public RoomStage
{
protected:
  void SetUp() override
  {
    this->Prepare("ray-traced-light", Width, Height);
    this->Pass->GetTechnique("temporal-accumulation")->EnabledOn();
  }

  void AddProbes(int probes)
  {
    this->Pass->GetTechnique("ddgi")->EnabledOn();
    this->Pass->GetTechnique("ddgi")->SetParameter("probes", probes);
  }

  vtkActor* AddPanel(double side, double height, double radiance)
  {
    vtkActor* panel =
      Paint(AddFloor(this->Scene, -side / 2, side / 2, -side / 2, side / 2, height), 0.0);
    panel->GetProperty()->SetAmbient(radiance);
    return panel;
  }

  /// Look straight down at the plane z = 0 from z = 0.5.
  void LookDown()
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 0.5);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewAngle(90.0);
    camera->SetClippingRange(0.01, 20.0);
  }

  Values Traced(int paths)
  {
    this->Pass->SetPreset("reference");
    this->Pass->KeepRadianceOn();
    return this->After(paths);
  }

  static constexpr int Width = 96;
  static constexpr int Height = 72;
};
}

// Reflectance r and emission e all around add up to e / (1 - r).
TEST_F(RayTracedLight, ClosedEnclosureKeepsItsEnergy)
{
  this->Scene.Window->SetSize(48, 36);
  this->AddProbes(216);
  this->LookFrom(0.7, 0.6, 0.8, -0.5, -0.6, -0.3);
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.5)->GetProperty()->SetAmbient(0.1);
  const Values values = this->After(200);
  std::printf("radiosity %.5f of 0.2, largest error %.2f %%\n", Mean(values),
    100.0 * LargestError(values, 0.2));
  EXPECT_NEAR(Mean(values), 0.2, 0.003 * 0.2);
  EXPECT_LT(LargestError(values, 0.2), 0.04);
}

// A panel of side w and radiance L at height h gives a floor, at distance r from the point below it, the irradiance
// L w^2 h^2 / (h^2 + r^2)^2, if w is small.
TEST_F(RayTracedLight, OfASmallPanelOnAFloor)
{
  constexpr double side = 0.05;
  constexpr double height = 1.5;
  Paint(AddFloor(this->Scene, -1.0, 1.0, -1.0, 1.0), 0.8);
  this->AddPanel(side, height, 1.0);
  this->LookDown();
  const Values values = this->After(32);
  double largest = 0.0;
  for (int i = 0; i < Width * Height; ++i)
  {
    const double x = (i % Width + 0.5 - Width / 2) / Height;
    const double y = (i / Width + 0.5 - Height / 2) / Height;
    const double square = height * height + x * x + y * y;
    const double expected = 0.8 * std::pow(side * height / square, 2.0) / vtkMath::Pi();
    largest = std::max(largest, std::abs(values[i] / expected - 1.0));
  }
  std::printf("light of a small panel: largest error %.2f %%\n", 100.0 * largest);
  EXPECT_LT(largest, 0.02);
}

// A lamp and a panel in a room: with probes for further bounces the light is that of paths, which probes alone miss.
TEST_F(RayTracedLight, WithProbesEqualsPaths)
{
  this->AddProbes(512);
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.7)->GetProperty()->SetColor(1.0, 0.7, 0.4);
  this->AddBox(-0.7, -0.2, -0.6, -0.1, -1.0, 0.1, 0.6);
  this->AddPanel(0.4, 0.999, 1.0);
  this->Pass->GetTechnique("ray-traced-light")->SetParameter("rays", 4);
  this->Lamp->SetPosition(0.8, 0.8, -0.5);
  this->Lamp->SetIntensity(0.1);
  this->Pass->GetTechnique("ray-traced-shadows")->EnabledOn();
  this->LookFrom(0.9, 0.8, 0.3, -0.5, -0.5, -0.4);
  const Values drawn = this->After(96);
  this->Pass->GetTechnique("ray-traced-light")->EnabledOff();
  const Values probes = this->After(96);
  const Values truth = this->Traced(512);
  const double error = RelativeSquaredError(drawn, truth);
  const double ofProbes = RelativeSquaredError(probes, truth);
  std::printf("relMSE %.5f, of probes alone %.5f; mean %.4f of %.4f\n", error, ofProbes,
    Mean(drawn), Mean(truth));
  EXPECT_LT(error, 0.002);
  EXPECT_LT(error, 0.65 * ofProbes);
  EXPECT_NEAR(Mean(drawn), Mean(truth), 0.02 * Mean(truth));
}

// Metal in uniform light is as bright as that light, whether reflections are found or not. Indirect light replaces reflections
// that are not found, and must not be added to those that are.
TEST_F(RayTracedLight, IsReflectedByMetalOnce)
{
  this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.0)->GetProperty()->SetAmbient(0.5);
  vtkProperty* metal = AddFloor(this->Scene, -0.9, 0.9, -0.9, 0.9, -0.9)->GetProperty();
  metal->SetInterpolationToPBR();
  metal->SetColor(1.0, 1.0, 1.0);
  metal->SetMetallic(1.0);
  metal->SetRoughness(0.2);
  this->LookFrom(0.7, 0.6, 0.0, 0.1, 0.1, -0.9);
  vtkGITechnique* reflections = this->Pass->GetTechnique("screen-space-reflections");
  reflections->EnabledOn();
  for (const char* fallback : { "environment", "rays" })
  {
    reflections->SetParameterFromText("fallback", fallback);
    const Values drawn = this->After(16);
    double sum = 0.0;
    for (int y = 24; y < 48; ++y) // the middle of the picture, where the metal is
    {
      for (int x = 32; x < 64; ++x)
      {
        sum += drawn[y * Width + x];
      }
    }
    const double mean = sum / (24 * 32);
    std::printf("metal in uniform light, fallback %s: %.4f of 0.5\n", fallback, mean);
    EXPECT_NEAR(mean, 0.5, 0.03 * 0.5);
  }
}

TEST_F(RayTracedLight, DoesNotLeakIntoAClosedRoom)
{
  this->AddProbes(512);
  this->AddTwoRooms(0.02);
  this->Lamp->SetIntensity(1.0);
  this->Pass->GetTechnique("ray-traced-shadows")->EnabledOn();
  this->LookFrom(-0.2, 0.8, 0.8, -1.5, -0.6, -0.3);
  const double lit = Mean(this->After(8));
  this->LookFrom(1.8, 0.8, 0.8, 0.3, -0.6, -0.3);
  const double dark = Mean(this->After(8));
  std::printf("next door: %.5f of %.4f\n", dark, lit);
  EXPECT_GT(lit, 0.1);
  EXPECT_LT(dark, 1e-3 * lit);
}

TEST_F(RayTracedLight, SurvivesHostileEmitters)
{
  Paint(AddFloor(this->Scene, -1.0, 1.0, -1.0, 1.0), 0.8);
  this->LookDown();
  EXPECT_EQ(Mean(this->After(2)), 0.0); // none
  vtkActor* panel = this->AddPanel(0.5, 1.5, 1.0);
  panel->SetScale(0.0, 1.0, 1.0);
  EXPECT_LT(Mean(this->After(2)), 1e-3); // without area
  panel->SetScale(1.0, 1.0, 1.0);
  const double usual = Mean(this->After(8));
  EXPECT_GT(usual, 0.0);
  panel->GetProperty()->SetAmbientColor(1e30, 1.0, 1.0);
  EXPECT_TRUE(std::isfinite(Mean(this->After(2))));
  panel->GetProperty()->SetAmbientColor(std::numeric_limits<double>::quiet_NaN(), 1.0, 1.0);
  EXPECT_TRUE(std::isfinite(Mean(this->After(2))));
  this->Pass->GetTechnique("ray-traced-light")->SetParameter("intensity", 10.0);
  panel->GetProperty()->SetAmbientColor(1e30, 1.0, 1.0);
  EXPECT_TRUE(std::isfinite(Mean(this->After(2))));
  this->Pass->GetTechnique("ray-traced-light")->SetParameter("intensity", 1.0);
  panel->GetProperty()->SetAmbientColor(1.0, 1.0, 1.0);
  EXPECT_NEAR(Mean(this->After(8)), usual, 0.02 * usual);
  EXPECT_STREQ(this->Pass->GetLastError(), "");
}
