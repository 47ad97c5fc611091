// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Baked light on surfaces: where it appears, and that it goes when its scene changes.
 */
#include "LightmapStage.h"
#include "FrameCounts.h"

#include <vtkPlane.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

using namespace penumbra_test;

TEST_F(LightmapTechnique, LightAppearsWhereItWasBaked)
{
  this->Bake();
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), 0.5 * 0.6, 0.002);
  EXPECT_NEAR(this->RadianceAt(0.8, 0.5, false), 0.5 * 0.2, 0.002);
  // Seen from behind, the wall has the light of its back.
  this->Scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, -5.0);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), 0.5 * 0.4, 0.002);
  this->Map->SetIntensity(2.0);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), 0.4, 0.002);
}

TEST_F(LightmapTechnique, SlantedAndFarViewsAreFullyLit)
{
  this->Bake();
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  // Every pixel of the wall is lit, in either projection and from any position.
  const double positions[][3] = { { 0.3, 4.5, 0.4 }, { 1.9, 1.0, 0.05 }, { 0.0, 0.0, 900.0 } };
  for (const auto& position : positions)
  {
    for (const bool parallel : { false, true })
    {
      camera->SetParallelProjection(parallel);
      camera->SetPosition(position);
      camera->SetViewUp(1.0, 0.0, 0.0);
      camera->SetFocalPoint(0.0, 0.0, 0.0);
      camera->SetViewAngle(position[2] > 100.0 ? 0.2 : 40.0);
      camera->SetParallelScale(1.5);
      camera->SetClippingRange(
        position[2] > 100.0 ? 890.0 : 0.02, position[2] > 100.0 ? 910.0 : 20.0);
      this->Scene.Window->Render();
      vtkNew<vtkImageData> image;
      ASSERT_TRUE(this->Pass->GetRadiance(this->Scene.Renderer, image));
      int shown = 0, dark = 0;
      for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
      {
        const bool surface = image->GetPointData()->GetScalars()->GetComponent(i, 3) > 0.5;
        const bool lit = image->GetPointData()->GetScalars()->GetComponent(i, 0) > 0.09;
        shown += surface ? 1 : 0;
        dark += surface && !lit ? 1 : 0;
      }
      EXPECT_GT(shown, 100);
      EXPECT_EQ(dark, 0) << position[2] << (parallel ? ", parallel" : "") << " of " << shown;
    }
  }
}

TEST_F(LightmapTechnique, PropsBeforeAWallDoNotGetItsLight)
{
  this->Bake();
  this->ExpectFits();
  vtkActor* mover = this->AddWall(0.003, 1.0);
  mover->SetPosition(-1.2, 0.0, 0.0);
  EXPECT_LT(this->RadianceAt(0.2, 0.5), 0.01) << "close to the wall";
  EXPECT_EQ(this->Notes(), "") << "props unknown to the bake may appear";
  EXPECT_NEAR(this->RadianceAt(0.8, 0.5, false), 0.1, 0.002);
  mover->SetPosition(1.2, 0.0, 0.0);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), 0.3, 0.002);
  EXPECT_LT(this->RadianceAt(0.8, 0.5, false), 0.01);
}

// A second wall, unknown to the map, is visible through the baked one.
TEST_F(LightmapTechnique, PropsSeenThroughAWallDoNotGetItsLight)
{
  this->AddWall(-1.0, 20.0);
  const auto expectNoMap = [this](const char* why) {
    this->Bake();
    EXPECT_LT(this->RadianceAt(0.2, 0.5), 0.01) << why;
    EXPECT_EQ(this->Notes(), "") << why;
  };
  this->Wall->GetProperty()->BackfaceCullingOn();
  this->Bake();
  this->ExpectFits();
  this->Wall->GetProperty()->BackfaceCullingOff();
  this->Wall->GetProperty()->FrontfaceCullingOn();
  expectNoMap("culled");
  this->Wall->GetProperty()->FrontfaceCullingOff();
  vtkNew<vtkPlane> right;
  right->SetNormal(1.0, 0.0, 0.0);
  this->Wall->GetMapper()->AddClippingPlane(right);
  expectNoMap("clipped");
  EXPECT_NEAR(this->RadianceAt(0.8, 0.5), 0.1, 0.002);
  this->Wall->GetMapper()->RemoveAllClippingPlanes();
  this->Wall->GetProperty()->SetOpacity(0.001);
  expectNoMap("translucent");
}

