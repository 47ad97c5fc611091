// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Defects of VTK's own shadow and ambient occlusion passes. Each test shows the defect with stock VTK, unless this
// version of VTK has fixed it, and then that Penumbra does not have it.
#pragma once

#include "Messages.h"
#include "Picture.h"
#include "SceneParts.h"
#include "Stage.h"

#include "vtkGITechnique.h"
#include "vtkActorCollection.h"
#include "vtkSphereSource.h"
#include "vtkVersion.h"

#include <cstdio>

namespace penumbra_test
{
enum class By
{
  None,  ///< plain VTK, nothing switched on
  Stock, ///< VTK's pass
  Ours
};

/// Whether this version of VTK still has a defect. Without arguments: all versions so far have it.
inline bool StockIsDefective(int fixedMajor = 99, int fixedMinor = 0)
{
  const int major = vtkVersion::GetVTKMajorVersion();
  const int minor = vtkVersion::GetVTKMinorVersion();
  return major < fixedMajor || (major == fixedMajor && minor < fixedMinor);
}

inline void SwitchOnShadows(Stage& stage, By by)
{
  if (by == By::Stock)
  {
    stage.Renderer->UseShadowsOn();
  }
  else if (by == By::Ours)
  {
    stage.SetPasses().front()->GetTechnique("shadow-maps")->EnabledOn();
  }
}

/// Switch on occlusion with the same radius for both. share: ambient share of ours.
inline void SwitchOnOcclusion(Stage& stage, By by, double radius, double share = 0.35)
{
  if (by == By::Stock)
  {
    stage.Renderer->UseSSAOOn();
    stage.Renderer->SetSSAORadius(radius);
    stage.Renderer->SetSSAOBias(0.01 * radius);
    stage.Renderer->SetSSAOKernelSize(64);
    stage.Renderer->SSAOBlurOn();
  }
  else if (by == By::Ours)
  {
    vtkGITechnique* technique = stage.SetPasses().front()->GetTechnique("ambient-occlusion");
    technique->EnabledOn();
    technique->SetParameter("radius", radius);
    technique->SetParameter("samples", 64);
    technique->SetParameter("ambient-share", share);
  }
}

/// Add a white floor in the plane z = 0.
inline vtkActor* AddFloor(Stage& stage, double half = 2.0)
{
  vtkActor* floor = AddFloor(stage, -half, half, -half, half);
  floor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  return floor;
}

/// Add a ball above the floor.
inline vtkSmartPointer<vtkSphereSource> AddBall(Stage& stage, double x = 0.0)
{
  auto ball = vtkSmartPointer<vtkSphereSource>::New();
  ball->SetThetaResolution(32);
  ball->SetPhiResolution(32);
  ball->SetCenter(x, 0.0, 1.0);
  stage.Add(ball);
  return ball;
}

/// Look at the floor from above, with x to the right. height: of the picture, in world units.
inline void LookDown(Stage& stage, double height)
{
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * height);
  camera->SetPosition(0.0, 0.0, 10.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  stage.Renderer->ResetCameraClippingRange();
}

/// Mean grey of the floor around a point, in a picture taken with LookDown().
inline double FloorGrey(const Picture& picture, double height, double x, double y)
{
  const double scale = picture.Height / height;
  const int i = static_cast<int>(0.5 * picture.Width + x * scale);
  const int j = static_cast<int>(0.5 * picture.Height + y * scale);
  return picture.MeanGrey(i - 2, j - 2, i + 3, j + 3);
}
}
