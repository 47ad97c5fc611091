// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Ambient occlusion where the openness of visible surfaces is known in closed form. Every light is
 * spread over all directions and all surfaces are white, so that a picture shows openness.
 */
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkGITechnique.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
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
using Point = std::array<double, 3>;

constexpr double Limit = 0.06; // of openness, from 0 to 1
constexpr double Endless = 1e30;

// The parameter stands for resolution: "full" or "half".
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

  void AddQuad(const Point& origin, const Point& a, const Point& b)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(origin[0], origin[1], origin[2]);
    plane->SetPoint1(a[0], a[1], a[2]);
    plane->SetPoint2(b[0], b[1], b[2]);
    White(this->Scene.Add(plane));
  }

  static void White(vtkActor* actor) { actor->GetProperty()->SetColor(1.0, 1.0, 1.0); }

  void Look(const Point& from, const Point& at, double height, bool parallel = true)
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    camera->SetParallelScale(0.5 * height);
    camera->SetPosition(from[0], from[1], from[2]);
    camera->SetFocalPoint(at[0], at[1], at[2]);
    camera->SetViewUp(0.0, from[0] == at[0] && from[1] == at[1] ? 1.0 : 0.0,
      from[0] == at[0] && from[1] == at[1] ? 0.0 : 1.0);
    this->Scene.Renderer->ResetCameraClippingRange();
    this->Shown = Shoot(this->Scene.Window);
    std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    name = name.substr(0, name.find('/'));
    Save(
      this->Shown, "openness-" + name + "-" + std::to_string(++this->Pictures) + "-" + GetParam());
  }

  // Of the 3 x 3 pixels around a point.
  double At(const Point& p)
  {
    vtkRenderer* renderer = this->Scene.Renderer;
    renderer->SetWorldPoint(p[0], p[1], p[2], 1.0);
    renderer->WorldToDisplay();
    const double* display = renderer->GetDisplayPoint();
    const int x = static_cast<int>(display[0]);
    const int y = static_cast<int>(display[1]);
    return this->Shown.MeanGrey(x - 1, y - 1, x + 2, y + 2) / 255.0;
  }

  void Expect(const char* what, const Point& p, double openness)
  {
    const double measured = this->At(p);
    std::printf("%-56s %-4s openness %.3f, expected %.3f, off %+.3f\n", what, this->GetParam(),
      measured, openness, measured - openness);
    EXPECT_NEAR(measured, openness, Limit) << what;
  }

  void AddFloor(double size = 30.0)
  {
    this->AddQuad({ { -size, -size, 0.0 } }, { { size, -size, 0.0 } }, { { -size, size, 0.0 } });
  }

  Stage Scene;
  vtkGITechnique* Occlusion = nullptr;
  Picture Shown;
  int Pictures = 0;
};
}

// A sphere of radius 1 resting on a plane hides (x^2 + 1)^(-3/2) from a point at x from its foot.
TEST_P(Openness, before_a_sphere_on_a_plane)
{
  this->AddFloor();
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetCenter(0.0, 0.0, 1.0);
  sphere->SetThetaResolution(180);
  sphere->SetPhiResolution(90);
  White(this->Scene.Add(sphere));
  this->Look({ { 0.0, -9.0, 3.0 } }, { { 0.0, -1.0, 0.5 } }, 5.0);
  for (double x : { 0.5, 1.0, 2.0 })
  {
    char name[64];
    std::snprintf(name, sizeof(name), "sphere on a plane, %g from its foot", x);
    this->Expect(name, { { 0.0, -x, 0.0 } }, 1.0 - std::pow(x * x + 1.0, -1.5));
  }
}

// An endless wall of height h hides half of 1 - d / sqrt(d^2 + h^2) at distance d.
TEST_P(Openness, before_an_endless_wall)
{
  this->AddFloor();
  this->AddQuad({ { -30.0, 0.0, 0.0 } }, { { 30.0, 0.0, 0.0 } }, { { -30.0, 0.0, 1.0 } });
  this->Look({ { 0.0, -9.0, 6.0 } }, { { 0.0, 0.0, 0.3 } }, 6.0);
  for (double d : { 0.1, 0.25, 0.5, 1.0, 2.0 })
  {
    char name[64];
    std::snprintf(name, sizeof(name), "wall of height 1 at distance %g", d);
    this->Expect(name, { { 0.0, -d, 0.0 } }, 0.5 + 0.5 * d / std::sqrt(d * d + 1.0));
  }
}

