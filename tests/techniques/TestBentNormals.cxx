// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where light comes from past what is near, as ambient occlusion hands it to probes: before a wall the mean direction is
 * known in closed form; probes asked for it tell sides apart, and in a furnace it changes nothing.
 */
#include "RoomStage.h"

#include "vtkGITechnique.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkRenderer.h>
#include <vtkVector.h>
#if __has_include(<vtkVectorOperators.h>) // gone from VTK 9.6, which has them in vtkVector.h
#include <vtkVectorOperators.h>
#endif

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

using namespace penumbra_test;

namespace
{
struct Way
{
  const char* Name;
  const char* Resolution;
  double Thickness;
  double Limit; ///< degrees
};

std::ostream& operator<<(std::ostream& stream, const Way& way)
{
  return stream << way.Name;
}

class BentNormals : public ::testing::TestWithParam<Way>
{
protected:
  void AddQuad(const vtkVector3d& origin, const vtkVector3d& a, const vtkVector3d& b)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(const_cast<double*>(origin.GetData()));
    plane->SetPoint1(const_cast<double*>(a.GetData()));
    plane->SetPoint2(const_cast<double*>(b.GetData()));
    this->Scene.Add(plane);
  }

  // A wall of height 1 at y = 0 on a floor, seen from -y.
  void Build()
  {
    this->Scene.Window->SetSize(320, 240);
    this->AddQuad({ -30, -30, 0 }, { 30, -30, 0 }, { -30, 30, 0 });
    this->AddQuad({ -30, 0, 0 }, { 30, 0, 0 }, { -30, 0, 1 });
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(3.0);
    camera->SetPosition(0.0, -9.0, 6.0);
    camera->SetFocalPoint(0.0, 0.0, 0.3);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Scene.Renderer->ResetCameraClippingRange();
    this->Pass = this->Scene.SetPasses().front();
    const Way& way = this->GetParam();
    vtkGITechnique* occlusion = this->Pass->GetTechnique("ambient-occlusion");
    occlusion->EnabledOn();
    occlusion->SetParameter("bent-normals", true);
    occlusion->SetParameter("radius", 20.0);
    occlusion->SetParameter("thickness", way.Thickness);
    occlusion->SetParameter("samples", 64);
    occlusion->SetParameterFromText("resolution", way.Resolution);
    this->Pass->GetTechnique("temporal-accumulation")->EnabledOn();
    // Something must know indirect light.
    vtkGITechnique* probes = this->Pass->GetTechnique("ddgi");
    probes->EnabledOn();
    probes->SetParameter("probes", 27);
    probes->SetParameter("rays", 16);
  }

  // The mean over the frames, as temporal accumulation keeps it.
  vtkVector3d At(vtkImageData* mean, const vtkVector3d& place)
  {
    vtkRenderer* renderer = this->Scene.Renderer;
    renderer->SetWorldPoint(place[0], place[1], place[2], 1.0);
    renderer->WorldToDisplay();
    const double* display = renderer->GetDisplayPoint();
    const int x = static_cast<int>(display[0]);
    const int y = static_cast<int>(display[1]);
    vtkVector3d direction(0.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      direction[axis] = 2.0 * mean->GetScalarComponentAsDouble(x, y, 0, axis + 1) - 1.0;
    }
    return direction;
  }

  Stage Scene;
  vtkSmartPointer<vtkGIPass> Pass;
};

// The mean direction of what is open over a floor, weighted by the cosine, where a wall fills the elevations up to an
// angle: over the lune of the rest, y away from the wall.
vtkVector2d OpenBefore(double elevation)
{
  const double rest = vtkMath::Pi() - elevation;
  return { 0.5 * std::pow(std::sin(elevation), 2), 0.5 * rest + 0.25 * std::sin(2.0 * elevation) };
}
}

