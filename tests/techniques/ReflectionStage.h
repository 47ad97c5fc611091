// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// A reflecting floor with objects on and above it, and how the technique's rays end.
#pragma once

#include "Messages.h"
#include "Picture.h"
#include "SceneParts.h"
#include "Stage.h"

#include "vtkGITechnique.h"

#include "reflection.h"

#include <glm/glm.hpp>

#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPBRIrradianceTexture.h>
#include <vtkPBRLUTTexture.h>
#include <vtkPBRPrefilterTexture.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

namespace penumbra_test
{
class ReflectionStage : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Scene.Window->SetSize(401, 303); // odd, so that the pyramid's levels are rounded up
    this->Scene.Renderer->SetBackground(0.0, 0.0, 0.0);
    this->Pass = this->Scene.SetPasses().front();
    this->Reflections = this->Pass->GetTechnique("screen-space-reflections");
    ASSERT_NE(this->Reflections, nullptr);
    this->Reflections->EnabledOn();
    this->Floor = AddFloor(this->Scene, -4.0, 4.0, -4.0, 4.0);
    this->UseMetalFloor(0.0);
  }

  void UseMetalFloor(double roughness)
  {
    this->Floor->GetProperty()->SetInterpolationToPBR();
    this->Floor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    this->Floor->GetProperty()->SetMetallic(1.0);
    this->Floor->GetProperty()->SetRoughness(roughness);
  }

  // Add flat and round, thick and thin, standing and floating objects.
  void AddObjects()
  {
    vtkNew<vtkCubeSource> box;
    box->SetBounds(-1.8, -0.8, -0.5, 0.5, 0.0, 1.1);
    this->Scene.Add(box);
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(0.1, -0.6, 0.6);
    ball->SetRadius(0.5);
    ball->SetThetaResolution(96);
    ball->SetPhiResolution(96);
    this->Scene.Add(ball);
    vtkNew<vtkParametricTorus> ring;
    ring->SetRingRadius(0.5);
    ring->SetCrossSectionRadius(0.12);
    vtkNew<vtkParametricFunctionSource> round;
    round->SetParametricFunction(ring);
    round->SetUResolution(96);
    round->SetVResolution(48);
    vtkActor* torus = this->Scene.Add(round);
    torus->RotateX(70.0);
    torus->SetPosition(1.4, 0.2, 0.8);
    vtkNew<vtkCylinderSource> pole;
    pole->SetRadius(0.03);
    pole->SetHeight(1.6);
    pole->SetResolution(24);
    for (double x : { -0.5, 0.8, 2.2 })
    {
      vtkActor* actor = this->Scene.Add(pole);
      actor->RotateX(90.0);
      actor->SetPosition(x, 1.0, 0.8);
    }
    vtkNew<vtkCubeSource> wall;
    wall->SetBounds(-3.0, 3.0, 2.4, 2.6, 0.0, 2.2);
    this->Scene.Add(wall);
  }

  // Place the camera, or its mirror image below the floor.
  void LookFrom(double x, double y, double z, bool parallel, bool mirrored)
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    const double side = mirrored ? -1.0 : 1.0;
    camera->SetPosition(x, y, side * z);
    camera->SetFocalPoint(0.0, 0.0, side * 0.5);
    camera->SetViewUp(0.0, 0.0, side);
    camera->SetViewAngle(35.0);
    camera->SetParallelProjection(parallel);
    camera->SetParallelScale(1.9);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  // Linear colours of all pixels, four floats each, after a number of frames at rest.
  std::vector<float> Radiance(int frames)
  {
    this->Pass->KeepRadianceOn();
    this->Scene.Renderer->Modified();
    for (int i = 0; i < frames; ++i)
    {
      this->Scene.Window->Render();
    }
    vtkNew<vtkImageData> image;
    EXPECT_TRUE(this->Pass->GetRadiance(this->Scene.Renderer, image));
    const auto* values = static_cast<const float*>(image->GetScalarPointer());
    return { values, values + 4 * image->GetNumberOfPoints() };
  }

  // Whether any of the technique's passes ran in the last frame.
  bool Ran()
  {
    return std::string(this->Pass->GetStatistics()).find("reflection-") != std::string::npos;
  }

  void AddEnvironment()
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(8, 4, 1);
    image->AllocateScalars(VTK_FLOAT, 3);
    auto* values = static_cast<float*>(image->GetScalarPointer());
    for (int i = 0; i < 96; ++i)
    {
      values[i] = 0.1f + 0.05f * static_cast<float>(i % 7);
    }
    auto* renderer = vtkOpenGLRenderer::SafeDownCast(this->Scene.Renderer);
    renderer->SetEnvironmentTexture(EnvironmentTexture(image));
    renderer->UseImageBasedLightingOn();
    renderer->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(2);
    renderer->GetEnvMapPrefiltered()->SetPrefilterLevels(2);
    renderer->GetEnvMapIrradiance()->SetIrradianceSize(8);
    renderer->GetEnvMapIrradiance()->SetIrradianceStep(0.3f);
    renderer->GetEnvMapLookupTable()->SetLUTSize(8);
  }

  // End of each pixel's ray: x and y of the pixel that it hit, reason, confidence.
  std::vector<glm::vec4> Ends()
  {
    vtkNew<vtkImageData> image;
    EXPECT_TRUE(
      this->Pass->GetBuffer(this->Scene.Renderer, "screen-space-reflections.ends", image));
    const auto* values = static_cast<const glm::vec4*>(image->GetScalarPointer());
    return { values, values + image->GetNumberOfPoints() };
  }

  Stage Scene;
  vtkSmartPointer<vtkGIPass> Pass;
  vtkGITechnique* Reflections = nullptr;
  vtkActor* Floor = nullptr;
};
}
