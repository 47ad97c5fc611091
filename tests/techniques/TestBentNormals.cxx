// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Bent normals, which ambient occlusion passes to probes. Before a wall the mean unoccluded direction is known in
 * closed form. In a room lit from one side they tell the two sides of a low wall apart; in uniform light they change
 * nothing.
 */
#include "RoomStage.h"

#include "vtkGITechnique.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

using namespace penumbra_test;

namespace
{
struct Variant
{
  const char* Name;
  const char* Resolution;
  double Thickness;
  double Limit; ///< degrees
};

std::ostream& operator<<(std::ostream& stream, const Variant& variant)
{
  return stream << variant.Name;
}

class BentNormals : public ::testing::TestWithParam<Variant>
{
protected:
  // A wall of height 1 at y = 0 on a floor, seen from -y.
  void Build()
  {
    this->Scene.Window->SetSize(320, 240);
    AddFloor(this->Scene, -30.0, 30.0, -30.0, 30.0);
    AddQuad(this->Scene, { -30.0, 0.0, 0.0 }, { 30.0, 0.0, 0.0 }, { -30.0, 0.0, 1.0 });
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(3.0);
    camera->SetPosition(0.0, -9.0, 6.0);
    camera->SetFocalPoint(0.0, 0.0, 0.3);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Scene.Renderer->ResetCameraClippingRange();
    this->Pass = this->Scene.SetPasses().front();
    const Variant& variant = this->GetParam();
    vtkGITechnique* occlusion = this->Pass->GetTechnique("ambient-occlusion");
    occlusion->EnabledOn();
    occlusion->SetParameter("bent-normals", true);
    occlusion->SetParameter("radius", 20.0);
    occlusion->SetParameter("thickness", variant.Thickness);
    occlusion->SetParameter("samples", 64);
    occlusion->SetParameterFromText("resolution", variant.Resolution);
    this->Pass->GetTechnique("temporal-accumulation")->EnabledOn();
    // Bent normals need a source of indirect light.
    vtkGITechnique* probes = this->Pass->GetTechnique("ddgi");
    probes->EnabledOn();
    probes->SetParameter("probes", 27);
    probes->SetParameter("rays", 16);
  }

  // Bent normal at a point, from the buffer of temporal accumulation.
  Point BentNormalAt(vtkImageData* mean, const Point& point)
  {
    vtkRenderer* renderer = this->Scene.Renderer;
    renderer->SetWorldPoint(point[0], point[1], point[2], 1.0);
    renderer->WorldToDisplay();
    const double* display = renderer->GetDisplayPoint();
    const int x = static_cast<int>(display[0]);
    const int y = static_cast<int>(display[1]);
    Point direction{};
    for (int axis = 0; axis < 3; ++axis)
    {
      direction[axis] = 2.0 * mean->GetScalarComponentAsDouble(x, y, 0, axis + 1) - 1.0;
    }
    return direction;
  }

  Stage Scene;
  vtkSmartPointer<vtkGIPass> Pass;
};

// Cosine-weighted mean of the unoccluded directions over a floor, where a wall covers the elevations up to an angle. x
// points away from the wall, y up.
std::array<double, 2> BentNormalBeforeAWall(double elevation)
{
  const double rest = vtkMath::Pi() - elevation;
  return { 0.5 * std::pow(std::sin(elevation), 2), 0.5 * rest + 0.25 * std::sin(2.0 * elevation) };
}
}

TEST_P(BentNormals, MatchTheClosedFormBeforeAWall)
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
    const std::array<double, 2> open = BentNormalBeforeAWall(std::atan(1.0 / d));
    const double expected = vtkMath::DegreesFromRadians(std::atan2(open[0], open[1]));
    const Point found = this->BentNormalAt(mean, { 0.0, -d, 0.0 });
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
  ::testing::Values(Variant{ "Full", "full", 1e30, 1.5 }, Variant{ "Half", "half", 1e30, 2.5 },
    Variant{ "Sectors", "full", 30.0, 1.5 }),
  [](const ::testing::TestParamInfo<Variant>& info) { return std::string(info.param.Name); });

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

  // A room with one glowing side and a low wall across its floor.
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

  // Ratio of the light with bent normals to the light without, close to the wall: on its side of negative x and on the
  // other.
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

TEST_F(BentNormalsInARoom, BrightenTheSideThatFacesTheLight)
{
  this->Build(1.0, 0.0);
  const auto factors = this->Factors();
  std::printf(
    "before a low wall, toward the light: %.3f, behind it: %.3f\n", factors[0], factors[1]);
  EXPECT_GT(factors[0], 1.05);
  EXPECT_LT(factors[1], 0.95);
}

TEST_F(BentNormalsInARoom, ChangeNothingInUniformLight)
{
  this->Build(0.1, 0.1);
  const auto factors = this->Factors();
  std::printf("in uniform light: %.4f, %.4f\n", factors[0], factors[1]);
  EXPECT_NEAR(factors[0], 1.0, 0.02); // as close as probes come to uniform light
  EXPECT_NEAR(factors[1], 1.0, 0.02); // as close as probes come to uniform light
}
