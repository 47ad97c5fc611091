// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where light comes from past what is near, as ambient occlusion hands it to probes: before a wall the mean direction is
 * known in closed form, and in a furnace asking for it changes nothing.
 */
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkGITechnique.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkRenderer.h>
#include <vtkVector.h>
#include <vtkVectorOperators.h>

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
  void TearDown() override { EXPECT_TRUE(TakeMessages().empty()); }

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