TEST_P(BentNormals, PointPastAWall)
{
  this->Build();
  for (int frame = 0; frame < 48; ++frame)
  {
    this->Scene.Window->Render();
  }
  vtkNew<vtkImageData> mean;
  ASSERT_TRUE(this->Pass->GetBuffer(
    this->Scene.Renderer, "temporal-accumulation.visibility.ambient.odd", mean));
  for (double d : { 0.1, 0.25, 0.5, 1.0, 2.0 })
  {
    const vtkVector2d open = OpenBefore(std::atan(1.0 / d));
    const double expected = vtkMath::DegreesFromRadians(std::atan2(open[0], open[1]));
    const vtkVector3d found = this->At(mean, { 0.0, -d, 0.0 });
    const double away = vtkMath::DegreesFromRadians(std::atan2(-found[1], found[2]));
    const double aside = vtkMath::DegreesFromRadians(std::atan2(found[0], found[2]));
    std::printf(
      "%s: wall of height 1 at %g: leans away by %.1f degrees, expected %.1f, to the side %.1f\n",
      this->GetParam().Name, d, away, expected, aside);
    EXPECT_NEAR(away, expected, this->GetParam().Limit) << d;
    EXPECT_NEAR(aside, 0.0, this->GetParam().Limit) << d;
  }
}

INSTANTIATE_TEST_SUITE_P(AmbientOcclusion, BentNormals,
  ::testing::Values(Way{ "Full", "full", 1e30, 1.5 }, Way{ "Half", "half", 1e30, 2.5 },
    Way{ "Sectors", "full", 30.0, 1.5 }),
  [](const ::testing::TestParamInfo<Way>& info) { return std::string(info.param.Name); });

namespace
{
class BentNormalsInARoom : public RoomStage
{
protected:
  void SetUp() override
  {
    this->Prepare("ddgi", 96, 96);
    this->Pass->GetTechnique("ddgi")->SetParameter("probes", 216);
    this->Pass->GetTechnique("ddgi")->SetParameter("updates", 100);
    vtkGITechnique* occlusion = this->Pass->GetTechnique("ambient-occlusion");
    occlusion->EnabledOn();
    occlusion->SetParameter("radius", 0.3);
    occlusion->SetParameter("interreflection", 0.0);
  }

  // A room of which one side glows, and a low wall across its floor.
  void Build(double glowing, double others)
  {
    vtkActor* room = this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.5);
    room->GetProperty()->SetAmbient(others);
    vtkActor* side = this->AddBox(-0.99, -0.98, -0.99, 0.99, -0.99, 0.99, 0.5);
    side->GetProperty()->SetAmbient(glowing);
    vtkActor* wall = this->AddBox(-0.06, 0.06, -1.0, 1.0, -1.0, -0.85, 0.5);
    wall->GetProperty()->SetAmbient(others);
    this->LookFrom(0.0, -0.05, 0.9, 0.0, 0.0, -1.0);
  }

  // What bent normals multiply the light by close to the wall: on the side of negative x, and on the other.
  std::array<double, 2> Factors()
  {
    vtkGITechnique* occlusion = this->Pass->GetTechnique("ambient-occlusion");
    occlusion->SetParameter("bent-normals", false);
    const Values straight = this->After(101);
    occlusion->SetParameter("bent-normals", true);
    const Values bent = this->After(1);
    std::array<double, 2> factors{};
    for (int i = 0; i < 2; ++i)
    {
      double sums[2] = { 0.0, 0.0 };
      for (int y = 40; y < 56; ++y)
      {
        for (int x = 4; x < 7; ++x)
        {
          const std::size_t pixel = static_cast<std::size_t>(y) * 96 + (i == 0 ? 47 - x : 48 + x);
          sums[0] += straight[pixel];
          sums[1] += bent[pixel];
        }
      }
      factors[i] = sums[1] / sums[0];
    }
    return factors;
  }
};
}

TEST_F(BentNormalsInARoom, LeanToTheLightOrAwayFromIt)
{
  this->Build(1.0, 0.0);
  const auto factors = this->Factors();
  std::printf(
    "before a low wall, toward the light: %.3f, behind it: %.3f\n", factors[0], factors[1]);
  EXPECT_GT(factors[0], 1.05);
  EXPECT_LT(factors[1], 0.95);
}

TEST_F(BentNormalsInARoom, ChangeNothingWhereLightIsAlikeAllAround)
{
  this->Build(0.1, 0.1);
  const auto factors = this->Factors();
  std::printf("in even light: %.4f, %.4f\n", factors[0], factors[1]);
  EXPECT_NEAR(factors[0], 1.0, 0.02); // as near as probes come to even light
  EXPECT_NEAR(factors[1], 1.0, 0.02); // as near as probes come to even light
}
