// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Ambient occlusion where the openness of visible surfaces is known in closed form. All light is ambient and all
 * surfaces are white, so that a picture shows openness.
 */
#include "Messages.h"
#include "Picture.h"
#include "SceneParts.h"
#include "Stage.h"

#include "vtkGITechnique.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

using namespace penumbra_test;

namespace
{
constexpr double Limit = 0.06; // largest error of openness, which is from 0 to 1
constexpr double Endless = 1e30;

// The parameter is the resolution, "full" or "half".
class Openness : public ::testing::TestWithParam<const char*>
{
protected:
  void SetUp() override
  {
    this->Scene.Window->SetSize(640, 480);
    this->Occlusion = this->Scene.SetPasses().front()->GetTechnique("ambient-occlusion");
    ASSERT_NE(this->Occlusion, nullptr);
    this->Occlusion->EnabledOn();
    this->Occlusion->SetParameter("ambient-share", 1.0);
    this->Occlusion->SetParameter("interreflection", 0.0);
    this->Occlusion->SetParameter("radius", Endless);
    this->Occlusion->SetParameter("thickness", Endless);
    this->Occlusion->SetParameter("samples", 64);
    this->Occlusion->SetParameterFromText("resolution", this->GetParam());
  }

  void AddWhiteQuad(const Point& origin, const Point& firstCorner, const Point& secondCorner)
  {
    PaintWhite(AddQuad(this->Scene, origin, firstCorner, secondCorner));
  }

  static void PaintWhite(vtkActor* actor) { actor->GetProperty()->SetColor(1.0, 1.0, 1.0); }

  // Draw the scene from a point. height is that of the picture in world units.
  void Draw(const Point& from, const Point& at, double height, bool parallel = true)
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    camera->SetParallelScale(0.5 * height);
    camera->SetPosition(from[0], from[1], from[2]);
    camera->SetFocalPoint(at[0], at[1], at[2]);
    camera->SetViewUp(0.0, from[0] == at[0] && from[1] == at[1] ? 1.0 : 0.0,
      from[0] == at[0] && from[1] == at[1] ? 0.0 : 1.0);
    this->Scene.Renderer->ResetCameraClippingRange();
    this->Drawing = Shoot(this->Scene.Window);
    std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    name = name.substr(0, name.find('/'));
    Save(this->Drawing,
      "openness-" + name + "-" + std::to_string(++this->Pictures) + "-" + GetParam());
  }

  // Mean of the 3 x 3 pixels around a point.
  double OpennessAt(const Point& p)
  {
    vtkRenderer* renderer = this->Scene.Renderer;
    renderer->SetWorldPoint(p[0], p[1], p[2], 1.0);
    renderer->WorldToDisplay();
    const double* display = renderer->GetDisplayPoint();
    const int x = static_cast<int>(display[0]);
    const int y = static_cast<int>(display[1]);
    return this->Drawing.MeanGrey(x - 1, y - 1, x + 2, y + 2) / 255.0;
  }

  void Expect(const char* what, const Point& p, double openness)
  {
    const double measured = this->OpennessAt(p);
    std::printf("%-56s %-4s openness %.3f, expected %.3f, off %+.3f\n", what, this->GetParam(),
      measured, openness, measured - openness);
    EXPECT_NEAR(measured, openness, Limit) << what;
  }

  void AddWhiteFloor(double size = 30.0)
  {
    this->AddWhiteQuad(
      { { -size, -size, 0.0 } }, { { size, -size, 0.0 } }, { { -size, size, 0.0 } });
  }

  Stage Scene;
  vtkGITechnique* Occlusion = nullptr;
  Picture Drawing;
  int Pictures = 0;
};
}

// A sphere of radius 1 that rests on a plane occludes (x^2 + 1)^(-3/2) at distance x from its foot.
TEST_P(Openness, BesideASphereOnAPlane)
{
  this->AddWhiteFloor();
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetCenter(0.0, 0.0, 1.0);
  sphere->SetThetaResolution(180);
  sphere->SetPhiResolution(90);
  PaintWhite(this->Scene.Add(sphere));
  this->Draw({ { 0.0, -9.0, 3.0 } }, { { 0.0, -1.0, 0.5 } }, 5.0);
  for (double x : { 0.5, 1.0, 2.0 })
  {
    char name[64];
    std::snprintf(name, sizeof(name), "sphere on a plane, %g from its foot", x);
    this->Expect(name, { { 0.0, -x, 0.0 } }, 1.0 - std::pow(x * x + 1.0, -1.5));
  }
}

