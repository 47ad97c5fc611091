// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadow maps of lights with a size: penumbrae of the width that geometry demands.
#include "HalfShadow.h"
#include "Messages.h"
#include "Picture.h"
#include "SceneParts.h"
#include "Stage.h"

#include "vtkGITechnique.h"

#include <vtkCubeSource.h>
#include <vtkSphereSource.h>

#include <cstdio>

using namespace penumbra_test;

namespace
{
constexpr int Frames = 16;

struct Configuration
{
  const char* Name;
  double Blocker; ///< height above the floor
  double Lamp;    ///< height above the floor; 0 for a sun
  double Size;    ///< angle of a sun in degrees, radius of a lamp

  // Width of the penumbra: w = w_L (d_R - d_B) / d_B.
  double Width() const
  {
    return this->Lamp > 0.0 ? 2.0 * this->Size * this->Blocker / (this->Lamp - this->Blocker)
                            : 2.0 * std::tan(0.5 * this->Size * Pi / 180.0) * this->Blocker;
  }
};

// Light along the floor, across the edge of a blocker's shadow.
std::vector<double> Profile(const Configuration& configuration, bool shadowed)
{
  HalfShadow scene("shadow-maps", configuration.Blocker, 3.0);
  const bool lamp = configuration.Lamp > 0.0;
  vtkLight* light = AddLight(scene.Scene, 0.0, 0.0, lamp ? configuration.Lamp : 10.0);
  light->SetPositional(lamp);
  light->SetConeAngle(180.0);
  scene.Shadows->SetEnabled(shadowed);
  scene.Shadows->SetParameter(lamp ? "light-radius" : "light-angle", configuration.Size);
  return scene.Profile(shadowed ? Frames : 1);
}

// Position where a rising profile reaches a value, in world units.
double PositionOf(const std::vector<double>& profile, double value)
{
  for (std::size_t i = 1; i < profile.size(); ++i)
  {
    if (profile[i] >= value && profile[i - 1] < value)
    {
      return (i - 0.5 + (value - profile[i - 1]) / (profile[i] - profile[i - 1])) /
        HalfShadow::Side;
    }
  }
  return -1.0;
}

TEST(SoftShadowMaps, WidthsOfPenumbraeMatchGeometry)
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
  for (const auto& configuration : all)
  {
    const std::vector<double> bare = Profile(configuration, false);
    std::vector<double> open = Profile(configuration, true);
    for (std::size_t i = 0; i < open.size(); ++i)
    {
      open[i] /= bare[i];
    }
    // Part of the whole width in which the light rises from 5 to 95 percent.
    constexpr double part = 0.8055;
    EXPECT_NEAR(DiscShare(part), 0.95, 1e-3);
    const double measured = (PositionOf(open, 0.95) - PositionOf(open, 0.05)) / part;
    std::printf("%-40s %8.4f %8.4f %8.3f\n", configuration.Name, configuration.Width(), measured,
      measured / configuration.Width());
    EXPECT_NEAR(measured / configuration.Width(), 1.0, 0.15) << configuration.Name;
    // The middle of the penumbra lies below the edge.
    EXPECT_NEAR(PositionOf(open, 0.5), 0.5, 0.1 * configuration.Width() + 1.0 / HalfShadow::Side)
      << configuration.Name;
  }
  TakeMessages();
}

// Mean radiance of frames at rest of a box and a ball on a floor.
std::vector<double> BoxAndBall(bool lamp, const char* technique, double size, int frames)
{
  Stage stage;
  stage.Window->SetSize(200, 150);
  AddFloor(stage, -3.0, 3.0, -3.0, 3.0)->GetProperty()->SetColor(1.0, 1.0, 1.0);
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
  vtkLight* light = AddLight(stage, -2.0, -1.0, 4.0);
  light->SetFocalPoint(0.0, 0.0, 0.5);
  light->SetPositional(lamp);
  light->SetConeAngle(180.0);
  stage.Renderer->AutomaticLightCreationOff();
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

TEST(SoftShadowMaps, ErrAtMostAThirdAsMuchAsAPlainFilter)
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
