// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Skies in renderers: what they set and restore, and the light that arrives.
#include "SceneParts.h"

#include "vtkGISkySource.h"
#include "vtkGISoftBox.h"
#include "vtkGITechnique.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkLightCollection.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPBRLUTTexture.h>
#include <vtkPBRPrefilterTexture.h>
#include <vtkPointData.h>
#include <vtkPropCollection.h>
#include <vtkSphereSource.h>
#include <vtkWeakPointer.h>

#include <array>
#include <vector>

using namespace penumbra_test;

namespace
{
struct SkyStage : Stage
{
  SkyStage()
  {
    this->Window->SetSize(32, 32);
    // Small tables: VTK's filtering for its own shaders would take longer than the rays.
    this->GetRenderer()->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(2);
    this->GetRenderer()->GetEnvMapPrefiltered()->SetPrefilterLevels(2);
    this->GetRenderer()->GetEnvMapLookupTable()->SetLUTSize(8);
    this->GetRenderer()->GetEnvMapLookupTable()->SetLUTSamples(8);
    AddFaintLight(this->Renderer);
    vtkNew<vtkSphereSource> ball;
    ball->SetThetaResolution(48);
    ball->SetPhiResolution(48);
    this->Ball = this->Add(ball);
    this->Ball->GetProperty()->SetColor(0.8, 0.8, 0.8);
    this->Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 4.0);
    this->Renderer->GetActiveCamera()->SetViewAngle(20.0);
    this->Renderer->ResetCameraClippingRange();
  }

  vtkOpenGLRenderer* GetRenderer() { return vtkOpenGLRenderer::SafeDownCast(this->Renderer); }

  /// Direct light of the sky in the middle of the ball and at its left, right, top and bottom.
  std::array<double, 5> Trace()
  {
    auto pass = this->SetPasses().front();
    pass->KeepRadianceOn();
    vtkGITechnique* paths = pass->GetTechnique("path-tracing");
    paths->EnabledOn();
    paths->SetParameter("bounces", 0);
    paths->SetParameter("samples", 32);
    for (int i = 0; i < 32; ++i)
    {
      this->Window->Render();
    }
    vtkNew<vtkImageData> image;
    EXPECT_TRUE(pass->GetRadiance(this->Renderer, image));
    this->Mean = 0.0;
    for (int i = 0; i < 256; ++i)
    {
      this->Mean += image->GetScalarComponentAsDouble(8 + i % 16, 8 + i / 16, 0, 0) / 256.0;
    }
    std::array<double, 5> found{};
    const int places[5][2] = { { 16, 16 }, { 8, 16 }, { 23, 16 }, { 16, 23 }, { 16, 8 } };
    for (int i = 0; i < 5; ++i)
    {
      // Means of a few pixels.
      for (int j = 0; j < 9; ++j)
      {
        found[i] += image->GetScalarComponentAsDouble(
                      places[i][0] + j % 3 - 1, places[i][1] + j / 3 - 1, 0, 0) /
          9.0;
      }
    }
    return found;
  }

  vtkActor* Ball;
  double Mean = 0.0; ///< of the middle of the last traced picture
};

int CountProps(vtkRenderer* renderer)
{
  return renderer->GetViewProps()->GetNumberOfItems();
}
}

TEST(SkyInRenderer, PathTracerReflectsAlbedoTimesRadiance)
{
  SkyStage stage;
  vtkNew<vtkGISkySource> sky;
  sky->SetStrength(0.5);
  sky->ApplyTo(stage.Renderer);
  stage.Trace();
  // The samples of a few hundred pixels leave noise of half a percent.
  EXPECT_NEAR(stage.Mean, 0.8 * 0.5, 0.008);
}

// The camera looks along -z, with y up and z as the vertical of the world: east is to its right, south below.
TEST(SkyInRenderer, LightComesFromWhereTheSkySays)
{
  struct
  {
    double Elevation, Azimuth;
    bool Follow;
    int Brightest;
  } const rows[] = { { 0.0, 90.0, false, 2 }, { 0.0, 180.0, false, 4 }, { 90.0, 0.0, false, 0 },
    { 0.0, 0.0, true, 0 }, { 0.0, -90.0, true, 1 }, { 90.0, 0.0, true, 3 } };
  for (const auto& row : rows)
  {
    SkyStage stage;
    vtkNew<vtkGISkySource> sky;
    sky->SetStrength(0.0);
    sky->SetFollowCamera(row.Follow);
    vtkNew<vtkGISoftBox> box;
    box->SetElevation(row.Elevation);
    box->SetAzimuth(row.Azimuth);
    sky->AddSoftBox(box);
    sky->ApplyTo(stage.Renderer);
    const auto found = stage.Trace();
    for (int i = 0; i < 5; ++i)
    {
      if (i != row.Brightest)
      {
        EXPECT_GT(found[row.Brightest], 1.1 * found[i])
          << row.Elevation << ' ' << row.Azimuth << ' ' << row.Follow << ' ' << i;
      }
    }
    // A sky that follows the camera lights the same side after an orbit; one in the world does not.
    stage.Renderer->GetActiveCamera()->Azimuth(90.0);
    stage.Renderer->GetActiveCamera()->Elevation(30.0);
    stage.Renderer->GetActiveCamera()->OrthogonalizeViewUp();
    stage.Renderer->ResetCameraClippingRange();
    const vtkImageData* image = sky->GetImage();
    const auto after = stage.Trace();
    EXPECT_EQ(sky->GetImage(), image);
    EXPECT_EQ(std::abs(after[row.Brightest] - found[row.Brightest]) < 0.02 * found[row.Brightest] &&
        std::abs(after[0] - found[0]) < 0.02 * found[0] + 0.01,
      row.Follow);
  }
}

