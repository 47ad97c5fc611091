// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Light of the sky where it is known in closed form, and when its shadow maps are drawn.
 */
#include "Messages.h"
#include "Picture.h"
#include "SceneParts.h"
#include "Stage.h"

#include "vtkGISkyLight.h"

#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <utility>

using namespace penumbra_test;

namespace
{
constexpr int Side = 96;

// A sky by the sine of latitude, from -1 to 1.
vtkSmartPointer<vtkTexture> MakeSky(const std::function<double(double)>& radiance)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 32, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  for (int y = 0; y < 32; ++y)
  {
    const double height = std::sin(((y + 0.5) / 32.0 - 0.5) * vtkMath::Pi());
    for (int x = 0; x < 64; ++x)
    {
      for (int i = 0; i < 3; ++i)
      {
        image->SetScalarComponentFromDouble(x, y, 0, i, radiance(height));
      }
    }
  }
  return EnvironmentTexture(image);
}

class SkyLight : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Scene.Window->SetSize(Side, Side);
    this->Scene.Renderer->SetBackground(0.0, 0.0, 0.0);
    AddFaintLight(this->Scene.Renderer);
    ShineFrom(this->Scene.Renderer, MakeSky([](double) { return 1.0; }));
    this->Pass = this->Scene.SetPasses().front();
    this->Pass->KeepRadianceOn();
    this->Technique = vtkGISkyLight::SafeDownCast(this->Pass->GetTechnique("sky-light"));
    ASSERT_NE(this->Technique, nullptr);
    this->Technique->EnabledOn();
  }

  static void Paint(vtkActor* actor, double grey)
  {
    actor->GetProperty()->SetColor(grey, grey, grey);
  }

  vtkActor* AddBall(double x = 0.0, double z = 0.0)
  {
    vtkNew<vtkSphereSource> source;
    source->SetThetaResolution(32);
    source->SetPhiResolution(16);
    source->SetCenter(x, 0.0, z);
    vtkActor* ball = this->Scene.Add(source);
    Paint(ball, 0.4);
    return ball;
  }

  // Look from a point; height is that of the picture in world units.
  void Look(const Point& from, const Point& at, double height)
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5 * height);
    camera->SetPosition(from.data());
    camera->SetFocalPoint(at.data());
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  void Draw(int frames)
  {
    for (int i = 0; i < frames; ++i)
    {
      this->Scene.Window->Render();
    }
    EXPECT_TRUE(this->Pass->GetRadiance(this->Scene.Renderer, this->Radiance));
    EXPECT_STREQ(this->Pass->GetLastError(), "");
    EXPECT_TRUE(TakeMessages().empty());
  }

  int DrawnMaps() { return this->Technique->GetDrawnMaps(this->Scene.Renderer); }

  // Mean radiance of the pixels that surfaces cover.
  double Mean()
  {
    double sum = 0.0;
    double count = 0.0;
    vtkDataArray* values = this->Radiance->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      sum += values->GetComponent(i, 3) > 0.0 ? values->GetComponent(i, 1) : 0.0;
      count += values->GetComponent(i, 3) > 0.0 ? 1.0 : 0.0;
    }
    return sum / count;
  }

  // Mean of the 3 x 3 pixels around a point of the scene.
  double At(const Point& p)
  {
    vtkRenderer* renderer = this->Scene.Renderer;
    renderer->SetWorldPoint(p[0], p[1], p[2], 1.0);
    renderer->WorldToDisplay();
    const int x = static_cast<int>(renderer->GetDisplayPoint()[0]);
    const int y = static_cast<int>(renderer->GetDisplayPoint()[1]);
    double sum = 0.0;
    for (int i = 0; i < 9; ++i)
    {
      sum += this->Radiance->GetScalarComponentAsDouble(x + i % 3 - 1, y + i / 3 - 1, 0, 1) / 9.0;
    }
    return sum;
  }

  Stage Scene;
  vtkSmartPointer<vtkGIPass> Pass;
  vtkGISkyLight* Technique = nullptr;
  vtkNew<vtkImageData> Radiance;
};
}

