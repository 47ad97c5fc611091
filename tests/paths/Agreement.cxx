// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Agreement.h"

#include "vtkGITechnique.h"

#include <cstdio>

namespace penumbra_test
{
namespace
{
// Whether colours change around a pixel by more than smooth shading does.
bool IsAtEdge(const Picture& p, int x, int y)
{
  for (int channel = 0; channel < 3; ++channel)
  {
    int low = 255;
    int high = 0;
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, p.Height - 1); ++j)
    {
      for (int i = std::max(x - 1, 0); i <= std::min(x + 1, p.Width - 1); ++i)
      {
        low = std::min(low, p.At(i, j)[channel]);
        high = std::max(high, p.At(i, j)[channel]);
      }
    }
    if (high - low > 16)
    {
      return true;
    }
  }
  return false;
}
}

void LightFromCamera(Stage& stage)
{
  vtkRenderer* renderer = stage.Renderer;
  vtkCamera* camera = renderer->GetActiveCamera();
  renderer->ResetCamera();
  camera->Azimuth(25.0);
  camera->Elevation(20.0);
  renderer->ResetCamera();
  // A view angle of about one degree shows the same from farther away.
  camera->Dolly(1.0 / 30.0);
  camera->SetViewAngle(0.9);
  renderer->ResetCameraClippingRange();
  renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(camera->GetPosition());
  light->SetFocalPoint(camera->GetFocalPoint());
  renderer->AddLight(light);
}

Agreement CompareWithRaster(Stage& stage)
{
  Agreement result;
  auto pass = stage.SetPasses().front();
  vtkGITechnique* paths = pass->GetTechnique("path-tracing");
  paths->EnabledOn();
  paths->SetParameter("bounces", 0);
  paths->SetParameter("samples", 16);
  const Picture first = Shoot(stage.Window);
  result.Notes = pass->GetNotes();
  for (int i = 1; i < 15; ++i)
  {
    stage.Window->Render();
  }
  result.Rays = Shoot(stage.Window);
  stage.Renderer->SetPass(nullptr);
  result.Raster = Shoot(stage.Window);

  const Difference centers = Compare(first, result.Raster, 3);
  result.AtCenters = centers.Within;
  result.Shown = Busyness(result.Raster);
  int away = 0;
  int within = 0;
  for (int y = 0; y < result.Raster.Height; ++y)
  {
    for (int x = 0; x < result.Raster.Width; ++x)
    {
      if (IsAtEdge(result.Raster, x, y))
      {
        continue;
      }
      ++away;
      const auto a = result.Raster.At(x, y);
      const auto b = result.Rays.At(x, y);
      within +=
        std::abs(a[0] - b[0]) <= 2 && std::abs(a[1] - b[1]) <= 2 && std::abs(a[2] - b[2]) <= 2 ? 1
                                                                                               : 0;
    }
  }
  result.AwayFromEdges = away > 0 ? within / static_cast<double>(away) : 0.0;
  result.Considered = away / static_cast<double>(result.Raster.Width * result.Raster.Height);
  return result;
}

void ExpectAgreement(Stage& stage, const std::string& name)
{
  const Agreement found = CompareWithRaster(stage);
  std::printf("%-36s centres %.4f  away from edges %.4f (of %.2f)  shown %.2f\n", name.c_str(),
    found.AtCenters, found.AwayFromEdges, found.Considered, found.Shown);
  EXPECT_GT(found.Shown, 0.05) << "the case shows nothing";
  EXPECT_GT(found.Considered, 0.5) << "hardly anything is away from edges";
  EXPECT_GE(found.AwayFromEdges, 0.99);
  EXPECT_GE(found.AtCenters, 0.999);
  EXPECT_EQ(found.Notes.find("rays do not see"), std::string::npos) << found.Notes;
  if (testing::Test::HasFailure())
  {
    Save(found.Raster, name + "-raster");
    Save(found.Rays, name + "-rays");
    Save(Amplified(found.Raster, found.Rays), name + "-difference");
  }
}
}