TEST(SkyInRenderer, RemovingRestoresTheRenderer)
{
  SkyStage stage;
  vtkOpenGLRenderer* renderer = stage.GetRenderer();
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(8, 4, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto texture = EnvironmentTexture(picture);
  renderer->SetEnvironmentTexture(texture, true);
  renderer->SetEnvironmentUp(0.0, 0.0, 1.0);
  renderer->SetEnvironmentRight(0.0, 1.0, 0.0);
  renderer->UseSphericalHarmonicsOff();
  renderer->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(300);
  const int props = CountProps(renderer);
  const int lights = renderer->GetLights()->GetNumberOfItems();

  vtkNew<vtkGISkySource> sky;
  sky->SetKindToDaylight();
  sky->VisibleOn();
  for (int round = 0; round < 2; ++round)
  {
    sky->ApplyTo(renderer);
    sky->ApplyTo(renderer); // again: no second sun
    EXPECT_TRUE(sky->IsAppliedTo(renderer));
    EXPECT_NE(renderer->GetEnvironmentTexture(), texture.Get());
    EXPECT_TRUE(renderer->GetUseImageBasedLighting());
    EXPECT_TRUE(renderer->GetUseSphericalHarmonics());
    EXPECT_EQ(renderer->GetLights()->GetNumberOfItems(), lights + 1);
    EXPECT_EQ(CountProps(renderer), props + 1);
    stage.Window->Render();
    sky->RemoveFrom(renderer);
    EXPECT_FALSE(sky->IsAppliedTo(renderer));
    EXPECT_EQ(renderer->GetEnvironmentTexture(), texture.Get());
    EXPECT_TRUE(renderer->GetEnvMapPrefiltered()->GetConvertToLinear());
    EXPECT_EQ(renderer->GetEnvMapPrefiltered()->GetPrefilterMaxSamples(), 300u);
    EXPECT_EQ(renderer->GetEnvironmentUp()[2], 1.0);
    EXPECT_EQ(renderer->GetEnvironmentRight()[1], 1.0);
    EXPECT_FALSE(renderer->GetUseImageBasedLighting());
    EXPECT_FALSE(renderer->GetUseSphericalHarmonics());
    EXPECT_EQ(renderer->GetLights()->GetNumberOfItems(), lights);
    EXPECT_EQ(CountProps(renderer), props);
  }
}

TEST(SkyInRenderer, ChangesArriveWithTheNextFrame)
{
  SkyStage stage;
  vtkNew<vtkGISkySource> sky;
  sky->ApplyTo(stage.Renderer);
  stage.Window->Render();
  EXPECT_EQ(stage.Renderer->GetLights()->GetNumberOfItems(), 1);
  sky->SetKindToDaylight();
  sky->SetSunAzimuth(180.0);
  stage.Window->Render();
  EXPECT_EQ(stage.Renderer->GetEnvironmentTexture()->GetInput(), sky->GetImage());
  EXPECT_EQ(stage.Renderer->GetLights()->GetNumberOfItems(), 2);
  sky->SetKindToUniform();
  stage.Window->Render();
  EXPECT_EQ(stage.Renderer->GetLights()->GetNumberOfItems(), 1);
  // Another environment of the user's is left alone.
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(8, 4, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto texture = EnvironmentTexture(picture);
  stage.Renderer->SetEnvironmentTexture(texture);
  stage.Renderer->SetEnvironmentUp(0.0, 1.0, 0.0);
  stage.Window->Render();
  EXPECT_EQ(stage.Renderer->GetEnvironmentUp()[1], 1.0);
  sky->RemoveFrom(stage.Renderer);
  EXPECT_EQ(stage.Renderer->GetEnvironmentTexture(), texture.Get());
}

// The renderer keeps its sky alive, and nothing keeps the renderer.
TEST(SkyInRenderer, LivesAsLongAsItsRenderer)
{
  vtkWeakPointer<vtkGISkySource> watched;
  vtkWeakPointer<vtkRenderer> renderer;
  {
    Stage stage;
    renderer = stage.Renderer;
    {
      vtkNew<vtkGISkySource> sky;
      sky->FollowCameraOn();
      sky->ApplyTo(stage.Renderer);
      watched = sky;
    }
    ASSERT_TRUE(watched);
    stage.Window->Render();
    EXPECT_NE(stage.Renderer->GetEnvironmentTexture(), nullptr);
  }
  EXPECT_FALSE(renderer);
  EXPECT_FALSE(watched);
  // The sky outlives its renderer.
  vtkNew<vtkGISkySource> sky;
  {
    vtkNew<vtkOpenGLRenderer> short_lived;
    sky->ApplyTo(short_lived);
  }
  EXPECT_FALSE(sky->IsAppliedTo(nullptr));
  // The last reference goes with its removal.
  vtkNew<vtkOpenGLRenderer> other;
  vtkGISkySource* plain = vtkGISkySource::New();
  plain->ApplyTo(other);
  watched = plain;
  plain->UnRegister(nullptr);
  ASSERT_TRUE(watched);
  plain->RemoveFrom(other);
  EXPECT_FALSE(watched);
}
