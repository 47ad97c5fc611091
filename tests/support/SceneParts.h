// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Parts of scenes that several tests use.
 */
#pragma once

#include "Stage.h"

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPBRIrradianceTexture.h>
#include <vtkPBRLUTTexture.h>
#include <vtkPBRPrefilterTexture.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <array>

namespace penumbra_test
{
using Point = std::array<double, 3>;

/// Add a parallelogram with a corner at `origin` and the two corners next to it.
inline vtkActor* AddQuad(
  Stage& stage, const Point& origin, const Point& firstCorner, const Point& secondCorner)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(origin[0], origin[1], origin[2]);
  plane->SetPoint1(firstCorner[0], firstCorner[1], firstCorner[2]);
  plane->SetPoint2(secondCorner[0], secondCorner[1], secondCorner[2]);
  return stage.Add(plane);
}

/// Add a horizontal rectangle that faces up.
inline vtkActor* AddFloor(
  Stage& stage, double left, double right, double front, double back, double height = 0.0)
{
  return AddQuad(stage, { left, front, height }, { right, front, height }, { left, back, height });
}

/// A horizontal square around the origin that faces up, of many cells, for tests that move its points.
inline vtkSmartPointer<vtkPolyData> GridAround(double halfWidth, int cells, double height = 0.0)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-halfWidth, -halfWidth, height);
  plane->SetPoint1(halfWidth, -halfWidth, height);
  plane->SetPoint2(-halfWidth, halfWidth, height);
  plane->SetResolution(cells, cells);
  plane->Update();
  vtkSmartPointer<vtkPolyData> grid = plane->GetOutput();
  grid->GetPointData()->Initialize(); // without the flat plane's normals
  return grid;
}

/// Add a directional light of the scene at a position. It shines toward the origin.
inline vtkLight* AddLight(Stage& stage, double x, double y, double z)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  stage.Renderer->AddLight(light);
  return light;
}

/// Make a light positional, without a cone.
inline void ShineAllRound(vtkLight* light)
{
  light->PositionalOn();
  light->SetConeAngle(180.0);
}

/// Add a light too faint to count, in place of VTK's headlight: without any light VTK draws unlit colours.
inline void AddFaintLight(vtkRenderer* renderer)
{
  renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> faint;
  faint->SetIntensity(1e-9);
  renderer->AddLight(faint);
}

/// A texture for an environment, with the settings that VTK requires.
inline vtkSmartPointer<vtkTexture> EnvironmentTexture(vtkImageData* image)
{
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  texture->MipmapOn();
  return texture;
}

/// Light a scene by an environment, with z up.
inline void ShineFrom(vtkRenderer* renderer, vtkTexture* sky)
{
  auto* gl = static_cast<vtkOpenGLRenderer*>(renderer);
  gl->SetEnvironmentTexture(sky);
  gl->SetEnvironmentUp(0.0, 0.0, 1.0);
  gl->SetEnvironmentRight(1.0, 0.0, 0.0);
  gl->UseImageBasedLightingOn();
  // VTK's default tables are large and slow to compute on a CPU.
  gl->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(2);
  gl->GetEnvMapPrefiltered()->SetPrefilterLevels(2);
  gl->GetEnvMapIrradiance()->SetIrradianceSize(8);
  gl->GetEnvMapIrradiance()->SetIrradianceStep(0.3f);
  gl->GetEnvMapLookupTable()->SetLUTSize(8);
  gl->GetEnvMapLookupTable()->SetLUTSamples(8);
}
}
