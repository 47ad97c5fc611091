// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Ray-traced shadows: penumbrae of the right profile, no acne on flat receivers, precedence over shadow maps.
#include "HalfShadow.h"
#include "Messages.h"
#include "Picture.h"
#include "SceneParts.h"
#include "Stage.h"

#include "vtkGITechnique.h"

#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkCubeSource.h>

#include <cmath>
#include <cstdio>

using namespace penumbra_test;

namespace
{
vtkActor* AddWhiteFloor(Stage& stage)
{
  vtkActor* floor = AddFloor(stage, -10.0, 10.0, -10.0, 10.0);
  floor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  return floor;
}

vtkLight* AddOnlyLight(Stage& stage, double x, double y, double z)
{
  stage.Renderer->AutomaticLightCreationOff();
  return AddLight(stage, x, y, z);
}

void ExpectProfile(const std::vector<double>& profile, double halfWidth)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < profile.size(); ++i)
  {
    const double x = (i + 0.5) / HalfShadow::Side - 0.5;
    largest = std::max(largest, std::abs(profile[i] - DiscShare(x / halfWidth)));
  }
  std::printf("penumbra of half width %.4f: largest difference %.4f\n", halfWidth, largest);
  // The error of 8 bits, and the noise that remains in the mean of a column.
  EXPECT_LT(largest, 0.009);
}

TEST(RayTracedShadows, PenumbraOfTheSunMatchesItsClosedForm)
{
  HalfShadow scene("ray-traced-shadows", 1.0, 10.0);
  AddLight(scene.Scene, 0.0, 0.0, 10.0);
  scene.Shadows->SetParameter("light-angle", 30.0);
  ExpectProfile(scene.Profile(32), std::tan(15.0 * Pi / 180.0));
  TakeMessages();
}

// A lamp at twice the blocker's height casts a penumbra as wide as itself.
TEST(RayTracedShadows, PenumbraOfALampMatchesItsClosedForm)
{
  HalfShadow scene("ray-traced-shadows", 2.0, 10.0);
  ShineAllRound(AddLight(scene.Scene, 0.0, 0.0, 4.0));
  scene.Shadows->SetParameter("light-radius", 0.3);
  const std::vector<double> lit = [] {
    HalfShadow bare("ray-traced-shadows", 2.0, 10.0);
    ShineAllRound(AddLight(bare.Scene, 0.0, 0.0, 4.0));
    bare.Shadows->EnabledOff();
    return bare.Profile(1);
  }();
  std::vector<double> profile = scene.Profile(32);
  for (std::size_t i = 0; i < profile.size(); ++i)
  {
    profile[i] /= lit[i];
  }
  ExpectProfile(profile, 0.3);
}

// A floor is lit evenly at any angle: rays need no bias.
TEST(RayTracedShadows, NoAcneOnFlatReceivers)
{
  for (const double angle : { 0.0, 30.0, 60.0, 80.0, 85.0 })
  {
    const auto shoot = [angle](bool shadows) {
      Stage stage;
      stage.Window->SetSize(160, 120);
      AddWhiteFloor(stage);
      AddOnlyLight(
        stage, 10.0 * std::sin(angle * Pi / 180.0), 0.0, 10.0 * std::cos(angle * Pi / 180.0));
      Stage::LookAround(stage.Renderer);
      stage.SetPasses().front()->GetTechnique("ray-traced-shadows")->SetEnabled(shadows);
      return Shoot(stage.Window);
    };
    const Difference found = Compare(shoot(false), shoot(true), 0);
    EXPECT_EQ(found.Within, 1.0) << angle << " degrees";
  }
}

// Nothing in an empty room casts shadows, not even where its edges go through the centres of pixels.
TEST(RayTracedShadows, NoneInTheCornersOfARoom)
{
  const auto shoot = [](bool shadows) {
    Stage stage;
    stage.Window->SetSize(128, 128);
    vtkNew<vtkCubeSource> room;
    room->SetBounds(0.0, 1.0, 0.0, 1.0, 0.0, 1.0);
    stage.Add(room)->GetProperty()->SetInterpolationToFlat();
    vtkLight* lamp = AddOnlyLight(stage, 0.15, 0.2, 0.9);
    ShineAllRound(lamp);
    lamp->SetFocalPoint(0.5, 0.5, 0.5);
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    camera->SetPosition(0.5, 0.01, 0.5);
    camera->SetFocalPoint(0.5, 1.0, 0.5);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(100.0);
    camera->SetClippingRange(0.001, 3.0);
    vtkGITechnique* technique = stage.SetPasses().front()->GetTechnique("ray-traced-shadows");
    technique->SetEnabled(shadows);
    technique->SetParameter("light-radius", 0.06);
    return Shoot(stage.Window);
  };
  EXPECT_EQ(Compare(shoot(false), shoot(true), 0).Within, 1.0);
}