// The map's light shares the target of the ambient term unless a prop has one.
TEST_F(LightmapTechnique, EmissionAndTheMapsLightAddUp)
{
  this->Bake();
  this->ExpectFits();
  vtkActor* beside = this->AddWall(0.1, 0.5);
  beside->GetProperty()->SetAmbient(0.7);
  EXPECT_NEAR(this->RadianceAt(0.5, 0.5), 0.7, 0.005);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5, false), 0.3, 0.002);
  beside->VisibilityOff();
  this->Wall->GetProperty()->SetAmbient(0.25);
  this->Bake();
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), 0.55, 0.005);
  this->Wall->GetProperty()->SetAmbient(0.0);
  this->Wall->GetProperty()->LightingOff();
  this->Bake();
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), 0.5, 0.005) << "drawn unlit";
}

// Two frames differ by an ambient term only. The one without it needs one target less.
TEST_F(LightmapTechnique, TheMapSharesATargetIfNothingHasAnAmbientTerm)
{
  vtkActor* beside = this->AddWall(0.1, 0.5);
  this->Bake();
  this->Pass->CollectStatisticsOn();
  const auto bytes = [this, beside](double ambient) {
    beside->GetProperty()->SetAmbient(ambient);
    this->Bake();
    for (int i = 0; i < 40; ++i) // until unused textures are released
    {
      this->Scene.Window->Render();
    }
    EXPECT_STREQ("", this->Pass->GetNotes());
    return nlohmann::json::parse(this->Pass->GetStatistics())["bytes"].get<int>();
  };
  const int without = bytes(0.0);
  constexpr int target = 64 * 64 * 8; // four half floats a pixel
  EXPECT_EQ(bytes(0.1), without + target);
  EXPECT_EQ(bytes(0.0), without);
}

TEST_F(LightmapTechnique, AMovedWallIsReportedAtOnce)
{
  this->Bake();
  this->ExpectFits();
  this->Wall->SetPosition(0.0, 0.0, 0.01);
  this->ExpectStale("object 1 moved");
  this->Wall->SetPosition(0.0, 0.0, 0.0);
  this->ExpectFits();
  this->Wall->VisibilityOff();
  this->AddWall(0.0, 3.9);
  this->ExpectStale("object 1 ");
}

TEST_F(LightmapTechnique, NoMismatchIsLeftOfABakeThatWasRemoved)
{
  this->Bake();
  this->Wall->SetPosition(0.0, 0.0, 0.01);
  this->ExpectStale("object 1 moved");
  this->Map->SetBake(nullptr);
  this->Scene.Window->Render();
  EXPECT_EQ(this->Map->GetMismatch(this->Scene.Renderer), "");
}

TEST_F(LightmapTechnique, AChangedColourIsReportedAtOnce)
{
  this->Bake();
  this->ExpectFits();
  this->Wall->GetProperty()->SetColor(1.0, 0.99, 1.0);
  this->ExpectStale("object 1 changed its look");
  this->Wall->GetProperty()->SetColor(1.0, 1.0, 1.0);
  this->ExpectFits();
}

TEST_F(LightmapTechnique, ChangedLampsAreReportedAtOnce)
{
  this->Bake();
  this->ExpectFits();
  this->Lamp->SetPosition(0.1, 0.0, 5.0);
  this->ExpectStale("light 1 moved");
  this->Lamp->SetPosition(0.0, 0.0, 5.0);
  this->Lamp->SetDiffuseColor(1.0, 0.9, 1.0);
  this->ExpectStale("light 1 changed its colour");
  this->Lamp->SetDiffuseColor(1.0, 1.0, 1.0);
  this->Lamp->SwitchOff();
  this->ExpectStale("light 1 went out");
  this->Lamp->SwitchOn();
  vtkNew<vtkLight> other;
  other->SetLightTypeToSceneLight();
  other->SetIntensity(0.002);
  this->Scene.Renderer->AddLight(other);
  this->ExpectStale("light 3 came");
  this->Scene.Renderer->RemoveLight(other);
  this->ExpectFits();
}

TEST_F(LightmapTechnique, ChangesMadeWhileDisabledAreReported)
{
  this->Bake();
  this->ExpectFits();
  this->Map->EnabledOff();
  this->Scene.Window->Render();
  this->Wall->SetPosition(0.0, 0.0, 0.5);
  this->Scene.Window->Render();
  this->Scene.Window->Render();
  this->Map->EnabledOn();
  this->ExpectStale("object 1 moved");
}

TEST_F(LightmapTechnique, MovingTheCameraChangesNothing)
{
  this->Bake();
  this->ExpectFits();
  this->Scene.Renderer->GetActiveCamera()->Azimuth(5.0);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), 0.3, 0.002);
  EXPECT_EQ(this->Notes(), "");
}

