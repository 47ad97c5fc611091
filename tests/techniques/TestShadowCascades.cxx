// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Cascades in pictures: shadows do not move while the camera moves and turns.
#include "Messages.h"
#include "Picture.h"
#include "SceneParts.h"
#include "Stage.h"

#include "vtkGIShadowMaps.h"

#include <vtkCubeSource.h>
#include <vtkMatrix4x4.h>

#include <cstdio>

using namespace penumbra_test;

namespace
{
constexpr int Width = 240;
constexpr int Height = 135;
constexpr double Depth = 1000.0; // of the scene, a hundred times its width

void AddPosts(Stage& stage)
{
  // Posts get wider with distance, so that their shadows stay visible.
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
  AddFloor(stage, -5.0, 5.0, 0.0, Depth)->GetProperty()->SetColor(1.0, 1.0, 1.0);
  AddPosts(stage);
  stage.Renderer->AutomaticLightCreationOff();
  AddLight(stage, -3.0, 1.0, 4.0);
}

// A picture with the projection that it was drawn with.
struct View
{
  Picture Image;
  vtkNew<vtkMatrix4x4> WorldToClip;

  explicit View(Stage& stage)
    : Image(Shoot(stage.Window))
  {
    this->WorldToClip->DeepCopy(
      stage.Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
        stage.Renderer->GetTiledAspectRatio(), 0.0, 1.0));
  }
  // Find the pixel that shows a point of the floor. Returns false where the point is hidden.
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
      if (std::abs(this->Image.Depth[r * Width + c] - clip[2] / clip[3]) > 1e-2)
      {
        return false;
      }
    }
    return true;
  }
  double Brightness(int column, int row) const { return this->Image.Grey(column, row); }
  // Whether brightness is uniform around a pixel.
  bool IsUniform(int column, int row) const
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

void PlaceCamera(Stage& stage, const double (&eye)[3], double turn)
{
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(30.0);
  camera->SetPosition(eye);
  camera->SetFocalPoint(eye[0] + std::sin(turn), eye[1] + std::cos(turn), eye[2] - 0.25);
  camera->SetClippingRange(1.0, 1200.0);
}

TEST(ShadowCascades, ShadowsDoNotMoveWithTheCamera)
{
  Stage stage;
  stage.Window->SetSize(Width, Height);
  AddCorridor(stage);
  auto pass = stage.SetPasses().front();
  auto* shadows = vtkGIShadowMaps::SafeDownCast(pass->GetTechnique("shadow-maps"));
  shadows->EnabledOn();
  const double eye[3] = { 0.0, 0.5, 6.0 };
  PlaceCamera(stage, eye, 0.0);
  const View first(stage);
  EXPECT_GE(shadows->GetDrawnMaps(), 2);
  Save(first.Image, "cascades");
  int changed[2] = { 0, 0 };
  int compared = 0;
  int atEdges = 0;
  int drawn = 0;
  int dark = 0;
  for (int frame = 1; frame <= 400; ++frame)
  {
    // Steps of a quarter of the nearest texels, then rotations by a third of a pixel.
    const double distance = 0.002 * std::min(frame, 200);
    const double at[3] = { eye[0] + 0.7 * distance, eye[1] + 0.6 * distance,
      eye[2] + 0.4 * distance };
    PlaceCamera(stage, at, 0.001 * std::max(0, frame - 200));
    const View current(stage);
    drawn += shadows->GetDrawnMaps();
    for (int i = 0; i < 4000; ++i)
    {
      const double x = -4.8 + 9.6 * (i % 40) / 39.0;
      const double y = 8.0 * std::pow(1.02, i / 40); // to 58
      int column = 0;
      int row = 0;
      int c = 0;
      int r = 0;
      if (!first.Find(x, y, column, row) || !current.Find(x, y, c, r))
      {
        continue;
      }
      const bool differs = std::abs(first.Brightness(column, row) - current.Brightness(c, r)) > 8.0;
      if (!first.IsUniform(column, row))
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
