// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Ambient occlusion darkens enclosed places, leaves open ones as they are, and affects ambient light only.
 */
#include "Messages.h"
#include "Picture.h"
#include "SceneParts.h"
#include "Stage.h"

#include "vtkGITechnique.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <cstdio>

using namespace penumbra_test;

namespace
{
class AmbientOcclusion : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Scene.Window->SetSize(400, 300);
    this->Pass = this->Scene.SetPasses().front();
    this->Occlusion = this->Pass->GetTechnique("ambient-occlusion");
    ASSERT_NE(this->Occlusion, nullptr);
    this->Occlusion->EnabledOn();
    this->Floor = AddFloor(this->Scene, -3.0, 3.0, -3.0, 3.0);
    this->Floor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.5);
    camera->SetPosition(0.0, 0.0, 10.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  void AddWall(double height)
  {
    vtkNew<vtkCubeSource> wall;
    wall->SetBounds(-2.0, 0.0, -3.0, 3.0, 0.0, height);
    this->Scene.Add(wall);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  // Grey of the floor at a distance from the wall, averaged along it.
  static double FloorGrey(const Picture& p, double x)
  {
    const int column = static_cast<int>(p.Width / 2 + x * p.Height / 3.0);
    return p.MeanGrey(column, p.Height / 4, column + 1, 3 * p.Height / 4);
  }

  Stage Scene;
  vtkSmartPointer<vtkGIPass> Pass;
  vtkGITechnique* Occlusion = nullptr;
  vtkActor* Floor = nullptr;
};
}

TEST_F(AmbientOcclusion, LeavesALonePlaneOpen)
{
  const Picture on = Shoot(this->Scene.Window);
  this->Occlusion->EnabledOff();
  const Picture off = Shoot(this->Scene.Window);
  // A surface that faces the headlight is as bright under ambient light as under the headlight.
  EXPECT_EQ(Compare(on, off, 1).Within, 1.0);
}

// The shape alone: darkest at the wall, brighter with distance, open beyond the radius. TestOpenness.cxx checks values.
TEST_F(AmbientOcclusion, DarkensTowardAWallAndEndsAtTheRadius)
{
  this->AddWall(1.0);
  this->Occlusion->SetParameter("ambient-share", 1.0);
  this->Occlusion->SetParameter("interreflection", 0.0);
  this->Occlusion->SetParameter("radius", 1.0);
  this->Occlusion->SetParameter("samples", 64);
  const Picture picture = Shoot(this->Scene.Window);
  double before = -1.0;
  for (double d : { 0.05, 0.15, 0.3, 0.5, 0.8 })
  {
    const double openness = FloorGrey(picture, d) / 255.0;
    std::printf("wall of height 1 at distance %.2f: openness %.3f, of an endless wall %.3f\n", d,
      openness, 1.0 - 0.5 * (1.0 - d / std::sqrt(d * d + 1.0)));
    EXPECT_GT(openness, before);
    before = openness;
  }
  EXPECT_LT(FloorGrey(picture, 0.05), 0.75 * 255.0);
  EXPECT_GT(FloorGrey(picture, 1.3), 0.99 * 255.0);
}

// Around the floor there is only background where an earlier, closer view showed the floor and the wall.
TEST_F(AmbientOcclusion, DoesNotDependOnEarlierViews)
{
  this->AddWall(1.0);
  this->Occlusion->SetParameter("ambient-share", 1.0);
  this->Occlusion->SetParameter("radius", 1.0);
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  const auto shoot = [&](double scale) {
    camera->SetParallelScale(scale);
    return Shoot(this->Scene.Window);
  };
  for (const char* method : { "horizon", "hemisphere" })
  {
    this->Occlusion->SetParameterFromText("method", method);
    const Picture first = shoot(6.0);
    shoot(1.5);
    const Picture again = shoot(6.0);
    EXPECT_GT(Busyness(first), 0.01);
    EXPECT_EQ(Compare(first, again, 0).Within, 1.0) << method;
  }
}

TEST_F(AmbientOcclusion, LeavesDirectLightAndUnlitPropsAlone)
{
  this->AddWall(1.0);
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(0.2, 0.6, -0.5, 0.5, 0.0, 0.2);
  vtkActor* unlit = this->Scene.Add(cube);
  unlit->GetProperty()->LightingOff();
  this->Occlusion->SetParameter("ambient-share", 0.0);
  const Picture on = Shoot(this->Scene.Window);
  this->Occlusion->EnabledOff();
  const Picture off = Shoot(this->Scene.Window);
  EXPECT_EQ(Compare(on, off, 0).Within, 1.0) << "no ambient light: nothing to occlude";
}

