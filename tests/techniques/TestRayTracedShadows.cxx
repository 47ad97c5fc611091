// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Ray-traced shadows: penumbrae as wide as the light makes them, none on flat receivers, one
// technique at a time.
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkGITechnique.h"

#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkPlaneSource.h>

#include <cmath>
#include <cstdio>

using namespace penumbra_test;

namespace
{
constexpr double Pi = 3.14159265358979323846;

vtkActor* AddPlane(Stage& stage, double x0, double x1, double z)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(x0, -10.0, z);
  plane->SetPoint1(x1, -10.0, z);
  plane->SetPoint2(x0, 10.0, z);
  vtkActor* actor = stage.Add(plane);
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  return actor;
}

vtkLight* AddLight(Stage& stage, double x, double y, double z)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  stage.Renderer->AutomaticLightCreationOff();
  stage.Renderer->AddLight(light);
  return light;
}

// A floor, and a blocker over its left half at that height; the camera looks down from below the
// blocker, one world unit to a picture's height.
struct HalfShadow
{
  static constexpr int Side = 200;
  Stage Scene;
  vtkGITechnique* Shadows = nullptr;

  explicit HalfShadow(double height)
  {
    this->Scene.Window->SetSize(Side, Side);
    AddPlane(this->Scene, -10.0, 10.0, 0.0);
    AddPlane(this->Scene, -10.0, 0.0, height);
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5);
    camera->SetPosition(0.0, 0.0, 0.5 * height);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetClippingRange(0.1 * height, 2.0 * height);
    auto pass = this->Scene.SetPasses().front();
    this->Shadows = pass->GetTechnique("ray-traced-shadows");
    this->Shadows->EnabledOn();
    vtkGITechnique* average = pass->GetTechnique("anti-aliasing");
    average->EnabledOn();
    average->SetParameterFromText("mode", "accumulate");
  }

  // Share of the light at x, of so many still frames.
  std::vector<double> Profile(int frames)
  {
    for (int i = 1; i < frames; ++i)
    {
      this->Scene.Window->Render();
    }
    const Picture picture = Shoot(this->Scene.Window);
    std::vector<double> profile;
    for (int x = 0; x < Side; ++x)
    {
      profile.push_back(picture.MeanGrey(x, 0, x + 1, Side) / 255.0);
    }
    return profile;
  }
};

// Share of a disc of radius 1 that lies right of a line at -t.
double DiscShare(double t)
{
  t = std::clamp(t, -1.0, 1.0);
  return 0.5 + (t * std::sqrt(1.0 - t * t) + std::asin(t)) / Pi;
}

void ExpectProfile(const std::vector<double>& profile, double halfWidth, double foreshortening)
{
  double worst = 0.0;
  for (std::size_t i = 0; i < profile.size(); ++i)
  {
    const double x = (i + 0.5) / HalfShadow::Side - 0.5;
    worst = std::max(worst, std::abs(profile[i] / foreshortening - DiscShare(x / halfWidth)));
  }
  std::printf("penumbra of half width %.4f: largest difference %.4f\n", halfWidth, worst);
  // Eight bits, and chance over the column of a pixel each frame.
  EXPECT_LT(worst, 0.009);
}

TEST(RayTracedShadows, PenumbraOfTheSun)
{
  HalfShadow scene(1.0);
  AddLight(scene.Scene, 0.0, 0.0, 10.0);
  scene.Shadows->SetParameter("light-angle", 30.0);
  ExpectProfile(scene.Profile(32), std::tan(15.0 * Pi / 180.0), 1.0);
  TakeMessages();
}