// An endless wall of height h occludes half of 1 - d / sqrt(d^2 + h^2) at distance d.
TEST_P(Openness, BesideAnEndlessWall)
{
  this->AddWhiteFloor();
  this->AddWhiteQuad({ { -30.0, 0.0, 0.0 } }, { { 30.0, 0.0, 0.0 } }, { { -30.0, 0.0, 1.0 } });
  this->Draw({ { 0.0, -9.0, 6.0 } }, { { 0.0, 0.0, 0.3 } }, 6.0);
  for (double d : { 0.1, 0.25, 0.5, 1.0, 2.0 })
  {
    char name[64];
    std::snprintf(name, sizeof(name), "wall of height 1 at distance %g", d);
    this->Expect(name, { { 0.0, -d, 0.0 } }, 0.5 + 0.5 * d / std::sqrt(d * d + 1.0));
  }
}

// Within a radius R, a wall of at least that height occludes a segment of the unit disc that the hemisphere is
// projected to: (acos c - c sqrt(1 - c^2)) / pi, c = d / R.
TEST_P(Openness, WithinARadiusBesideAWall)
{
  this->AddWhiteFloor();
  this->AddWhiteQuad({ { -30.0, 0.0, 0.0 } }, { { 30.0, 0.0, 0.0 } }, { { -30.0, 0.0, 1.5 } });
  this->Occlusion->SetParameter("radius", 1.0);
  this->Draw({ { 0.0, -9.0, 6.0 } }, { { 0.0, 0.0, 0.3 } }, 5.0);
  for (double d : { 0.1, 0.3, 0.6, 0.9, 1.2 })
  {
    char name[64];
    std::snprintf(name, sizeof(name), "radius 1, wall at distance %g", d);
    const double c = std::min(d, 1.0);
    this->Expect(name, { { 0.0, -d, 0.0 } },
      1.0 - (std::acos(c) - c * std::sqrt(1.0 - c * c)) / vtkMath::Pi());
  }
}

// Where two planes meet at an angle, each has an openness of (1 - cos) / 2.
TEST_P(Openness, BetweenTwoPlanes)
{
  for (double degrees : { 45.0, 90.0, 135.0 })
  {
    const double angle = vtkMath::RadiansFromDegrees(degrees);
    const double x = std::cos(angle);
    const double z = std::sin(angle);
    this->Scene.Renderer->RemoveAllViewProps();
    this->AddWhiteQuad({ { 0.0, -30.0, 0.0 } }, { { 30.0, -30.0, 0.0 } }, { { 0.0, 30.0, 0.0 } });
    this->AddWhiteQuad(
      { { 0.0, -30.0, 0.0 } }, { { 30.0 * x, -30.0, 30.0 * z } }, { { 0.0, 30.0, 0.0 } });
    // The camera is between them.
    const double middle = 0.5 * angle;
    this->Draw(
      { { 50.0 * std::cos(middle), 0.0, 50.0 * std::sin(middle) } }, { { 0.0, 0.0, 0.0 } }, 8.0);
    const double openness = 0.5 - 0.5 * std::cos(angle);
    char name[64];
    std::snprintf(name, sizeof(name), "wedge of %g degrees, on the floor", degrees);
    this->Expect(name, { { 0.3, 0.0, 0.0 } }, openness);
    std::snprintf(name, sizeof(name), "wedge of %g degrees, on the wall", degrees);
    this->Expect(name, { { 0.3 * x, 0.0, 0.3 * z } }, openness);
  }
}

// The openness is one half everywhere in a hemispherical pit.
TEST_P(Openness, InAHemisphericalPit)
{
  vtkNew<vtkSphereSource> pit;
  pit->SetRadius(1.0);
  pit->SetThetaResolution(180);
  pit->SetPhiResolution(90);
  pit->SetStartPhi(90.0);
  PaintWhite(this->Scene.Add(pit));
  this->Draw({ { 0.0, 0.0, 9.0 } }, { { 0.0, 0.0, 0.0 } }, 2.2);
  for (double r : { 0.0, 0.3, 0.6, 0.8, 0.9 })
  {
    char name[64];
    std::snprintf(name, sizeof(name), "hemispherical pit, %g from its middle", r);
    this->Expect(name, { { r, 0.0, -std::sqrt(1.0 - r * r) } }, 0.5);
  }
}