// With both techniques on, rays draw the shadows, and a note says so.
TEST(RayTracedShadows, TakePrecedenceOverShadowMaps)
{
  const auto shoot = [](bool rays, bool maps) {
    Stage stage;
    stage.Window->SetSize(160, 120);
    AddWhiteFloor(stage);
    vtkNew<vtkCubeSource> cube;
    cube->SetCenter(0.0, 0.0, 2.0);
    cube->SetXLength(4.0);
    cube->SetYLength(4.0);
    stage.Add(cube);
    AddOnlyLight(stage, 5.0, 3.0, 8.0);
    Stage::LookAround(stage.Renderer);
    auto pass = stage.SetPasses().front();
    pass->GetTechnique("ray-traced-shadows")->SetEnabled(rays);
    pass->GetTechnique("ray-traced-shadows")->SetParameter("light-angle", 0.0);
    pass->GetTechnique("shadow-maps")->SetEnabled(maps);
    const Picture picture = Shoot(stage.Window);
    EXPECT_STREQ(pass->GetNotes(),
      rays && maps
        ? "shadow-maps is not used, because ray-traced-shadows, which is on too, takes its place"
        : "");
    return picture;
  };
  const Picture rays = shoot(true, false);
  EXPECT_EQ(Compare(rays, shoot(true, true), 0).Within, 1.0);
  EXPECT_LT(Compare(rays, shoot(false, true), 0).Within, 1.0);
  EXPECT_LT(Compare(rays, shoot(false, false), 0).Within, 0.999);
}
}

// Mirrored, stretched and flattened props, even those without volume, cast the shadows of what VTK draws.
TEST(RayTracedShadows, ScaledPropsCastTheSameShadowsAsMaps)
{
  const double scales[][3] = { { 1.0, 1.0, 1.0 }, { -1.0, 1.0, 1.0 }, { -1.0, -1.0, -1.0 },
    { 3.0, 0.3, 0.3 }, { 1.0, 1.0, 0.01 }, { 1.0, 1.0, 1e-12 }, { 1.0, 1.0, 1e-60 },
    { 1.0, 1.0, 0.0 }, { 0.0, 1.0, 1.0 }, { 1.0, 0.0, 1.0 } };
  for (const auto& scale : scales)
  {
    Stage stage;
    stage.Window->SetSize(240, 240);
    AddWhiteFloor(stage);
    AddOnlyLight(stage, 2.0, 1.0, 3.0);
    vtkNew<vtkConeSource> cone;
    cone->SetResolution(24);
    vtkActor* actor = stage.Add(cone);
    actor->SetOrientation(0.0, 0.0, -20.0);
    actor->SetPosition(2.0, 1.0, 3.0); // its shadow lies around the origin
    actor->SetScale(scale[0], scale[1], scale[2]);
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.5);
    camera->SetPosition(0.0, 0.0, 1.0); // below the cone
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetClippingRange(0.1, 2.0);
    auto pass = stage.SetPasses().front();
    int dark[2];
    for (const bool rays : { false, true })
    {
      pass->GetTechnique("shadow-maps")->SetEnabled(!rays);
      pass->GetTechnique("ray-traced-shadows")->SetEnabled(rays);
      const Picture picture = Shoot(stage.Window);
      dark[rays] = 0;
      for (int i = 0; i < picture.Width * picture.Height; ++i)
      {
        dark[rays] += picture.Grey(i % picture.Width, i / picture.Width) < 100.0;
      }
    }
    std::printf("scale %g %g %g: %d pixels in shadow by maps, %d by rays\n", scale[0], scale[1],
      scale[2], dark[0], dark[1]);
    EXPECT_GT(dark[0], 400);
    EXPECT_NEAR(dark[1], dark[0], 0.05 * dark[0]);
  }
  EXPECT_TRUE(TakeMessages().empty());
}