TEST_F(SkyLight, OfAUniformSkyOnABallIsItsReflectance)
{
  vtkActor* ball = this->AddBall();
  this->Look({ { 0.0, -9.0, 3.0 } }, { { 0.0, 0.0, 0.0 } }, 1.2);
  for (const char* resolution : { "full", "half", "quarter" })
  {
    this->Technique->SetParameterFromText("resolution", resolution);
    this->Draw(1);
    EXPECT_NEAR(this->Mean(), 0.4, 4e-4) << resolution;
  }
  // PBR materials too, apart from the highlight: a black sky below leaves none on a matte ball seen from above.
  ball->GetProperty()->SetInterpolationToPBR();
  ball->GetProperty()->SetMetallic(0.0);
  ball->GetProperty()->SetRoughness(1.0);
  this->Draw(1);
  EXPECT_GT(this->Mean(), 0.96 * 0.4 - 0.01);
  EXPECT_LT(this->Mean(), 0.96 * 0.4 + 0.06);
}

// A rectangle of height h and half length a covers this share of the sky, weighted by the cosine, of a floor at distance
// d from its foot (Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-3).
TEST_F(SkyLight, BesideAWall)
{
  const double a = 3.0;
  Paint(AddFloor(this->Scene, -20.0, 20.0, -20.0, 20.0), 1.0);
  Paint(AddQuad(this->Scene, { { -a, 0.0, 0.0 } }, { { a, 0.0, 0.0 } }, { { -a, 0.0, 1.0 } }), 1.0);
  this->Look({ { 0.0, -9.0, 9.0 } }, { { 0.0, -1.0, 0.0 } }, 3.0);
  this->Technique->SetParameter("first-maps", 64);
  this->Draw(32);
  for (const double d : { 0.3, 0.5, 1.0, 1.8 })
  {
    const double far = std::sqrt(1.0 + d * d);
    const double hidden = (std::atan(a / d) - d / far * std::atan(a / far)) / vtkMath::Pi();
    const double light = this->At({ { 0.0, -d, 0.0 } });
    std::printf("wall at %g: %.4f, expected %.4f\n", d, light, 1.0 - hidden);
    EXPECT_NEAR(light, 1.0 - hidden, 0.01) << d;
  }
}

// Pixels of a block look up different maps. Their shares are joined so that the blocks do not show while the camera moves:
// the light between two neighbours lies between theirs.
TEST_F(SkyLight, IsSmoothWhileTheCameraMoves)
{
  Paint(AddFloor(this->Scene, -20.0, 20.0, -20.0, 20.0), 1.0);
  Paint(AddQuad(this->Scene, { { -3.0, 0.0, 0.0 } }, { { 3.0, 0.0, 0.0 } }, { { -3.0, 0.0, 1.0 } }),
    1.0);
  this->Technique->SetParameter("first-maps", 256);
  constexpr std::pair<const char*, double> limits[] = { { "full", 0.005 }, { "half", 0.0024 },
    { "quarter", 0.0012 } };
  for (const auto& [resolution, limit] : limits)
  {
    this->Technique->SetParameterFromText("resolution", resolution);
    this->Look({ { 0.0, -9.0, 9.0 } }, { { 0.0, -1.5, 0.0 } }, 1.5); // only the floor
    this->Draw(1);
    this->Scene.Renderer->GetActiveCamera()->Azimuth(2.0);
    this->Draw(1);
    // The wall's shadow is there: there is something to be rough.
    EXPECT_GT(this->At({ { 0.0, -2.0, 0.0 } }) - this->At({ { 0.0, -1.0, 0.0 } }), 0.05);
    double rough = 0.0;
    for (int y = 1; y + 1 < Side; ++y)
    {
      for (int x = 1; x + 1 < Side; ++x)
      {
        const auto light = [&](int i, int j) {
          return this->Radiance->GetScalarComponentAsDouble(i, j, 0, 1);
        };
        rough += std::abs(light(x - 1, y) + light(x + 1, y) - 2.0 * light(x, y)) +
          std::abs(light(x, y - 1) + light(x, y + 1) - 2.0 * light(x, y));
      }
    }
    rough /= (Side - 2) * (Side - 2) * this->Mean();
    std::printf("roughness at %s resolution: %.5f\n", resolution, rough);
    EXPECT_LT(rough, limit) << resolution;
  }
}