// A bar over a floor occludes its own part of the hemisphere, and light passes below it.
TEST_P(Openness, BesideAThinBar)
{
  const double height = 0.5;
  const double half = 0.04;
  this->AddWhiteFloor();
  this->AddWhiteQuad(
    { { -30.0, -half, height } }, { { 30.0, -half, height } }, { { -30.0, half, height } });
  this->Occlusion->SetParameter("thickness", half);
  this->Draw({ { 0.0, 0.0, 9.0 } }, { { 0.0, 0.0, 0.0 } }, 3.0);
  for (double d : { 0.1, 0.2, 0.5 })
  {
    char name[64];
    std::snprintf(name, sizeof(name), "beside a thin bar, at distance %g", d);
    const auto sine = [height](double y) { return y / std::sqrt(y * y + height * height); };
    this->Expect(name, { { 0.0, -d, 0.0 } }, 1.0 - 0.5 * (sine(d + half) - sine(d - half)));
  }
}

// Light reflected within a hemispherical pit is the same everywhere: E = openness / (1 - reflectance (1 - openness)).
TEST_P(Openness, InAReflectingPit)
{
  vtkNew<vtkSphereSource> pit;
  pit->SetRadius(1.0);
  pit->SetThetaResolution(180);
  pit->SetPhiResolution(90);
  pit->SetStartPhi(90.0);
  vtkActor* actor = this->Scene.Add(pit);
  this->Occlusion->SetParameter("interreflection", 1.0);
  for (double reflectance : { 0.2, 0.5, 0.9 })
  {
    actor->GetProperty()->SetColor(reflectance, reflectance, reflectance);
    this->Draw({ { 0.0, 0.0, 9.0 } }, { { 0.0, 0.0, 0.0 } }, 2.2);
    char name[64];
    std::snprintf(name, sizeof(name), "pit that reflects %g: light reflected", reflectance);
    this->Expect(name, { { 0.3, 0.0, -std::sqrt(1.0 - 0.09) } },
      reflectance * 0.5 / (1.0 - 0.5 * reflectance));
  }
}

// A wall in windows of several shapes, in viewports of odd sizes at odd positions.
TEST_P(Openness, InAnyViewport)
{
  this->AddWhiteFloor();
  this->AddWhiteQuad({ { -30.0, 0.0, 0.0 } }, { { 30.0, 0.0, 0.0 } }, { { -30.0, 0.0, 1.0 } });
  const std::array<std::array<double, 6>, 5> shapes{ { { { 301, 417, 0.0, 0.0, 1.0, 1.0 } },
    { { 803, 301, 0.0, 0.0, 1.0, 1.0 } }, { { 641, 479, 0.37, 0.21, 1.0, 1.0 } },
    { { 641, 479, 0.0, 0.0, 0.73, 0.61 } }, { { 640, 480, 0.11, 0.13, 0.87, 0.91 } } } };
  for (const auto& shape : shapes)
  {
    this->Scene.Window->SetSize(static_cast<int>(shape[0]), static_cast<int>(shape[1]));
    this->Scene.Renderer->SetViewport(shape[2], shape[3], shape[4], shape[5]);
    this->Draw({ { 0.0, -9.0, 6.0 } }, { { 0.0, 0.0, 0.3 } }, 6.0);
    for (double d : { 0.25, 1.0 })
    {
      char name[64];
      std::snprintf(name, sizeof(name), "%g x %g from %g, %g to %g, %g: wall at %g", shape[0],
        shape[1], shape[2], shape[3], shape[4], shape[5], d);
      this->Expect(name, { { 0.0, -d, 0.0 } }, 0.5 + 0.5 * d / std::sqrt(d * d + 1.0));
    }
  }
}

// A sphere on a plane in perspective, at the origin and far away from it.
TEST_P(Openness, InPerspectiveAndFarFromTheOrigin)
{
  for (double offset : { 0.0, 1e6 })
  {
    this->Scene.Renderer->RemoveAllViewProps();
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(1.0);
    sphere->SetCenter(0.0, 0.0, 1.0);
    sphere->SetThetaResolution(180);
    sphere->SetPhiResolution(90);
    for (vtkActor* actor :
      { AddFloor(this->Scene, -30.0, 30.0, -30.0, 30.0), this->Scene.Add(sphere) })
    {
      PaintWhite(actor);
      actor->SetPosition(offset, offset, 0.0);
    }
    this->Draw({ { offset, offset - 9.0, 3.0 } }, { { offset, offset - 1.0, 0.5 } }, 5.0, false);
    for (double x : { 0.5, 1.0, 2.0 })
    {
      char name[64];
      std::snprintf(name, sizeof(name),
        "sphere in perspective, %g from the origin, %g from its foot", offset, x);
      this->Expect(name, { { offset, offset - x, 0.0 } }, 1.0 - std::pow(x * x + 1.0, -1.5));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AmbientOcclusion, Openness, ::testing::Values("full", "half"));
