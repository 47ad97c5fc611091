// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Shadow maps: no acne, no contact gap, the right position, every kind of light, and updates.
 */
#include "Messages.h"
#include "Picture.h"
#include "SceneParts.h"
#include "Stage.h"

#include "vtkGIShadowMaps.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

using namespace penumbra_test;

namespace
{
constexpr double Degrees = 3.14159265358979 / 180.0;

class ShadowMaps : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Scene.Window->SetSize(480, 360);
    this->Scene.Renderer->AutomaticLightCreationOff();
    this->Pass = this->Scene.SetPasses().front();
    this->Shadows = vtkGIShadowMaps::SafeDownCast(this->Pass->GetTechnique("shadow-maps"));
    ASSERT_NE(this->Shadows, nullptr);
    this->Shadows->EnabledOn();
  }

  vtkLight* AddLight(double x, double y, double z)
  {
    return penumbra_test::AddLight(this->Scene, x, y, z);
  }

  void AddWhiteFloor(double half)
  {
    AddFloor(this->Scene, -half, half, -half, half)->GetProperty()->SetColor(1.0, 1.0, 1.0);
  }

  vtkActor* AddBox()
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetBounds(-0.5, 0.5, -0.5, 0.5, 0.0, 1.0);
    vtkActor* box = this->Scene.Add(cube);
    box->GetProperty()->SetColor(1.0, 1.0, 1.0);
    return box;
  }

  // Look straight down in parallel projection, x to the right. height is that of the picture in world units.
  void LookDown(double height)
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(height / 2.0);
    camera->SetPosition(0.0, 0.0, 10.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  Picture WithShadows()
  {
    this->Shadows->EnabledOn();
    return Shoot(this->Scene.Window);
  }
  Picture WithoutShadows()
  {
    this->Shadows->EnabledOff();
    return Shoot(this->Scene.Window);
  }

  Stage Scene;
  vtkSmartPointer<vtkGIPass> Pass;
  vtkGIShadowMaps* Shadows = nullptr;
};

// Number of pixels that shadows darken by more than rounding.
int CountDarkened(const Picture& with, const Picture& without)
{
  int count = 0;
  for (int y = 0; y < with.Height; ++y)
  {
    for (int x = 0; x < with.Width; ++x)
    {
      count += with.Grey(x, y) < without.Grey(x, y) - 1.0;
    }
  }
  return count;
}
}

TEST_F(ShadowMaps, FlatReceiversHaveNoAcneFrom0To85Degrees)
{
  this->AddWhiteFloor(2.0);
  Stage::LookAround(this->Scene.Renderer);
  vtkLight* light = this->AddLight(0.0, 0.0, 5.0);
  for (const char* kind : { "directional", "cone", "omnidirectional" })
  {
    light->SetPositional(kind[0] != 'd');
    light->SetConeAngle(kind[0] == 'c' ? 50.0 : 180.0);
    for (int angle = 0; angle <= 85; angle += 5)
    {
      const double a = angle * Degrees;
      light->SetPosition(5.0 * std::sin(a) * 0.8, 5.0 * std::sin(a) * 0.6, 5.0 * std::cos(a));
      const int acne = CountDarkened(this->WithShadows(), this->WithoutShadows());
      std::printf("%-16s %2d degrees: %d acne pixels\n", kind, angle, acne);
      EXPECT_EQ(acne, 0) << kind << " at " << angle << " degrees";
    }
  }
  // The count does find shadows.
  light->SetPosition(4.0, 0.0, 3.0);
  this->AddBox();
  EXPECT_GT(CountDarkened(this->WithShadows(), this->WithoutShadows()), 1000);
}

TEST_F(ShadowMaps, AShadowAt45DegreesBeginsAtTheBoxAndHasTheRightLength)
{
  this->AddWhiteFloor(2.0);
  this->AddBox();
  this->AddLight(-5.0, 0.0, 5.0);
  this->Shadows->SetResolution(256);
  this->LookDown(2.5); // 144 pixels per unit: a texel covers about three pixels
  const Picture with = this->WithShadows();
  const Picture without = this->WithoutShadows();
  // Along the middle row the box's top ends at 0.5 and its shadow at 1.5.
  const double unit = with.Height / 2.5;
  const double texel = std::sqrt(2.0) * 4.0 / 256.0; // the floor seen at 45 degrees fills the map
  const int row = with.Height / 2;
  const int edge = static_cast<int>(with.Width / 2 + 0.5 * unit) + 1;
  int x = edge;
  while (x < with.Width && with.Grey(x, row) > 0.5 * without.Grey(x, row))
  {
    ++x;
  }
  const double gap = (x - edge) / unit / texel;
  while (x < with.Width && with.Grey(x, row) < 0.5 * without.Grey(x, row))
  {
    ++x;
  }
  const double error = std::abs((x - with.Width / 2) / unit - 1.5) / texel;
  std::printf("contact gap %.2f texels, end of the shadow off by %.2f texels\n", gap, error);
  EXPECT_LT(gap, 1.5);
  EXPECT_LT(error, 1.5);
}

