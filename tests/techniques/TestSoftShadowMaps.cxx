// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadow maps of lights that have a size: penumbrae as wide as geometry makes them.
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkGIShadowMaps.h"

#include <vtkCubeSource.h>
#include <vtkPlaneSource.h>
#include <vtkSphereSource.h>

#include <cstdio>

using namespace penumbra_test;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int Side = 200;
constexpr int Frames = 16;

void AddPlane(Stage& stage, double x0, double x1, double z)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(x0, -3.0, z);
  plane->SetPoint1(x1, -3.0, z);
  plane->SetPoint2(x0, 3.0, z);
  stage.Add(plane)->GetProperty()->SetColor(1.0, 1.0, 1.0);
}

struct Configuration
{
  const char* Name;
  double Blocker; ///< its height above the floor
  double Lamp;    ///< its height; 0 for the sun
  double Size;    ///< the sun's angle in degrees, or a lamp's radius

  // w = w_L (d_R - d_B) / d_B
  double Width() const
  {
    return this->Lamp > 0.0 ? 2.0 * this->Size * this->Blocker / (this->Lamp - this->Blocker)
                            : 2.0 * std::tan(0.5 * this->Size * Pi / 180.0) * this->Blocker;
  }
};

// Share of the light along the floor, across the rim of a blocker's shadow; the camera looks down from
// below the blocker, one unit to a picture's width.
std::vector<double> Profile(const Configuration& made, bool shadowed)
{
  Stage stage;
  stage.Window->SetSize(Side, Side);
  AddPlane(stage, -3.0, 3.0, 0.0);
  AddPlane(stage, -3.0, 0.0, made.Blocker);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5);
  camera->SetPosition(0.0, 0.0, 0.5 * made.Blocker);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetClippingRange(0.1 * made.Blocker, 2.0 * made.Blocker);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(0.0, 0.0, made.Lamp > 0.0 ? made.Lamp : 10.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetPositional(made.Lamp > 0.0);
  light->SetConeAngle(180.0);
  stage.Renderer->AutomaticLightCreationOff();
  stage.Renderer->AddLight(light);
  auto pass = stage.SetPasses().front();
  auto* shadows = vtkGIShadowMaps::SafeDownCast(pass->GetTechnique("shadow-maps"));
  shadows->SetEnabled(shadowed);
  shadows->SetLightAngle(made.Size);
  shadows->SetLightRadius(made.Size);
  vtkGITechnique* average = pass->GetTechnique("anti-aliasing");
  average->EnabledOn();
  average->SetParameterFromText("mode", "accumulate");
  for (int i = 1; i < (shadowed ? Frames : 1); ++i)
  {
    stage.Window->Render();
  }
  const Picture picture = Shoot(stage.Window);
  std::vector<double> profile;
  for (int x = 0; x < Side; ++x)
  {
    profile.push_back(picture.MeanGrey(x, 0, x + 1, Side));
  }
  return profile;
}

// Where a rising profile reaches a value, in world units.
double Reaches(const std::vector<double>& profile, double value)
{
  for (std::size_t i = 1; i < profile.size(); ++i)
  {
    if (profile[i] >= value && profile[i - 1] < value)
    {
      return (i - 0.5 + (value - profile[i - 1]) / (profile[i] - profile[i - 1])) / Side;
    }
  }
  return -1.0;
}

// Share of a disc of radius one that lies right of a line at -t.
double DiscShare(double t)
{
  return 0.5 + (t * std::sqrt(1.0 - t * t) + std::asin(t)) / Pi;
}

TEST(SoftShadowMaps, PenumbraeAreAsWideAsGeometryMakesThem)
{
  const Configuration all[] = {
    { "sun of 10 degrees, blocker at 1", 1.0, 0.0, 10.0 },
    { "sun of 30 degrees, blocker at 1", 1.0, 0.0, 30.0 },
    { "sun of 20 degrees, blocker at 2", 2.0, 0.0, 20.0 },
    { "lamp of radius 0.3 at 4, blocker at 2", 2.0, 4.0, 0.3 },
    { "lamp of radius 0.2 at 3, blocker at 1", 1.0, 3.0, 0.2 },
    { "lamp of radius 0.1 at 4, blocker at 3", 3.0, 4.0, 0.1 },
  };
  std::printf("%-40s %8s %8s %8s\n", "penumbra", "w", "measured", "ratio");
  for (const auto& made : all)
  {
    const std::vector<double> bare = Profile(made, false);
    std::vector<double> open = Profile(made, true);
    for (std::size_t i = 0; i < open.size(); ++i)
    {
      open[i] /= bare[i];
    }
    // From five to ninety-five hundredths of the light, which is that part of the whole width.
    constexpr double part = 0.8055;
    EXPECT_NEAR(DiscShare(part), 0.95, 1e-3);
    const double measured = (Reaches(open, 0.95) - Reaches(open, 0.05)) / part;
    std::printf(
      "%-40s %8.4f %8.4f %8.3f\n", made.Name, made.Width(), measured, measured / made.Width());
    EXPECT_NEAR(measured / made.Width(), 1.0, 0.15) << made.Name;
    // Half of the light at the rim.
    EXPECT_NEAR(Reaches(open, 0.5), 0.5, 0.1 * made.Width() + 1.0 / Side) << made.Name;
  }
  TakeMessages();
}

