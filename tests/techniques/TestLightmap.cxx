// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Baked light on surfaces: where it shows and where not, and that it never outlives its scene.
 */
#include "LightmapStage.h"
#include "FrameCounts.h"

#include <vtkPlane.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

using namespace penumbra_test;

TEST_F(LightmapTechnique, LightLiesWhereItWasBaked)
{
  this->Bake();
  EXPECT_NEAR(this->At(0.2, 0.5), 0.5 * 0.6, 0.002);
  EXPECT_NEAR(this->At(0.8, 0.5, false), 0.5 * 0.2, 0.002);
  // From behind, that of the back.
  this->Scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, -5.0);
  EXPECT_NEAR(this->At(0.2, 0.5), 0.5 * 0.4, 0.002);
  this->Map->SetIntensity(2.0);
  EXPECT_NEAR(this->At(0.2, 0.5), 0.4, 0.002);
}

TEST_F(LightmapTechnique, SlantedAndFarViewsLoseNothing)
{
  this->Bake();
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  // In a picture of the wall alone every pixel is lit, in whatever projection and from wherever.
  const double places[][3] = { { 0.3, 4.5, 0.4 }, { 1.9, 1.0, 0.05 }, { 0.0, 0.0, 900.0 } };
  for (const auto& place : places)
  {
    for (const bool parallel : { false, true })
    {
      camera->SetParallelProjection(parallel);
      camera->SetPosition(place);
      camera->SetViewUp(1.0, 0.0, 0.0);
      camera->SetFocalPoint(0.0, 0.0, 0.0);
      camera->SetViewAngle(place[2] > 100.0 ? 0.2 : 40.0);
      camera->SetParallelScale(1.5);
      camera->SetClippingRange(place[2] > 100.0 ? 890.0 : 0.02, place[2] > 100.0 ? 910.0 : 20.0);
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
      EXPECT_EQ(dark, 0) << place[2] << (parallel ? ", parallel" : "") << " of " << shown;
    }
  }
}

TEST_F(LightmapTechnique, WhatStandsBeforeAWallIsNotLitAsTheWall)
{
  this->Bake();
  this->ExpectFits();
  vtkActor* mover = this->AddWall(0.003, 1.0);
  mover->SetPosition(-1.2, 0.0, 0.0);
  EXPECT_LT(this->At(0.2, 0.5), 0.01) << "right before the wall";
  EXPECT_EQ(this->Notes(), "") << "what the bake does not know may come";
  EXPECT_NEAR(this->At(0.8, 0.5, false), 0.1, 0.002);
  mover->SetPosition(1.2, 0.0, 0.0);
  EXPECT_NEAR(this->At(0.2, 0.5), 0.3, 0.002);
  EXPECT_LT(this->At(0.8, 0.5, false), 0.01);
}