// Width of the lit gap between an occluder and its shadow, in texels projected onto the floor. The occluder is a box,
// or a wall thinner than the bias.
TEST_F(ShadowMaps, ContactGapsAreAtMostATexel)
{
  this->AddWhiteFloor(2.0);
  vtkNew<vtkCubeSource> cube;
  this->Scene.Add(cube);
  vtkLight* light = this->AddLight(-5.0, 0.0, 5.0);
  this->Shadows->SetResolution(256);
  this->LookDown(2.5);
  std::printf("%8s %16s %16s\n", "degrees", "box", "thin wall");
  for (int angle = 15; angle <= 75; angle += 15)
  {
    const double a = angle * Degrees;
    light->SetPosition(-5.0 * std::sin(a), 0.0, 5.0 * std::cos(a));
    double gaps[2];
    for (const bool thin : { false, true })
    {
      cube->SetBounds(thin ? -0.001 : -0.5, 0.0, -0.5, 0.5, 0.0, 1.0);
      const Picture with = this->WithShadows();
      const Picture without = this->WithoutShadows();
      // The map fits the floor and the box as seen from the light.
      const double height = 4.0 * std::cos(a) + std::sin(a);
      const double texel = std::max(4.0, height) / 256.0 / std::cos(a);
      int x = with.Width / 2 + 1;
      while (with.Grey(x, with.Height / 2) > 0.5 * without.Grey(x, with.Height / 2))
      {
        ++x;
      }
      gaps[thin] = (x - with.Width / 2 - 1) / (with.Height / 2.5) / texel;
      EXPECT_LE(gaps[thin], 1.0) << angle;
    }
    std::printf("%8d %9.2f texels %9.2f texels\n", angle, gaps[0], gaps[1]);
  }
}

TEST_F(ShadowMaps, ABoxAt45DegreesHasNoAcneOnAnyLitFace)
{
  vtkActor* box = this->AddBox();
  this->AddLight(-5.0, -5.0, 5.0 * std::sqrt(2.0));
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetFocalPoint(0.0, 0.0, 0.5);
  for (double azimuth = 0.0; azimuth < 360.0; azimuth += 45.0)
  {
    for (double turn : { 0.0, 17.0 })
    {
      box->SetOrientation(0.0, 0.0, turn);
      camera->SetPosition(
        3.0 * std::cos(azimuth * Degrees), 3.0 * std::sin(azimuth * Degrees), 2.5);
      this->Scene.Renderer->ResetCameraClippingRange();
      // A convex box cannot shadow its own lit faces.
      EXPECT_EQ(CountDarkened(this->WithShadows(), this->WithoutShadows()), 0)
        << azimuth << " turned " << turn;
    }
  }
}

TEST_F(ShadowMaps, EveryKindOfLightCastsShadows)
{
  this->AddWhiteFloor(3.0);
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.0, 0.0, 1.0);
  ball->SetRadius(0.4);
  ball->SetThetaResolution(40);
  ball->SetPhiResolution(40);
  this->Scene.Add(ball);
  vtkLight* light = this->AddLight(-2.0, 0.0, 3.0);
  light->SetFocalPoint(0.0, 0.0, 1.0); // its ray through the ball meets the floor at x = 1
  this->LookDown(4.0);
  const auto at = [](const Picture& p, double x, double y) {
    const double unit = p.Height / 4.0;
    return p.Grey(
      static_cast<int>(p.Width / 2 + x * unit), static_cast<int>(p.Height / 2 + y * unit));
  };
  for (const char* kind : { "directional", "cone", "wide cone", "omnidirectional" })
  {
    light->SetPositional(kind[0] != 'd');
    light->SetConeAngle(kind[0] == 'c' ? 40.0 : kind[0] == 'w' ? 75.0 : 180.0);
    const Picture picture = this->WithShadows();
    EXPECT_LT(at(picture, 1.0, 0.0), 3.0) << kind;
    EXPECT_GT(at(picture, 1.0, 1.0), 60.0) << kind;
    EXPECT_GT(at(picture, -1.0, 0.0), 60.0) << kind;
  }
}

TEST_F(ShadowMaps, PropsOutOfViewCastShadows)
{
  this->AddWhiteFloor(2.0);
  vtkNew<vtkCubeSource> slab;
  slab->SetBounds(-1.0, 1.0, -1.0, 1.0, 11.0, 11.1); // behind the camera
  this->Scene.Add(slab);
  this->AddLight(0.0, 0.0, 20.0);
  this->LookDown(1.0);
  const Picture picture = this->WithShadows();
  EXPECT_LT(picture.Grey(picture.Width / 2, picture.Height / 2), 3.0);
}