// A lamp at twice the blocker's height throws a penumbra as wide as itself.
TEST(RayTracedShadows, PenumbraOfALamp)
{
  HalfShadow scene(2.0);
  vtkLight* lamp = AddLight(scene.Scene, 0.0, 0.0, 4.0);
  lamp->PositionalOn();
  lamp->SetConeAngle(180.0);
  scene.Shadows->SetParameter("light-radius", 0.3);
  const std::vector<double> lit = [] {
    HalfShadow bare(2.0);
    vtkLight* same = AddLight(bare.Scene, 0.0, 0.0, 4.0);
    same->PositionalOn();
    same->SetConeAngle(180.0);
    bare.Shadows->EnabledOff();
    return bare.Profile(1);
  }();
  std::vector<double> profile = scene.Profile(32);
  for (std::size_t i = 0; i < profile.size(); ++i)
  {
    profile[i] /= lit[i];
  }
  ExpectProfile(profile, 0.3, 1.0);
}

// Whatever the angle, a floor is lit evenly: rays need no bias.
TEST(RayTracedShadows, NoAcneOnFlatReceivers)
{
  for (const double angle : { 0.0, 30.0, 60.0, 80.0, 85.0 })
  {
    const auto shoot = [angle](bool shadows) {
      Stage stage;
      stage.Window->SetSize(160, 120);
      AddPlane(stage, -10.0, 10.0, 0.0);
      AddLight(
        stage, 10.0 * std::sin(angle * Pi / 180.0), 0.0, 10.0 * std::cos(angle * Pi / 180.0));
      Stage::LookAround(stage.Renderer);
      stage.SetPasses().front()->GetTechnique("ray-traced-shadows")->SetEnabled(shadows);
      return Shoot(stage.Window);
    };
    const Difference found = Compare(shoot(false), shoot(true), 0);
    EXPECT_EQ(found.Within, 1.0) << angle << " degrees";
  }
}

// With shadow maps switched on too, the rays' shadows are drawn, and a note says so.
TEST(RayTracedShadows, WinOverShadowMaps)
{
  const auto shoot = [](bool rays, bool maps) {
    Stage stage;
    stage.Window->SetSize(160, 120);
    AddPlane(stage, -10.0, 10.0, 0.0);
    vtkNew<vtkCubeSource> cube;
    cube->SetCenter(0.0, 0.0, 2.0);
    cube->SetXLength(4.0);
    cube->SetYLength(4.0);
    stage.Add(cube);
    AddLight(stage, 5.0, 3.0, 8.0);
    Stage::LookAround(stage.Renderer);
    auto pass = stage.SetPasses().front();
    pass->GetTechnique("ray-traced-shadows")->SetEnabled(rays);
    pass->GetTechnique("ray-traced-shadows")->SetParameter("light-angle", 0.0);
    pass->GetTechnique("shadow-maps")->SetEnabled(maps);
    const Picture picture = Shoot(stage.Window);
    EXPECT_STREQ(pass->GetNotes(), rays && maps
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

// Mirrored, drawn out and flattened, even to nothing, a prop casts the shadow of what VTK draws of it.
TEST(RayTracedShadows, scaled_props_cast_the_shadows_that_maps_show)
{
  const double scales[][3] = { { 1.0, 1.0, 1.0 }, { -1.0, 1.0, 1.0 }, { -1.0, -1.0, -1.0 },
    { 3.0, 0.3, 0.3 }, { 1.0, 1.0, 0.01 }, { 1.0, 1.0, 1e-12 }, { 1.0, 1.0, 1e-60 },
    { 1.0, 1.0, 0.0 }, { 0.0, 1.0, 1.0 }, { 1.0, 0.0, 1.0 } };
  for (const auto& scale : scales)
  {
    Stage stage;
    stage.Window->SetSize(240, 240);
    AddPlane(stage, -10.0, 10.0, 0.0);
    AddLight(stage, 2.0, 1.0, 3.0);
    vtkNew<vtkConeSource> cone;
    cone->SetResolution(24);
    vtkActor* actor = stage.Add(cone);
    actor->SetOrientation(0.0, 0.0, -20.0);
    actor->SetPosition(2.0, 1.0, 3.0); // its shadow is around the origin
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