// Up to a radius R, a wall as high hides a segment of the unit disc that the hemisphere is
// projected to: (acos c - c sqrt(1 - c^2)) / pi, c = d / R.
TEST_P(Openness, within_a_radius_before_a_wall)
{
  this->AddFloor();
  this->AddQuad({ { -30.0, 0.0, 0.0 } }, { { 30.0, 0.0, 0.0 } }, { { -30.0, 0.0, 1.5 } });
  this->Occlusion->SetParameter("radius", 1.0);
  this->Look({ { 0.0, -9.0, 6.0 } }, { { 0.0, 0.0, 0.3 } }, 5.0);
  for (double d : { 0.1, 0.3, 0.6, 0.9, 1.2 })
  {
    char name[64];
    std::snprintf(name, sizeof(name), "radius 1, wall at distance %g", d);
    const double c = std::min(d, 1.0);
    this->Expect(name, { { 0.0, -d, 0.0 } },
      1.0 - (std::acos(c) - c * std::sqrt(1.0 - c * c)) / vtkMath::Pi());
  }
}

// Where two planes meet at an angle, (1 - cos) / 2 is open to either.
TEST_P(Openness, between_two_planes)
{
  for (double degrees : { 45.0, 90.0, 135.0 })
  {
    const double angle = vtkMath::RadiansFromDegrees(degrees);
    const double x = std::cos(angle);
    const double z = std::sin(angle);
    this->Scene.Renderer->RemoveAllViewProps();
    this->AddQuad({ { 0.0, -30.0, 0.0 } }, { { 30.0, -30.0, 0.0 } }, { { 0.0, 30.0, 0.0 } });
    this->AddQuad(
      { { 0.0, -30.0, 0.0 } }, { { 30.0 * x, -30.0, 30.0 * z } }, { { 0.0, 30.0, 0.0 } });
    // From between them.
    const double middle = 0.5 * angle;
    this->Look(
      { { 50.0 * std::cos(middle), 0.0, 50.0 * std::sin(middle) } }, { { 0.0, 0.0, 0.0 } }, 8.0);
    const double openness = 0.5 - 0.5 * std::cos(angle);
    char name[64];
    std::snprintf(name, sizeof(name), "wedge of %g degrees, on the floor", degrees);
    this->Expect(name, { { 0.3, 0.0, 0.0 } }, openness);
    std::snprintf(name, sizeof(name), "wedge of %g degrees, on the wall", degrees);
    this->Expect(name, { { 0.3 * x, 0.0, 0.3 * z } }, openness);
  }
}

// Half the directions are open, everywhere in a hemispherical pit.
TEST_P(Openness, in_a_hemispherical_pit)
{
  vtkNew<vtkSphereSource> pit;
  pit->SetRadius(1.0);
  pit->SetThetaResolution(180);
  pit->SetPhiResolution(90);
  pit->SetStartPhi(90.0);
  White(this->Scene.Add(pit));
  this->Look({ { 0.0, 0.0, 9.0 } }, { { 0.0, 0.0, 0.0 } }, 2.2);
  for (double r : { 0.0, 0.3, 0.6, 0.8, 0.9 })
  {
    char name[64];
    std::snprintf(name, sizeof(name), "hemispherical pit, %g from its middle", r);
    this->Expect(name, { { r, 0.0, -std::sqrt(1.0 - r * r) } }, 0.5);
  }
}

// A bar over a floor hides what it fills of the hemisphere, and light passes under it.
TEST_P(Openness, below_a_thin_bar)
{
  const double height = 0.5;
  const double half = 0.04;
  this->AddFloor();
  this->AddQuad(
    { { -30.0, -half, height } }, { { 30.0, -half, height } }, { { -30.0, half, height } });
  this->Occlusion->SetParameter("thickness", half);
  this->Look({ { 0.0, 0.0, 9.0 } }, { { 0.0, 0.0, 0.0 } }, 3.0);
  for (double d : { 0.1, 0.2, 0.5 })
  {
    char name[64];
    std::snprintf(name, sizeof(name), "beside a thin bar, at distance %g", d);
    const auto sine = [height](double y) { return y / std::sqrt(y * y + height * height); };
    this->Expect(name, { { 0.0, -d, 0.0 } }, 1.0 - 0.5 * (sine(d + half) - sine(d - half)));
  }
}