// Sides without thickness, seen from inside: no light comes in where they meet.
TEST_F(SkyLight, DoesNotLeakIntoAClosedBox)
{
  vtkNew<vtkCubeSource> source;
  vtkActor* box = this->Scene.Add(source);
  Paint(box, 1.0);
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.05, 0.45, 0.08);
  camera->SetFocalPoint(-0.1, -0.5, -0.1);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(100.0);
  camera->SetClippingRange(0.01, 3.0);
  this->Draw(16);
  std::printf("in the box: %.5f\n", this->Mean());
  EXPECT_LT(this->Mean(), 0.001);
}

// With the floor's own reflectance a and the share s of the light that arrives, all reflections give 1 / (1 - a (1 - s)).
// Live probes know what is reflected.
TEST_F(SkyLight, EstimatesReflectedLightUnlessItIsKnown)
{
  constexpr double a = 0.5;
  Paint(AddFloor(this->Scene, -20.0, 20.0, -20.0, 20.0), a);
  Paint(
    AddQuad(this->Scene, { { -3.0, 0.0, 0.0 } }, { { 3.0, 0.0, 0.0 } }, { { -3.0, 0.0, 1.0 } }), a);
  this->Look({ { 0.0, -9.0, 9.0 } }, { { 0.0, -1.0, 0.0 } }, 3.0);
  const auto lightWith = [this](double interreflection) {
    this->Technique->SetParameter("interreflection", interreflection);
    this->Pass->Restart();
    this->Draw(1);
    return this->At({ { 0.0, -0.3, 0.0 } });
  };
  const double straight = lightWith(0.0);
  ASSERT_LT(straight, 0.9 * a);
  EXPECT_NEAR(lightWith(1.0), straight / (1.0 - a * (1.0 - straight / a)), 0.01 * straight);
  this->Pass->GetTechnique("ddgi")->EnabledOn();
  const double known = lightWith(0.0);
  EXPECT_NEAR(lightWith(1.0), known, 0.002 * known);
}

TEST_F(SkyLight, DrawsMapsOnlyWhilePropsChange)
{
  vtkActor* ball = this->AddBall();
  this->AddBall(2.0);
  this->Look({ { 0.0, -9.0, 3.0 } }, { { 0.0, 0.0, 0.0 } }, 4.0);
  this->Technique->SetParameter("maps", 64);
  this->Technique->SetParameter("first-maps", 48);
  this->Draw(1);
  EXPECT_EQ(this->DrawnMaps(), 48);
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  for (const int expected : { 8, 8, 0, 0 })
  {
    camera->Azimuth(5.0);
    this->Draw(1);
    EXPECT_EQ(this->DrawnMaps(), expected);
  }
  this->Draw(1); // a still frame goes on with other directions
  EXPECT_EQ(this->DrawnMaps(), 48);
  // The sky turns with the camera: the maps stay.
  this->Scene.Renderer->SetEnvironmentRight(0.0, 1.0, 0.0);
  this->Draw(1);
  EXPECT_EQ(this->DrawnMaps(), 0);
  ball->SetPosition(0.1, 0.0, 0.0);
  this->Draw(1);
  EXPECT_EQ(this->DrawnMaps(), 48);
}