// A baked wall through which another is seen, one that the map does not know.
TEST_F(LightmapTechnique, WhatIsSeenThroughAWallIsNotLitAsTheWall)
{
  this->AddWall(-1.0, 20.0);
  const auto expectNoMap = [this](const char* why) {
    this->Bake();
    EXPECT_LT(this->At(0.2, 0.5), 0.01) << why;
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
  EXPECT_NEAR(this->At(0.8, 0.5), 0.1, 0.002);
  this->Wall->GetMapper()->RemoveAllClippingPlanes();
  this->Wall->GetProperty()->SetOpacity(0.001);
  expectNoMap("translucent");
}

// Where nothing has an ambient term its target takes the map's light; one prop that has, and it cannot.
TEST_F(LightmapTechnique, WhatGlowsByItselfStaysBesideTheMap)
{
  this->Bake();
  this->ExpectFits();
  vtkActor* beside = this->AddWall(0.1, 0.5);
  beside->GetProperty()->SetAmbient(0.7);
  EXPECT_NEAR(this->At(0.5, 0.5), 0.7, 0.005);
  EXPECT_NEAR(this->At(0.2, 0.5, false), 0.3, 0.002);
  beside->VisibilityOff();
  this->Wall->GetProperty()->SetAmbient(0.25);
  this->Bake();
  EXPECT_NEAR(this->At(0.2, 0.5), 0.55, 0.005);
  this->Wall->GetProperty()->SetAmbient(0.0);
  this->Wall->GetProperty()->LightingOff();
  this->Bake();
  EXPECT_NEAR(this->At(0.2, 0.5), 0.5, 0.005) << "drawn as it is";
}

// By memory: of two frames that are alike but for a glow, the one without has a target less.
TEST_F(LightmapTechnique, TheMapSharesATargetWhereNothingGlows)
{
  vtkActor* beside = this->AddWall(0.1, 0.5);
  this->Bake();
  this->Pass->CollectStatisticsOn();
  const auto bytes = [this, beside](double ambient) {
    beside->GetProperty()->SetAmbient(ambient);
    this->Bake();
    for (int i = 0; i < 40; ++i) // what is not used any more goes
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

TEST_F(LightmapTechnique, AnotherColourIsReportedAtOnce)
{
  this->Bake();
  this->ExpectFits();
  this->Wall->GetProperty()->SetColor(1.0, 0.99, 1.0);
  this->ExpectStale("object 1 changed its look");
  this->Wall->GetProperty()->SetColor(1.0, 1.0, 1.0);
  this->ExpectFits();
}

TEST_F(LightmapTechnique, LampsAreReportedAtOnce)
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

// What changes while the technique is off is seen when it comes on again.
TEST_F(LightmapTechnique, ChangesUnseenAreFound)
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
  EXPECT_NEAR(this->At(0.2, 0.5), 0.3, 0.002);
  EXPECT_EQ(this->Notes(), "");
}

// DDGI lights the scene in the place of a map that no longer fits: as it does where it is on and there is no map.
TEST_F(LightmapTechnique, StaleMapsLeaveTheLightToProbes)
{
  this->Bake();
  vtkGITechnique* probes = this->Pass->GetTechnique("ddgi");
  constexpr int updates = 48;
  probes->SetParameter("probes", 64);
  probes->SetParameter("rays", 512);
  probes->SetParameter("updates", updates);
  const auto atRest = [&] {
    for (int i = 0; i < updates; ++i)
    {
      this->Scene.Window->Render();
    }
    return this->At(0.2, 0.5);
  };
  EXPECT_NEAR(this->At(0.2, 0.5), 0.3, 0.002);
  EXPECT_FALSE(probes->GetTookPart()) << "the map fits";
  // Nothing but what a glowing wall beside the baked one sends to it.
  vtkActor* glowing = this->AddWall(0.0, 4.0);
  glowing->SetPosition(-2.0, 0.0, 2.0);
  glowing->RotateY(90.0);
  glowing->GetProperty()->SetAmbient(1.0);
  EXPECT_NEAR(this->At(0.2, 0.5), 0.3, 0.002) << "what the bake does not know may come";
  this->Lamp->SetIntensity(0.002);
  const double inPlace = atRest();
  EXPECT_TRUE(probes->GetTookPart());
  EXPECT_NE(this->Map->GetMismatch(this->Scene.Renderer), "");
  this->Map->LiveFallbackOff();
  const double dark = this->At(0.2, 0.5);
  EXPECT_FALSE(probes->GetTookPart());
  EXPECT_LT(dark, 0.01);
  EXPECT_GT(inPlace, 0.05);
  this->Map->EnabledOff();
  probes->EnabledOn();
  EXPECT_NEAR(atRest(), inPlace, 0.03 * inPlace);
  this->Map->EnabledOn();
  this->Map->LiveFallbackOn();
  probes->EnabledOff();
  this->Lamp->SetIntensity(0.001);
  EXPECT_NEAR(this->At(0.2, 0.5), 0.3, 0.002) << "it fits again";
  EXPECT_FALSE(probes->GetTookPart());
}

// A static room and a moving actor: each has its own source, the wall the map alone.
TEST_F(LightmapTechnique, ProbesLightWhatTheMapDoesNotKnow)
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
  // With a target of its own for indirect light, and in that of ambient light.
  for (const double ambient : { 0.001, 0.0 })
  {
    beside->GetProperty()->SetAmbient(ambient);
    this->Bake();
    probes->EnabledOff();
    const double unlit = this->At(0.22, 0.5);
    const double wall = this->At(0.8, 0.5, false);
    EXPECT_NEAR(wall, 0.25 + 0.1, 0.002);
    EXPECT_NEAR(unlit, 0.25, 0.002);
    probes->EnabledOn();
    for (int i = 0; i < updates; ++i)
    {
      this->Scene.Window->Render();
    }
    EXPECT_GT(this->At(0.22, 0.5), unlit + 0.005) << ambient;
    EXPECT_NEAR(this->At(0.8, 0.5, false), wall, 0.001) << ambient;
  }
}

// There VTK shows colours as they are; light from elsewhere must be seen nevertheless.
TEST_F(LightmapTechnique, NoLampIsNeeded)
{
  this->Scene.Renderer->RemoveAllLights();
  this->Scene.Renderer->AutomaticLightCreationOff();
  this->Bake();
  EXPECT_NEAR(this->At(0.2, 0.5), 0.5 * 0.6, 0.002);
  EXPECT_EQ(this->Notes(), "");
  EXPECT_EQ(this->Scene.Renderer->GetLights()->GetNumberOfItems(), 0);
  this->Scene.Window->Render();
  EXPECT_GT(this->Pass->GetAccumulatedFrames(this->Scene.Renderer), 1) << "nothing changes";
  this->Map->EnabledOff();
  EXPECT_NEAR(this->At(0.2, 0.5), 0.5, 0.003) << "as VTK draws it";
}

TEST_F(LightmapTechnique, DirectionalMapsFollowBentNormals)
{
  this->Bake(12);
  EXPECT_NEAR(this->At(0.2, 0.5), 0.3, 0.002) << "as baked where the normal is as baked";
  const double gain = 2.0 * 0.1 * 0.5; // twice the moment along the turn
  this->LeanNormals(0.5);
  this->Bake(12);
  EXPECT_NEAR(this->At(0.2, 0.5), 0.5 * (0.6 + gain), 0.002);
  this->LeanNormals(-0.5);
  this->Bake(12);
  EXPECT_NEAR(this->At(0.2, 0.5), 0.5 * 0.6 * std::pow(1.0 - gain / (1.5 * 0.6), 1.5), 0.002);
}

TEST_F(LightmapTechnique, AMultisampledWindowShowsIt)
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
// Frames as users draw them; penumbra_bench lightmap takes their time.
class LightmapWork : public LightmapTechnique
{
protected:
  void SetUp() override
  {
    this->LightAsUsers();
    this->Pass->GetTechnique("shadow-maps")->SetParameter("resolution", 128);
    this->Scene.Window->SetSize(Side, Side);
    this->Pass->CollectStatisticsOn();
  }

  // One draw that shades each pixel of the map's surface once, and no more than one target of four bytes a pixel.
  void ExpectAdded(double pixels)
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
    EXPECT_LE(with.Bytes, without.Bytes + 4L * Side * Side);
    EXPECT_NEAR(samples, pixels, 0.02 * pixels);
  }

  static constexpr int Side = 96;
};
}

