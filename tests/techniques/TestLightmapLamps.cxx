// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lightmaps with the lamps' own light: it counts once, and light that a map cannot hold is drawn as usual.
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
    this->Lamp->SetIntensity(0.8); // differs from its light in the map, to tell the two apart
    this->Wall->GetProperty()->SetDiffuse(
      Half); // drivers do not agree on how to round 0.5 to 8 bits
  }

  // Light that the wall reflects, with a reflectance of one half in 8 bits: of lamps in the map, of the frame's lamp,
  // and indirect.
  static constexpr double Half = 128.0 / 255.0;
  static constexpr double Baked = Half * 0.5;
  static constexpr double Live = Half * 0.8;
  static constexpr double Indirect = Half * 0.6;
};
}

TEST_F(LightmapLamps, LampLightCountsOnce)
{
  this->Bake();
  EXPECT_FALSE(this->Map->HasLampLight());
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), Indirect + Live, 0.002);
  this->Bake(6);
  EXPECT_TRUE(this->Map->HasLampLight());
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), Indirect + Baked, 0.002);
  // Intensity scales indirect light only.
  this->Map->SetIntensity(0.0);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), Baked, 0.002);
  // The lamp does not reach the back of the wall, but the map has light there.
  this->Scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, -5.0);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), Half * 0.3, 0.002);
}

TEST_F(LightmapLamps, HeadlightsAreAdded)
{
  this->Bake(6);
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  head->SetIntensity(0.2);
  this->Scene.Renderer->AddLight(head);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), Half * (0.6 + 0.5 + 0.2), 0.002);
  EXPECT_EQ(this->Notes(), "");
}

TEST_F(LightmapLamps, LampsLightMovingProps)
{
  this->Bake(6);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), Indirect + Baked, 0.002);
  vtkActor* mover = this->AddWall(0.003, 1.0);
  mover->SetPosition(-1.2, 0.0, 0.0);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), Live, 0.002);
  EXPECT_EQ(this->Notes(), "");
  mover->SetPosition(1.2, 0.0, 0.0);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), Indirect + Baked, 0.002);
}

TEST_F(LightmapLamps, AChangedLampIsLiveAtOnce)
{
  this->Bake(6);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), Indirect + Baked, 0.002);
  this->Lamp->SetIntensity(0.3);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), Half * 0.3, 0.002);
  EXPECT_NE(this->Notes().find("light 1 changed its colour or strength"), std::string::npos);
  this->Lamp->SetIntensity(0.8);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), Indirect + Baked, 0.002);
  this->Wall->GetProperty()->SetDiffuse(0.25);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), 0.25 * 0.8, 0.002);
}

// The frame draws the highlight, and a moving prop shadows it.
TEST_F(LightmapLamps, HighlightsKeepTheirShadows)
{
  this->Lamp->SetPosition(3.0, 0.0, 5.0);
  this->Wall->GetProperty()->SetSpecular(0.4);
  this->Wall->GetProperty()->SetSpecularPower(10.0);
  this->Pass->GetTechnique("shadow-maps")->EnabledOn();
  const double x = 0.775; // 1 to the right of the middle
  this->Map->EnabledOff();
  const double cosine = 5.0 / std::sqrt(34.0);
  const double highlight = this->RadianceAt(x, 0.5) - cosine * Live;
  EXPECT_GT(highlight, 0.05);
  this->Map->EnabledOn();
  this->Bake(6);
  const double diffuse = Half * 0.2 + Baked;
  EXPECT_NEAR(this->RadianceAt(x, 0.5), diffuse + highlight, 0.002);
  vtkActor* between = this->AddWall(1.0, 0.6);
  between->SetPosition(1.6, 0.0, 0.0);
  EXPECT_NEAR(this->RadianceAt(x, 0.5), diffuse, 0.002);
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
  EXPECT_LT(this->RadianceAt(beside, 0.5), Indirect + Baked - 0.03);
  this->Map->SetIntensity(0.0);
  EXPECT_NEAR(this->RadianceAt(beside, 0.5), Baked, 0.002);
}

TEST_F(LightmapLamps, PhysicallyBasedSurfacesReflectItLikeLiveLight)
{
  this->Wall->GetProperty()->SetInterpolationToPBR();
  this->Wall->GetProperty()->SetMetallic(0.3);
  this->Wall->GetProperty()->SetRoughness(0.8);
  this->Lamp->SetIntensity(0.5); // the same as in the map
  this->Map->EnabledOff();
  const double live = this->RadianceAt(0.3, 0.6);
  this->Map->EnabledOn();
  this->Map->SetIntensity(0.0);
  this->Bake(6);
  EXPECT_NEAR(this->RadianceAt(0.3, 0.6), live, 0.002 * live);
  EXPECT_GT(live, 0.05);
  this->Lamp->SetIntensity(1.0);
  this->Bake(6);
  const double brighter = this->RadianceAt(0.3, 0.6); // only its highlight is brighter
  EXPECT_GT(brighter, live);
  EXPECT_LT(brighter, 1.4 * live);
}

TEST_F(LightmapLamps, DirectionalMapsFollowTiltedNormals)
{
  this->Bake(24);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), Indirect + Baked, 0.002)
    << "as baked where the normal is as baked";
  const double gain = 2.0 * 0.1 * 0.5; // twice the moment along the tilt
  this->TiltNormals(0.5);
  this->Bake(24);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), Half * (0.6 + gain + 0.5 + gain), 0.002);
  this->TiltNormals(-0.5);
  this->Bake(24);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5),
    Half * (0.6 * std::pow(1.0 - gain / (1.5 * 0.6), 1.5) + 0.5 - gain), 0.002)
    << "a lamp's light falls with the cosine";
}

TEST_F(LightmapLamps, MultisampledWindowsShowLampLight)
{
  this->Scene.Window->SetMultiSamples(8);
  this->Pass->KeepRadianceOff();
  this->Bake(6);
  const Picture picture = Shoot(this->Scene.Window);
  EXPECT_NEAR(picture.Grey(13, 32), (Indirect + Baked) * 255.0, 2.0);
}

// Either both kinds of light are directional or neither is.
TEST_F(LightmapLamps, OtherNumbersOfComponentsAreRefused)
{
  for (const int channels : { 9, 15, 36 })
  {
    EXPECT_FALSE(this->Map->SetBake(this->Surfaces(), Light(channels)));
    EXPECT_NE(std::string(this->Map->GetBakeError()).find("3 or 12 components"), std::string::npos);
  }
}
