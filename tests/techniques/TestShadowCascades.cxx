// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Cascades in pictures: shadows stand still while the camera moves and turns.
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkGIShadowMaps.h"

#include <vtkCubeSource.h>
#include <vtkMatrix4x4.h>
#include <vtkPlaneSource.h>

#include <cstdio>

using namespace penumbra_test;

namespace
{
constexpr int Width = 240;
constexpr int Height = 135;
constexpr double Depth = 1000.0; // of the scene, a hundred times its width

void AddPosts(Stage& stage)
{
  // Wider with distance, so that pixels tell their shadows from the floor.
  for (int i = 0; i < 16; ++i)
  {
    const double y = 6.0 * std::pow(1.3, i);
    const double width = 0.3 + 0.04 * y;
    const double x = i % 3 * 1.5 - 2.0;
    vtkNew<vtkCubeSource> post;
    post->SetBounds(x, x + width, y, y + width, 0.0, 1.5);
    stage.Add(post)->GetProperty()->SetColor(1.0, 1.0, 1.0);
  }
}

void AddCorridor(Stage& stage)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-5.0, 0.0, 0.0);
  plane->SetPoint1(5.0, 0.0, 0.0);
  plane->SetPoint2(-5.0, Depth, 0.0);
  stage.Add(plane)->GetProperty()->SetColor(1.0, 1.0, 1.0);
  AddPosts(stage);
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(-3.0, 1.0, 4.0);
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  stage.Renderer->AutomaticLightCreationOff();
  stage.Renderer->AddLight(sun);
}

// A picture, and where points of the floor are seen in it.
struct Sight
{
  Picture Shown;
  vtkNew<vtkMatrix4x4> WorldToClip;

  explicit Sight(Stage& stage)
    : Shown(Shoot(stage.Window))
  {
    this->WorldToClip->DeepCopy(
      stage.Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
        stage.Renderer->GetTiledAspectRatio(), 0.0, 1.0));
  }
  // The pixel that shows a point of the floor; false where something hides it.
  bool Find(double x, double y, int& column, int& row) const
  {
    const double point[4] = { x, y, 0.0, 1.0 };
    double clip[4];
    this->WorldToClip->MultiplyPoint(point, clip);
    if (clip[3] <= 0.0)
    {
      return false;
    }
    column = static_cast<int>(std::floor((clip[0] / clip[3] * 0.5 + 0.5) * Width));
    row = static_cast<int>(std::floor((clip[1] / clip[3] * 0.5 + 0.5) * Height));
    if (column < 3 || column >= Width - 3 || row < 3 || row >= Height - 3)
    {
      return false;
    }
    for (int i = 0; i < 49; ++i)
    {
      const int c = column + i % 7 - 3;
      const int r = row + i / 7 - 3;
      if (std::abs(this->Shown.Depth[r * Width + c] - clip[2] / clip[3]) > 1e-2)
      {
        return false;
      }
    }
    return true;
  }
  double Brightness(int column, int row) const { return this->Shown.Grey(column, row); }
  bool IsEven(int column, int row) const
  {
    for (int i = 0; i < 49; ++i)
    {
      if (std::abs(this->Brightness(column + i % 7 - 3, row + i / 7 - 3) -
            this->Brightness(column, row)) > 8.0)
      {
        return false;
      }
    }
    return true;
  }
};

void Place(Stage& stage, const double (&eye)[3], double turn)
{
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(30.0);
  camera->SetPosition(eye);
  camera->SetFocalPoint(eye[0] + std::sin(turn), eye[1] + std::cos(turn), eye[2] - 0.25);
  camera->SetClippingRange(1.0, 1200.0);
}

TEST(ShadowCascades, ShadowsStandStillUnderAMovingCamera)
{
  Stage stage;
  stage.Window->SetSize(Width, Height);
  AddCorridor(stage);
  auto pass = stage.SetPasses().front();
  auto* shadows = vtkGIShadowMaps::SafeDownCast(pass->GetTechnique("shadow-maps"));
  shadows->EnabledOn();
  const double eye[3] = { 0.0, 0.5, 6.0 };
  Place(stage, eye, 0.0);
  const Sight first(stage);
  EXPECT_GE(shadows->GetDrawnMaps(), 2);
  Save(first.Shown, "cascades");
  int changed[2] = { 0, 0 };
  int compared = 0;
  int atEdges = 0;
  int drawn = 0;
  int dark = 0;
  for (int frame = 1; frame <= 400; ++frame)
  {
    // Steps of a quarter of the nearest texels, then turns of a third of a pixel.
    const double way = 0.002 * std::min(frame, 200);
    const double at[3] = { eye[0] + 0.7 * way, eye[1] + 0.6 * way, eye[2] + 0.4 * way };
    Place(stage, at, 0.001 * std::max(0, frame - 200));
    const Sight now(stage);
    drawn += shadows->GetDrawnMaps();
    for (int i = 0; i < 4000; ++i)
    {
      const double x = -4.8 + 9.6 * (i % 40) / 39.0;
      const double y = 8.0 * std::pow(1.02, i / 40); // to 58
      int column = 0;
      int row = 0;
      int c = 0;
      int r = 0;
      if (!first.Find(x, y, column, row) || !now.Find(x, y, c, r))
      {
        continue;
      }
      const bool differs = std::abs(first.Brightness(column, row) - now.Brightness(c, r)) > 8.0;
      if (!first.IsEven(column, row))
      {
        atEdges += differs;
        continue;
      }
      ++compared;
      dark += first.Brightness(column, row) < 20.0;
      changed[frame > 200] += differs;
    }
  }
  std::printf("%d samples away from edges, %d of them in shadow; changed by translation %d, by "
              "rotation %d; at edges %d; %d maps drawn\n",
    compared, dark, changed[0], changed[1], atEdges, drawn);
  EXPECT_GT(compared, 50000);
  EXPECT_GT(dark, 1000);
  EXPECT_EQ(changed[0], 0);
  EXPECT_EQ(changed[1], 0);
  TakeMessages();
}
}