// DDGI lights the scene in place of a map that no longer fits, as it does without a map.
TEST_F(LightmapTechnique, ProbesReplaceAStaleMap)
{
  this->Bake();
  vtkGITechnique* probes = this->Pass->GetTechnique("ddgi");
  constexpr int updates = 48;
  probes->SetParameter("probes", 64);
  probes->SetParameter("rays", 512);
  probes->SetParameter("updates", updates);
  const auto convergedRadiance = [&] {
    for (int i = 0; i < updates; ++i)
    {
      this->Scene.Window->Render();
    }
    return this->RadianceAt(0.2, 0.5);
  };
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), 0.3, 0.002);
  EXPECT_FALSE(probes->GetTookPart()) << "the map fits";
  // The only indirect light comes from a glowing wall beside the baked one.
  vtkActor* glowing = this->AddWall(0.0, 4.0);
  glowing->SetPosition(-2.0, 0.0, 2.0);
  glowing->RotateY(90.0);
  glowing->GetProperty()->SetAmbient(1.0);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), 0.3, 0.002) << "props unknown to the bake may appear";
  this->Lamp->SetIntensity(0.002);
  const double fallback = convergedRadiance();
  EXPECT_TRUE(probes->GetTookPart());
  EXPECT_NE(this->Map->GetMismatch(this->Scene.Renderer), "");
  this->Map->LiveFallbackOff();
  const double dark = this->RadianceAt(0.2, 0.5);
  EXPECT_FALSE(probes->GetTookPart());
  EXPECT_LT(dark, 0.01);
  EXPECT_GT(fallback, 0.05);
  this->Map->EnabledOff();
  probes->EnabledOn();
  EXPECT_NEAR(convergedRadiance(), fallback, 0.03 * fallback);
  this->Map->EnabledOn();
  this->Map->LiveFallbackOn();
  probes->EnabledOff();
  this->Lamp->SetIntensity(0.001);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), 0.3, 0.002) << "it fits again";
  EXPECT_FALSE(probes->GetTookPart());
}

// Baked walls get their light from the map only, other props from the probes.
TEST_F(LightmapTechnique, ProbesLightPropsUnknownToTheMap)
{
  this->Lamp->SetIntensity(0.5);
  vtkActor* mover = this->AddWall(0.5, 1.0);
  mover->SetPosition(-1.2, 0.0, 0.0);
  vtkActor* beside = this->AddWall(0.0, 3.0);
  beside->SetPosition(-2.0, 0.0, 1.0);
  beside->RotateY(60.0);
  this->Bake();
  vtkGITechnique* probes = this->Pass->GetTechnique("ddgi");
  probes->SetParameter("probes", 64);
  probes->SetParameter("rays", 512);
  constexpr int updates = 24;
  probes->SetParameter("updates", updates);
  // First with a separate target for indirect light, then in the target of the ambient term.
  for (const double ambient : { 0.001, 0.0 })
  {
    beside->GetProperty()->SetAmbient(ambient);
    this->Bake();
    probes->EnabledOff();
    const double unlit = this->RadianceAt(0.22, 0.5);
    const double wall = this->RadianceAt(0.8, 0.5, false);
    EXPECT_NEAR(wall, 0.25 + 0.1, 0.002);
    EXPECT_NEAR(unlit, 0.25, 0.002);
    probes->EnabledOn();
    for (int i = 0; i < updates; ++i)
    {
      this->Scene.Window->Render();
    }
    EXPECT_GT(this->RadianceAt(0.22, 0.5), unlit + 0.005) << ambient;
    EXPECT_NEAR(this->RadianceAt(0.8, 0.5, false), wall, 0.001) << ambient;
  }
}

// Without a lamp VTK draws unlit colours, yet baked light must show.
TEST_F(LightmapTechnique, NoLampIsNeeded)
{
  this->Scene.Renderer->RemoveAllLights();
  this->Scene.Renderer->AutomaticLightCreationOff();
  this->Bake();
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), 0.5 * 0.6, 0.002);
  EXPECT_EQ(this->Notes(), "");
  EXPECT_EQ(this->Scene.Renderer->GetLights()->GetNumberOfItems(), 0);
  this->Scene.Window->Render();
  EXPECT_GT(this->Pass->GetAccumulatedFrames(this->Scene.Renderer), 1) << "nothing changes";
  this->Map->EnabledOff();
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), 0.5, 0.003) << "as VTK draws it";
}