// Light reflected within a spherical hollow is the same everywhere: E = openness / (1 - reflectance
// (1 - openness)).
TEST_P(Openness, between_reflecting_walls)
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
    this->Look({ { 0.0, 0.0, 9.0 } }, { { 0.0, 0.0, 0.0 } }, 2.2);
    char name[64];
    std::snprintf(name, sizeof(name), "pit that reflects %g: light reflected", reflectance);
    this->Expect(name, { { 0.3, 0.0, -std::sqrt(1.0 - 0.09) } },
      reflectance * 0.5 / (1.0 - 0.5 * reflectance));
  }
}

// A wall in windows of any shape, in viewports of odd sizes at odd places.
TEST_P(Openness, in_any_viewport)
{
  this->AddFloor();
  this->AddQuad({ { -30.0, 0.0, 0.0 } }, { { 30.0, 0.0, 0.0 } }, { { -30.0, 0.0, 1.0 } });
  const std::array<std::array<double, 6>, 5> shapes{ { { { 301, 417, 0.0, 0.0, 1.0, 1.0 } },
    { { 803, 301, 0.0, 0.0, 1.0, 1.0 } }, { { 641, 479, 0.37, 0.21, 1.0, 1.0 } },
    { { 641, 479, 0.0, 0.0, 0.73, 0.61 } }, { { 640, 480, 0.11, 0.13, 0.87, 0.91 } } } };
  for (const auto& shape : shapes)
  {
    this->Scene.Window->SetSize(static_cast<int>(shape[0]), static_cast<int>(shape[1]));
    this->Scene.Renderer->SetViewport(shape[2], shape[3], shape[4], shape[5]);
    this->Look({ { 0.0, -9.0, 6.0 } }, { { 0.0, 0.0, 0.3 } }, 6.0);
    for (double d : { 0.25, 1.0 })
    {
      char name[64];
      std::snprintf(name, sizeof(name), "%g x %g from %g, %g to %g, %g: wall at %g", shape[0],
        shape[1], shape[2], shape[3], shape[4], shape[5], d);
      this->Expect(name, { { 0.0, -d, 0.0 } }, 0.5 + 0.5 * d / std::sqrt(d * d + 1.0));
    }
  }
}

// A sphere on a plane once more, in perspective, and far from the origin.
TEST_P(Openness, in_perspective_and_far_away)
{
  for (double away : { 0.0, 1e6 })
  {
    this->Scene.Renderer->RemoveAllViewProps();
    vtkNew<vtkPlaneSource> floor;
    floor->SetOrigin(-30.0, -30.0, 0.0);
    floor->SetPoint1(30.0, -30.0, 0.0);
    floor->SetPoint2(-30.0, 30.0, 0.0);
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(1.0);
    sphere->SetCenter(0.0, 0.0, 1.0);
    sphere->SetThetaResolution(180);
    sphere->SetPhiResolution(90);
    for (vtkAlgorithm* source :
      { static_cast<vtkAlgorithm*>(floor), static_cast<vtkAlgorithm*>(sphere) })
    {
      vtkActor* actor = this->Scene.Add(source);
      White(actor);
      actor->SetPosition(away, away, 0.0);
    }
    this->Look({ { away, away - 9.0, 3.0 } }, { { away, away - 1.0, 0.5 } }, 5.0, false);
    for (double x : { 0.5, 1.0, 2.0 })
    {
      char name[64];
      std::snprintf(name, sizeof(name), "sphere in perspective, %g from the origin, %g", away, x);
      this->Expect(name, { { away, away - x, 0.0 } }, 1.0 - std::pow(x * x + 1.0, -1.5));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AmbientOcclusion, Openness, ::testing::Values("full", "half"));