// The sky is bright above and black below; which side is up is the renderer's to say.
TEST_F(SkyLight, FollowsTheEnvironmentsOrientation)
{
  Paint(AddFloor(this->Scene, -1.0, 1.0, -1.0, 1.0), 0.5);
  ShineFrom(this->Scene.Renderer, MakeSky([](double height) { return height > 0.0 ? 1.0 : 0.0; }));
  this->Look({ { 0.0, -9.0, 9.0 } }, { { 0.0, 0.0, 0.0 } }, 1.0);
  this->Draw(1);
  EXPECT_NEAR(this->Mean(), 0.5, 0.005);
  this->Scene.Renderer->SetEnvironmentUp(0.0, 0.0, -1.0);
  this->Draw(1);
  EXPECT_NEAR(this->Mean(), 0.0, 0.005);
  this->Scene.Renderer->SetEnvironmentUp(0.0, 1.0, 0.0);
  this->Draw(1);
  EXPECT_NEAR(this->Mean(), 0.25, 0.005);
}

TEST_F(SkyLight, ConvergesInStillFrames)
{
  Paint(AddFloor(this->Scene, -4.0, 4.0, -4.0, 4.0), 0.8);
  this->AddBall(0.0, 0.5);
  this->Look({ { 0.0, -9.0, 6.0 } }, { { 0.0, 0.0, 0.2 } }, 2.5);
  const auto pictureAfter = [this](int frames) {
    this->Draw(frames);
    std::vector<double> values;
    for (vtkIdType i = 0; i < Side * Side; ++i)
    {
      values.push_back(this->Radiance->GetPointData()->GetScalars()->GetComponent(i, 1));
    }
    return values;
  };
  const auto first = pictureAfter(1);
  const auto later = pictureAfter(19);
  const auto last = pictureAfter(100);
  RelativeError error1;
  RelativeError error20;
  for (std::size_t i = 0; i < last.size(); ++i)
  {
    error1.Add(first[i], last[i]);
    error20.Add(later[i], last[i]);
  }
  std::printf("frame 1: %.5f, frame 20: %.5f\n", error1.Mean(), error20.Mean());
  EXPECT_LT(error1.Mean(), 0.02);
  EXPECT_LT(error20.Mean(), 0.25 * error1.Mean());
}

TEST_F(SkyLight, RestsWithoutAnEnvironmentAndUnderPaths)
{
  this->AddBall();
  this->Look({ { 0.0, -9.0, 3.0 } }, { { 0.0, 0.0, 0.0 } }, 1.2);
  for (const char* technique : { "", "path-tracing" })
  {
    const bool traced = *technique != 0;
    this->Scene.Renderer->SetUseImageBasedLighting(traced);
    if (traced)
    {
      this->Pass->GetTechnique(technique)->EnabledOn();
    }
    this->Technique->EnabledOn();
    this->Pass->Restart();
    const Picture with = Shoot(this->Scene.Window);
    EXPECT_EQ(this->DrawnMaps(), 0);
    this->Technique->EnabledOff();
    this->Pass->Restart();
    EXPECT_EQ(Compare(with, Shoot(this->Scene.Window), 0).Max, 0) << technique;
  }
}

// A corner of white sides: light that the sides reflect comes from live probes, which leave out what arrives straight
// from the sky, and so it is counted once.
TEST_F(SkyLight, AndLiveProbesAddUpToPaths)
{
  Paint(AddFloor(this->Scene, -1.0, 1.0, -1.0, 1.0), 0.7);
  Paint(AddQuad(this->Scene, { { -1.0, 1.0, 0.0 } }, { { 1.0, 1.0, 0.0 } }, { { -1.0, 1.0, 2.0 } }),
    0.7);
  Paint(
    AddQuad(this->Scene, { { -1.0, -1.0, 0.0 } }, { { -1.0, 1.0, 0.0 } }, { { -1.0, -1.0, 2.0 } }),
    0.7);
  this->Look({ { 6.0, -7.0, 5.0 } }, { { -0.3, 0.3, 0.7 } }, 2.4);
  this->Scene.Window->SetSize(48, 48);
  vtkGITechnique* probes = this->Pass->GetTechnique("ddgi");
  probes->EnabledOn();
  probes->SetParameter("probes", 512);
  this->Draw(60);
  const double drawn = this->Mean();
  vtkGITechnique* rays = this->Pass->GetTechnique("ray-traced-light");
  rays->EnabledOn();
  this->Pass->GetTechnique("temporal-accumulation")->EnabledOn(); // one frame's noise would be 2 %
  this->Draw(60);
  const double gathered = this->Mean();
  probes->EnabledOff();
  rays->EnabledOff();
  this->Technique->EnabledOff();
  this->Pass->SetPreset("reference");
  this->Draw(64);
  const double traced = this->Mean();
  std::printf("drawn %.4f, with rays %.4f, traced %.4f\n", drawn, gathered, traced);
  EXPECT_NEAR(drawn, traced, 0.03 * traced);
  EXPECT_NEAR(gathered, traced, 0.01 * traced);
}

