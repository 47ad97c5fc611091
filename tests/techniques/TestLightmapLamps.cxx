// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lightmaps that hold the lamps' own light: it is there once, and what a map cannot hold is drawn as ever.
 */
#include "LightmapStage.h"

using namespace penumbra_test;

namespace
{
class LightmapLamps : public LightmapTechnique
{
protected:
  void SetUp() override
  {
    LightmapTechnique::SetUp();
    this->Lamp->SetIntensity(0.8); // not what the map has of it: the two are told apart
  }

  // What the wall reflects, a half as bytes have it: of the lamps from the map, of the lamp from the frame.
  static constexpr double Half = 128.0 / 255.0;
  static constexpr double Baked = Half * 0.5;
  static constexpr double Live = Half * 0.8;
  static constexpr double Indirect = Half * 0.6;
};
}

TEST_F(LightmapLamps, TheirLightIsThereOnce)
{
  this->Bake();
  EXPECT_FALSE(this->Map->HasLampLight());
  EXPECT_NEAR(this->At(0.2, 0.5), Indirect + Live, 0.002);
  this->Bake(6);
  EXPECT_TRUE(this->Map->HasLampLight());
  EXPECT_NEAR(this->At(0.2, 0.5), Indirect + Baked, 0.002);
  // The parameter is for indirect light.
  this->Map->SetIntensity(0.0);
  EXPECT_NEAR(this->At(0.2, 0.5), Baked, 0.002);
  // From behind, where the lamp does not shine, but the map says so.
  this->Scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, -5.0);
  EXPECT_NEAR(this->At(0.2, 0.5), Half * 0.3, 0.002);
}

TEST_F(LightmapLamps, WhatFollowsTheCameraIsAdded)
{
  this->Bake(6);
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  head->SetIntensity(0.2);
  this->Scene.Renderer->AddLight(head);
  EXPECT_NEAR(this->At(0.2, 0.5), Half * (0.6 + 0.5 + 0.2), 0.002);
  EXPECT_EQ(this->Notes(), "");
}

TEST_F(LightmapLamps, WhatMovesIsLitByThem)
{
  this->Bake(6);
  EXPECT_NEAR(this->At(0.2, 0.5), Indirect + Baked, 0.002);
  vtkActor* mover = this->AddWall(0.003, 1.0);
  mover->SetPosition(-1.2, 0.0, 0.0);
  EXPECT_NEAR(this->At(0.2, 0.5), Live, 0.002);
  EXPECT_EQ(this->Notes(), "");
  mover->SetPosition(1.2, 0.0, 0.0);
  EXPECT_NEAR(this->At(0.2, 0.5), Indirect + Baked, 0.002);
}

TEST_F(LightmapLamps, AChangedLampIsLiveAtOnce)
{
  this->Bake(6);
  EXPECT_NEAR(this->At(0.2, 0.5), Indirect + Baked, 0.002);
  this->Lamp->SetIntensity(0.3);
  EXPECT_NEAR(this->At(0.2, 0.5), Half * 0.3, 0.002);
  EXPECT_NE(this->Notes().find("light 1 changed its colour or strength"), std::string::npos);
  this->Lamp->SetIntensity(0.8);
  EXPECT_NEAR(this->At(0.2, 0.5), Indirect + Baked, 0.002);
  this->Wall->GetProperty()->SetDiffuse(0.25);
  EXPECT_NEAR(this->At(0.2, 0.5), 0.25 * 0.8, 0.002);
}