// What stands before the wall hides a part of it, which is not shaded.
TEST_F(LightmapWork, OfASingleWall)
{
  this->FillWithAWall();
  constexpr double size = 1.8, distance = 4.4;
  this->AddWall(5.0 - distance, size);
  const double across = 2.0 * distance * std::tan(0.5 * vtkMath::RadiansFromDegrees(35.0));
  this->ExpectAdded(Side * Side * (1.0 - std::pow(size / across, 2.0)));
}

TEST_F(LightmapWork, OfARoom)
{
  this->MoveIntoARoom();
  this->ExpectAdded(Side * Side);
}

TEST_F(LightmapWork, OfARoomWithWhatGlows)
{
  this->AddWall(1.9, 0.2)->GetProperty()->SetAmbient(1.0);
  this->MoveIntoARoom();
  this->ExpectAdded(Side * Side);
}

TEST_F(LightmapTechnique, WhatIsNoMapIsRefused)
{
  EXPECT_FALSE(this->Map->HasBake());
  this->Scene.Window->Render();
  EXPECT_NE(this->Notes().find("without a bake"), std::string::npos);
  this->Bake();
  const auto refused = [this](vtkPolyData* surfaces, vtkImageData* light, const char* why) {
    EXPECT_FALSE(this->Map->SetBake(surfaces, light));
    const std::string said = this->Map->GetBakeError();
    EXPECT_NE(said.find(why), std::string::npos) << said;
    EXPECT_TRUE(TakeMessages().empty()) << "said once";
  };
  auto surfaces = this->Surfaces();
  refused(surfaces, nullptr, "both surfaces and light");
  refused(surfaces, Light(4), "3 or 12 components");
  surfaces->GetFieldData()->RemoveArray("scene");
  refused(surfaces, Light(), "which scene");
  surfaces = this->Surfaces();
  surfaces->GetPointData()->SetTCoords(nullptr);
  refused(surfaces, Light(), "texture coordinates");
  surfaces = this->Surfaces();
  vtkNew<vtkCellArray> cells;
  const vtkIdType beyond[] = { 0, 1, 99 };
  cells->InsertNextCell(3, beyond);
  surfaces->SetPolys(cells);
  refused(surfaces, Light(), "not triangles of its points");
  this->ExpectFits();
  EXPECT_TRUE(this->Map->SetBake(nullptr, nullptr));
  EXPECT_FALSE(this->Map->HasBake());
}