// Mean radiance of still frames of a box and a ball on a floor.
std::vector<double> BoxAndBall(bool lamp, const char* technique, double size, int frames)
{
  Stage stage;
  stage.Window->SetSize(200, 150);
  AddPlane(stage, -3.0, 3.0, 0.0);
  vtkNew<vtkCubeSource> box;
  box->SetBounds(-1.2, -0.6, -0.4, 0.2, 0.0, 1.4);
  stage.Add(box);
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.6, 0.0, 0.9);
  ball->SetRadius(0.4);
  ball->SetThetaResolution(64);
  ball->SetPhiResolution(64);
  stage.Add(ball);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetPosition(0.5, -6.0, 5.0);
  camera->SetFocalPoint(0.3, 0.3, 0.2);
  stage.Renderer->ResetCameraClippingRange();
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(-2.0, -1.0, 4.0);
  light->SetFocalPoint(0.0, 0.0, 0.5);
  light->SetPositional(lamp);
  light->SetConeAngle(180.0);
  stage.Renderer->AutomaticLightCreationOff();
  stage.Renderer->AddLight(light);
  auto pass = stage.SetPasses().front();
  pass->KeepRadianceOn();
  vtkGITechnique* shadows = pass->GetTechnique(technique);
  shadows->EnabledOn();
  EXPECT_TRUE(shadows->SetParameter(lamp ? "light-radius" : "light-angle", size));
  EXPECT_TRUE(shadows->SetParameter(lamp ? "light-angle" : "light-radius", 0.0));
  if (std::string(technique) == "ray-traced-shadows")
  {
    EXPECT_TRUE(shadows->SetParameter("samples", 16));
  }
  std::vector<double> mean(200 * 150, 0.0);
  vtkNew<vtkImageData> radiance;
  for (int frame = 0; frame < frames; ++frame)
  {
    stage.Window->Render();
    EXPECT_TRUE(pass->GetRadiance(stage.Renderer, radiance));
    const auto* pixels = static_cast<const float*>(radiance->GetScalarPointer());
    for (std::size_t i = 0; i < mean.size(); ++i)
    {
      mean[i] += (pixels[4 * i] + pixels[4 * i + 1] + pixels[4 * i + 2]) / (3.0 * frames);
    }
  }
  return mean;
}

double ErrorOf(const std::vector<double>& picture, const std::vector<double>& reference)
{
  RelativeError error;
  for (std::size_t i = 0; i < picture.size(); ++i)
  {
    error.Add(picture[i], reference[i]);
  }
  return error.Mean();
}

TEST(SoftShadowMaps, AreCloserToRaysThanAPlainFilterThreefold)
{
  for (const bool lamp : { false, true })
  {
    const double size = lamp ? 0.3 : 8.0;
    const auto rays = BoxAndBall(lamp, "ray-traced-shadows", size, 8);
    const double plain = ErrorOf(BoxAndBall(lamp, "shadow-maps", 0.0, 8), rays);
    const double once = ErrorOf(BoxAndBall(lamp, "shadow-maps", size, 1), rays);
    const double soft = ErrorOf(BoxAndBall(lamp, "shadow-maps", size, 8), rays);
    std::printf("%s: relMSE of the plain filter %.5f, of penumbrae %.5f (%.3f of it), in one frame "
                "%.5f (%.3f)\n",
      lamp ? "lamp of radius 0.3" : "sun of 8 degrees", plain, soft, soft / plain, once,
      once / plain);
    EXPECT_LT(soft, plain / 3.0);
    EXPECT_LT(once, plain / 3.0);
  }
  TakeMessages();
}
}