// The highlight is the frame's, and what moves takes it away.
TEST_F(LightmapLamps, HighlightsKeepTheirShadows)
{
  this->Lamp->SetPosition(3.0, 0.0, 5.0);
  this->Wall->GetProperty()->SetSpecular(0.4);
  this->Wall->GetProperty()->SetSpecularPower(10.0);
  this->Pass->GetTechnique("shadow-maps")->EnabledOn();
  const double x = 0.775; // 1 to the right of the middle
  this->Map->EnabledOff();
  const double cosine = 5.0 / std::sqrt(34.0);
  const double highlight = this->At(x, 0.5) - cosine * Live;
  EXPECT_GT(highlight, 0.05);
  this->Map->EnabledOn();
  this->Bake(6);
  const double matter = Half * 0.2 + Baked;
  EXPECT_NEAR(this->At(x, 0.5), matter + highlight, 0.002);
  vtkActor* between = this->AddWall(1.0, 0.6);
  between->SetPosition(1.6, 0.0, 0.0);
  EXPECT_NEAR(this->At(x, 0.5), matter, 0.002);
  EXPECT_EQ(this->Notes(), "");
}

TEST_F(LightmapLamps, OcclusionDarkensOnlyIndirectLight)
{
  this->Bake(6);
  vtkNew<vtkCubeSource> cube;
  cube->SetCenter(-1.6, 0.0, 0.5);
  cube->SetXLength(0.4);
  this->Scene.Add(cube);
  auto* occlusion = this->Pass->GetTechnique("ambient-occlusion");
  occlusion->SetParameter("radius", 2.0);
  occlusion->EnabledOn();
  const double beside = 0.5 - 0.5 * 1.3 / (5.0 * std::tan(0.349)); // 0.1 off the cube
  EXPECT_LT(this->At(beside, 0.5), Indirect + Baked - 0.03);
  this->Map->SetIntensity(0.0);
  EXPECT_NEAR(this->At(beside, 0.5), Baked, 0.002);
}

TEST_F(LightmapLamps, MatterOfPbrReflectsItAsItDoesTheLamps)
{
  this->Wall->GetProperty()->SetInterpolationToPBR();
  this->Wall->GetProperty()->SetMetallic(0.3);
  this->Wall->GetProperty()->SetRoughness(0.8);
  this->Lamp->SetIntensity(0.5); // as much as the map has
  this->Map->EnabledOff();
  const double live = this->At(0.3, 0.6);
  this->Map->EnabledOn();
  this->Map->SetIntensity(0.0);
  this->Bake(6);
  EXPECT_NEAR(this->At(0.3, 0.6), live, 0.002 * live);
  EXPECT_GT(live, 0.05);
  this->Lamp->SetIntensity(1.0);
  this->Bake(6);
  const double brighter = this->At(0.3, 0.6); // by its highlight alone
  EXPECT_GT(brighter, live);
  EXPECT_LT(brighter, 1.4 * live);
}

TEST_F(LightmapLamps, DirectionalMapsFollowBentNormals)
{
  this->Bake(24);
  EXPECT_NEAR(this->At(0.2, 0.5), Indirect + Baked, 0.002)
    << "as baked where the normal is as baked";
  const double gain = 2.0 * 0.1 * 0.5; // twice the moment along the turn
  this->LeanNormals(0.5);
  this->Bake(24);
  EXPECT_NEAR(this->At(0.2, 0.5), Half * (0.6 + gain + 0.5 + gain), 0.002);
  this->LeanNormals(-0.5);
  this->Bake(24);
  EXPECT_NEAR(
    this->At(0.2, 0.5), Half * (0.6 * std::pow(1.0 - gain / (1.5 * 0.6), 1.5) + 0.5 - gain), 0.002)
    << "a lamp's light falls with the cosine";
}

TEST_F(LightmapLamps, AMultisampledWindowShowsThem)
{
  this->Scene.Window->SetMultiSamples(8);
  this->Pass->KeepRadianceOff();
  this->Bake(6);
  const Picture picture = Shoot(this->Scene.Window);
  EXPECT_NEAR(picture.Grey(13, 32), (Indirect + Baked) * 255.0, 2.0);
}

// Both pictures of a light and its directions, or neither.
TEST_F(LightmapLamps, OtherComponentsAreRefused)
{
  for (const int channels : { 9, 15, 36 })
  {
    EXPECT_FALSE(this->Map->SetBake(this->Surfaces(), Light(channels)));
    EXPECT_NE(std::string(this->Map->GetBakeError()).find("3 or 12 components"), std::string::npos);
  }
}