TEST_F(ShadowMaps, ShadowsFollowChangesAndMapsAreKeptOtherwise)
{
  this->AddWhiteFloor(3.0);
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(-0.5, 0.5, -0.5, 0.5, 0.5, 1.0);
  vtkActor* box = this->Scene.Add(cube);
  vtkLight* light = this->AddLight(0.0, 0.0, 5.0);
  light->SetFocalPoint(1.0, 0.0, 0.0);
  this->LookDown(6.0);
  const auto shadowAt = [this](double x) {
    const Picture p = this->WithShadows();
    return p.Grey(static_cast<int>(p.Width / 2 + x * p.Height / 6.0), p.Height / 2) < 3.0;
  };
  EXPECT_TRUE(shadowAt(0.6));
  EXPECT_FALSE(shadowAt(-0.9));
  EXPECT_TRUE(shadowAt(0.6));
  EXPECT_EQ(this->Shadows->GetDrawnMaps(), 0) << "nothing changed";
  box->SetPosition(-1.5, 0.0, 0.0); // the actor
  EXPECT_FALSE(shadowAt(0.6));
  EXPECT_TRUE(shadowAt(-0.9));
  cube->SetBounds(0.0, 0.5, -0.5, 0.5, 0.5, 1.0); // the data
  EXPECT_TRUE(shadowAt(-0.9));
  light->SetPosition(2.0, 0.0, 5.0); // the light
  EXPECT_FALSE(shadowAt(-0.9));
  box->VisibilityOff();
  light->SetPosition(0.0, 0.0, 5.0);
  EXPECT_FALSE(shadowAt(-0.9));
  EXPECT_EQ(this->Shadows->GetDrawnMaps(), 1);
}

TEST_F(ShadowMaps, AMovedLightRedrawsOnlyItsOwnMaps)
{
  this->AddWhiteFloor(3.0);
  this->AddBox();
  this->AddLight(1.0, 2.0, 5.0);
  vtkLight* lamp = this->AddLight(0.1, 0.2, 1.5);
  lamp->PositionalOn();
  lamp->SetConeAngle(180.0);
  vtkLight* spot = this->AddLight(-3.0, 0.0, 4.0);
  spot->PositionalOn();
  spot->SetConeAngle(20.0);
  this->LookDown(6.0);
  const auto drawn = [this] {
    this->WithShadows();
    return this->Shadows->GetDrawnMaps();
  };
  EXPECT_EQ(drawn(), 1 + 6 + 1);
  EXPECT_EQ(drawn(), 0);
  spot->SetPosition(-3.0, 0.5, 4.0);
  EXPECT_EQ(drawn(), 1);
  lamp->SetPosition(0.1, 0.3, 1.5);
  EXPECT_EQ(drawn(), 6);
  lamp->SetIntensity(0.5);
  EXPECT_EQ(drawn(), 0) << "maps do not depend on intensity";
}

TEST_F(ShadowMaps, EveryLightKeepsAMapInLittleMemory)
{
  this->AddWhiteFloor(3.0);
  this->AddBox();
  this->LookDown(6.0);
  for (int i = 0; i < 8; ++i)
  {
    this->AddLight(-3.0 + i, 1.0, 5.0)->SetIntensity(i + 1.0);
  }
  this->Shadows->SetResolution(1024);
  this->Shadows->SetMemory(8); // two maps of 1024 texels
  this->WithShadows();
  EXPECT_EQ(this->Shadows->GetShadowedLights(), 8);
  EXPECT_STREQ(this->Pass->GetNotes(), "");
  this->Shadows->SetResolution(64);
  this->Shadows->SetMemory(1); // maps of 16 KiB each
  this->WithShadows();
  EXPECT_EQ(this->Shadows->GetShadowedLights(), 8);
  this->Shadows->SetResolution(16384);
  this->Shadows->SetMemory(1); // a small part of the requested size
  this->WithShadows();
  EXPECT_EQ(this->Shadows->GetShadowedLights(), 8);
}

TEST_F(ShadowMaps, HeadlightsCastNoShadowsAndSurplusLightsAreCounted)
{
  this->AddWhiteFloor(2.0);
  this->AddBox();
  this->LookDown(4.0);
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  this->Scene.Renderer->AddLight(head);
  EXPECT_EQ(CountDarkened(this->WithShadows(), this->WithoutShadows()), 0);
  this->WithShadows();
  EXPECT_EQ(this->Shadows->GetShadowedLights(), 0);
  for (int i = 0; i < 6; ++i)
  {
    this->AddLight(-3.0 + i, 1.0, 5.0)->SetIntensity(0.1 + 0.1 * i);
  }
  this->Shadows->SetMaximumLights(5);
  this->WithShadows();
  EXPECT_EQ(this->Shadows->GetShadowedLights(), 5);
  EXPECT_EQ(this->Shadows->GetUnshadowedLights(), 1);
  EXPECT_NE(std::string(this->Pass->GetNotes()).find("1 of 6 lights"), std::string::npos);
}