TEST_F(LightmapTechnique, DirectionalMapsFollowTiltedNormals)
{
  this->Bake(12);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), 0.3, 0.002) << "as baked where the normal is as baked";
  const double gain = 2.0 * 0.1 * 0.5; // twice the moment along the tilt
  this->TiltNormals(0.5);
  this->Bake(12);
  EXPECT_NEAR(this->RadianceAt(0.2, 0.5), 0.5 * (0.6 + gain), 0.002);
  this->TiltNormals(-0.5);
  this->Bake(12);
  EXPECT_NEAR(
    this->RadianceAt(0.2, 0.5), 0.5 * 0.6 * std::pow(1.0 - gain / (1.5 * 0.6), 1.5), 0.002);
}

TEST_F(LightmapTechnique, MultisampledWindowsShowTheLight)
{
  this->Scene.Window->SetMultiSamples(8);
  this->Pass->KeepRadianceOff();
  this->Bake();
  this->Lamp->SetIntensity(0.001);
  const Picture picture = Shoot(this->Scene.Window);
  EXPECT_NEAR(picture.Grey(13, 32), 0.3 * 255.0, 2.0);
}

namespace
{
// Counts of work in frames with shadow maps; penumbra_bench lightmap measures their time.
class LightmapCost : public LightmapTechnique
{
protected:
  void SetUp() override
  {
    this->UseShadowedLamp();
    this->Pass->GetTechnique("shadow-maps")->SetParameter("resolution", 128);
    this->Scene.Window->SetSize(Side, Side);
    this->Pass->CollectStatisticsOn();
  }

  // Expect that the map adds one pass, which shades each pixel of its surfaces once, and one target of eight bytes
  // per pixel, the irradiance.
  void ExpectCost(double pixels)
  {
    const FrameCounts with = CountFrame(this->Scene, this->Pass);
    EXPECT_EQ(this->Notes(), "");
    this->Map->EnabledOff();
    FrameCounts without = CountFrame(this->Scene, this->Pass);
    const long samples = with.Samples - without.Samples;
    std::printf("the map adds %ld bytes and %ld shaded pixels, of %.0f\n",
      with.Bytes - without.Bytes, samples, pixels);
    without.Passes.insert("indirect-light");
    EXPECT_EQ(with.Passes, without.Passes);
    EXPECT_LE(with.Bytes, without.Bytes + 8L * Side * Side);
    EXPECT_NEAR(samples, pixels, 0.02 * pixels);
  }

  static constexpr int Side = 96;
};
}

// The hidden part of the wall is not shaded.
TEST_F(LightmapCost, OfASingleWall)
{
  this->FillWithAWall();
  constexpr double size = 1.8, distance = 4.4;
  this->AddWall(5.0 - distance, size);
  const double across = 2.0 * distance * std::tan(0.5 * vtkMath::RadiansFromDegrees(35.0));
  this->ExpectCost(Side * Side * (1.0 - std::pow(size / across, 2.0)));
}

TEST_F(LightmapCost, OfARoom)
{
  this->MoveIntoARoom();
  this->ExpectCost(Side * Side);
}

TEST_F(LightmapCost, OfARoomWithAnEmitter)
{
  this->AddWall(1.9, 0.2)->GetProperty()->SetAmbient(1.0);
  this->MoveIntoARoom();
  this->ExpectCost(Side * Side);
}

TEST_F(LightmapTechnique, InvalidMapsAreRefused)
{
  EXPECT_FALSE(this->Map->HasBake());
  this->Scene.Window->Render();
  EXPECT_NE(this->Notes().find("without a bake"), std::string::npos);
  this->Bake();
  const auto expectRefused = [this](vtkPolyData* surfaces, vtkImageData* light, const char* why) {
    EXPECT_FALSE(this->Map->SetBake(surfaces, light));
    const std::string error = this->Map->GetBakeError();
    EXPECT_NE(error.find(why), std::string::npos) << error;
    EXPECT_TRUE(TakeMessages().empty()) << "reported once";
  };
  auto surfaces = this->Surfaces();
  expectRefused(surfaces, nullptr, "both surfaces and light");
  expectRefused(surfaces, Light(4), "3 or 12 components");
  surfaces->GetFieldData()->RemoveArray("scene");
  expectRefused(surfaces, Light(), "which scene");
  surfaces = this->Surfaces();
  surfaces->GetPointData()->SetTCoords(nullptr);
  expectRefused(surfaces, Light(), "texture coordinates");
  surfaces = this->Surfaces();
  vtkNew<vtkCellArray> cells;
  const vtkIdType beyond[] = { 0, 1, 99 };
  cells->InsertNextCell(3, beyond);
  surfaces->SetPolys(cells);
  expectRefused(surfaces, Light(), "not triangles of its points");
  this->ExpectFits();
  EXPECT_TRUE(this->Map->SetBake(nullptr, nullptr));
  EXPECT_FALSE(this->Map->HasBake());
}
