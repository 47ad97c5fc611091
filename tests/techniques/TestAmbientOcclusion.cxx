// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Ambient occlusion: darkens what is enclosed, leaves open what is open, and touches ambient light
 * only.
 */
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkGITechnique.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
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
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-3.0, -3.0, 0.0);
    plane->SetPoint1(3.0, -3.0, 0.0);
    plane->SetPoint2(-3.0, 3.0, 0.0);
    this->Floor = this->Scene.Add(plane);
    this->Floor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.5);
    camera->SetPosition(0.0, 0.0, 10.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    this->Scene.Renderer->ResetCameraClippingRange();
  }
  void TearDown() override { EXPECT_TRUE(TakeMessages().empty()); }

  void AddWall(double height)
  {
    vtkNew<vtkCubeSource> wall;
    wall->SetBounds(-2.0, 0.0, -3.0, 3.0, 0.0, height);
    this->Scene.Add(wall);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  // Grey of the floor at a distance from the wall, averaged along it.
  static double FloorAt(const Picture& p, double x)
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

TEST_F(AmbientOcclusion, leaves_a_lone_plane_open)
{
  const Picture on = Shoot(this->Scene.Window);
  this->Occlusion->EnabledOff();
  const Picture off = Shoot(this->Scene.Window);
  // Facing the light a surface is as bright from all around as it was from the front.
  EXPECT_EQ(Compare(on, off, 1).Within, 1.0);
}

// At distance d an endless wall of height h hides (1 - d / sqrt(d^2 + h^2)) / 2 of the light. The
// samples crowd near the surface, so the value is larger close by and ends at the radius: the test
// holds the shape (darkest at the wall, rising, open beyond the radius), and prints the numbers.
TEST_F(AmbientOcclusion, darkens_toward_a_wall_and_ends_at_the_radius)
{
  this->AddWall(1.0);
  this->Occlusion->SetParameter("ambient-share", 1.0);
  this->Occlusion->SetParameter("radius", 1.0);
  this->Occlusion->SetParameter("samples", 64);
  const Picture picture = Shoot(this->Scene.Window);
  double before = -1.0;
  for (double d : { 0.05, 0.15, 0.3, 0.5, 0.8 })
  {
    const double openness = FloorAt(picture, d) / 255.0;
    std::printf("wall of height 1 at distance %.2f: openness %.3f, of an endless wall %.3f\n", d,
      openness, 1.0 - 0.5 * (1.0 - d / std::sqrt(d * d + 1.0)));
    EXPECT_GT(openness, before);
    before = openness;
  }
  EXPECT_LT(FloorAt(picture, 0.05), 0.75 * 255.0);
  EXPECT_GT(FloorAt(picture, 1.3), 0.99 * 255.0);
}

TEST_F(AmbientOcclusion, never_touches_direct_light_or_unlit_props)
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

TEST_F(AmbientOcclusion, occludes_the_materials_own_ambient_term)
{
  this->AddWall(1.0);
  this->Floor->GetProperty()->SetAmbient(0.5);
  this->Floor->GetProperty()->SetDiffuse(0.5);
  this->Occlusion->SetParameter("ambient-share", 0.0);
  const Picture on = Shoot(this->Scene.Window);
  this->Occlusion->EnabledOff();
  const Picture off = Shoot(this->Scene.Window);
  EXPECT_LT(FloorAt(on, 0.05), 0.9 * FloorAt(off, 0.05));
  EXPECT_GT(FloorAt(on, 0.05), 0.5 * FloorAt(off, 0.05)) << "the direct half stays";
}