TEST_F(SkyLight, IsFoundByRaysWhileItRests)
{
  this->AddBall();
  this->Look({ { 0.0, -9.0, 3.0 } }, { { 0.0, 0.0, 0.0 } }, 1.2);
  this->Technique->EnabledOff();
  this->Pass->GetTechnique("ray-traced-light")->EnabledOn();
  this->Pass->GetTechnique("temporal-accumulation")->EnabledOn();
  this->Draw(32);
  EXPECT_NEAR(this->Mean(), 0.4, 0.003); // less the rays below the facets of the ball
  // What rays found before a technique was switched is not kept.
  this->Technique->EnabledOn();
  this->Draw(40);
  EXPECT_NEAR(this->Mean(), 0.4, 0.003);
  this->Technique->EnabledOff();
  this->Draw(8);
  EXPECT_NEAR(this->Mean(), 0.4, 0.006);
}

// The picture is the same after all resources were released, and in a second renderer.
TEST_F(SkyLight, SurvivesReleasedResourcesAndSecondRenderers)
{
  this->AddBall();
  this->Look({ { 0.0, -9.0, 3.0 } }, { { 0.0, 0.0, 0.0 } }, 1.2);
  const Picture before = Shoot(this->Scene.Window);
  this->Pass->ReleaseGraphicsResources(this->Scene.Window);
  EXPECT_LE(Compare(before, Shoot(this->Scene.Window), 0).Max, 1);
  vtkRenderer* second = this->Scene.AddRenderer();
  second->SetBackground(0.0, 0.0, 0.0);
  AddFaintLight(second);
  ShineFrom(second, MakeSky([](double) { return 0.5; }));
  second->AddActor(this->Scene.Renderer->GetActors()->GetLastActor());
  second->SetActiveCamera(this->Scene.Renderer->GetActiveCamera());
  this->Scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  second->SetViewport(0.5, 0.0, 1.0, 1.0);
  second->SetPass(this->Pass);
  for (int i = 0; i < 3; ++i)
  {
    const Picture both = Shoot(this->Scene.Window);
    EXPECT_NEAR(both.Grey(Side / 4, Side / 2), 0.4 * 255.0, 1.0);
    EXPECT_NEAR(both.Grey(3 * Side / 4, Side / 2), 0.2 * 255.0, 1.0);
  }
  EXPECT_TRUE(TakeMessages().empty());
}

// What VTK draws itself gets the same light.
TEST_F(SkyLight, LightsTranslucentSurfaces)
{
  Paint(AddFloor(this->Scene, -2.0, 2.0, -2.0, 2.0), 0.6);
  vtkActor* roof = AddFloor(this->Scene, -1.0, 1.0, -1.0, 1.0, 0.5);
  Paint(roof, 0.6);
  this->Look({ { 0.0, -9.0, 9.0 } }, { { 0.0, 0.0, 0.5 } }, 1.0);
  this->Draw(1);
  const double opaque = this->Mean();
  EXPECT_NEAR(opaque, 0.6, 0.002);
  roof->GetProperty()->SetOpacity(0.999);
  const Picture blended = Shoot(this->Scene.Window);
  EXPECT_NEAR(blended.MeanGrey(40, 40, 56, 56), 0.6 * 255.0, 2.0);
  EXPECT_TRUE(TakeMessages().empty());
}