TEST_F(AmbientOcclusion, IsNotComputedWithoutAmbientLight)
{
  this->AddWall(1.0);
  this->Pass->CollectStatisticsOn();
  const auto computed = [this] {
    Shoot(this->Scene.Window);
    return std::string(this->Pass->GetStatistics()).find("ambient-occlusion") != std::string::npos;
  };
  EXPECT_TRUE(computed());
  this->Occlusion->SetParameter("ambient-share", 0.0);
  EXPECT_FALSE(computed());
  this->Floor->GetProperty()->SetAmbient(0.1);
  EXPECT_TRUE(computed());
}

TEST_F(AmbientOcclusion, OccludesTheMaterialsAmbientTerm)
{
  this->AddWall(1.0);
  this->Floor->GetProperty()->SetAmbient(0.5);
  this->Floor->GetProperty()->SetDiffuse(0.5);
  this->Occlusion->SetParameter("ambient-share", 0.0);
  const Picture on = Shoot(this->Scene.Window);
  this->Occlusion->EnabledOff();
  const Picture off = Shoot(this->Scene.Window);
  EXPECT_LT(FloorGrey(on, 0.05), 0.9 * FloorGrey(off, 0.05));
  EXPECT_GT(FloorGrey(on, 0.05), 0.5 * FloorGrey(off, 0.05)) << "the direct half stays";
}

// Ambient light only: a wall, and a pane of opacity one half over the floor beside it.
TEST_F(AmbientOcclusion, IgnoresTranslucentSurfaces)
{
  this->AddWall(1.0);
  this->Occlusion->SetParameter("ambient-share", 1.0);
  this->Occlusion->SetParameter("radius", 1.0);
  vtkActor* pane = AddFloor(this->Scene, 0.05, 0.8, -0.7, 0.7, 0.1);
  pane->GetProperty()->SetColor(0.1, 0.3, 0.9);
  pane->GetProperty()->LightingOff();
  const double opacity = 0.5;
  pane->GetProperty()->SetOpacity(opacity);
  const auto shoot = [&](bool shown, bool occluded) {
    pane->SetVisibility(shown);
    this->Occlusion->SetEnabled(occluded);
    return Shoot(this->Scene.Window);
  };
  const Picture open = shoot(false, false);
  const Picture glass = shoot(true, false);
  const Picture occluded = shoot(false, true);
  const Picture both = shoot(true, true);
  // VTK blends the pane over the floor. The pane neither occludes nor is occluded.
  int darkened = 0;
  int off = 0;
  for (std::size_t i = 0; i < both.Pixels.size(); ++i)
  {
    const std::size_t red = i - i % 4;
    const bool covered = open.Pixels[red] - glass.Pixels[red] > 50;
    const double expected = occluded.Pixels[i] +
      (covered ? glass.Pixels[i] - open.Pixels[i] + opacity * (open.Pixels[i] - occluded.Pixels[i])
               : 0.0);
    darkened += covered && occluded.Pixels[i] < open.Pixels[i] - 8;
    off += std::abs(both.Pixels[i] - expected) > 2.0;
  }
  std::printf(
    "pane over a floor: %d values of the floor under it are occluded, %d of %zu are off by "
    "more than 2/255\n",
    darkened, off, both.Pixels.size());
  EXPECT_GT(darkened, 1000);
  EXPECT_EQ(off, 0);
}

// Data without extent gives no default radius.
TEST_F(AmbientOcclusion, LeavesDataWithoutExtentAlone)
{
  this->Scene.Renderer->RemoveAllViewProps();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.0, 1.0, 0.0);
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 0, 0 });
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(triangles);
  this->Scene.Add(data);
  for (const char* method : { "horizon", "hemisphere" })
  {
    this->Occlusion->SetParameterFromText("method", method);
    this->Occlusion->EnabledOn();
    const Picture on = Shoot(this->Scene.Window);
    this->Occlusion->EnabledOff();
    EXPECT_EQ(Compare(on, Shoot(this->Scene.Window), 0).Within, 1.0) << method;
  }
}
