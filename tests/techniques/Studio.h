// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A scene for tests of accumulation over frames, and errors of its frames.
 */
#pragma once

#include "SceneParts.h"
#include "Stage.h"

#include "vtkGITechnique.h"

#include "vtkImageData.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace penumbra_test
{
using Values = std::vector<double>;

/// Objects on a floor under a sun of eight degrees and ambient light.
struct Studio
{
  explicit Studio(bool accumulates, int samples = 1, int width = 160)
  {
    this->Scene.Window->SetSize(width, width * 2 / 3);
    AddFloor(this->Scene, -6.0, 6.0, -6.0, 6.0)->GetProperty()->SetColor(0.8, 0.8, 0.8);
    vtkNew<vtkCubeSource> cube;
    this->Box = this->Scene.Add(cube);
    this->Box->SetPosition(0.0, 0.0, 0.5);
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(48);
    sphere->SetPhiResolution(24);
    sphere->SetRadius(0.6);
    this->Ball = this->Scene.Add(sphere);
    this->Ball->SetPosition(1.6, 0.2, 0.6);
    vtkNew<vtkConeSource> cone;
    cone->SetDirection(0.0, 0.0, 1.0);
    cone->SetHeight(1.6);
    cone->SetResolution(32);
    this->Scene.Add(cone)->SetPosition(-1.5, 0.6, 0.8);
    vtkRenderer* renderer = this->Scene.Renderer;
    renderer->AutomaticLightCreationOff();
    this->Sun->SetLightTypeToSceneLight();
    this->Sun->SetPosition(4.0, -5.0, 6.0);
    this->Sun->SetIntensity(0.9);
    renderer->AddLight(this->Sun);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(0.0, -8.0, 4.0);
    camera->SetFocalPoint(0.0, 0.0, 0.4);
    camera->SetViewUp(0.0, 0.0, 1.0);
    renderer->ResetCameraClippingRange();
    vtkGIPass* pass = this->Pass = this->Scene.SetPasses().front();
    pass->SetPreset("off");
    pass->KeepRadianceOn();
    this->Shadows = pass->GetTechnique("ray-traced-shadows");
    this->Shadows->EnabledOn();
    this->Shadows->SetParameter("light-angle", 8.0);
    this->Shadows->SetParameter("samples", samples);
    this->Occlusion = pass->GetTechnique("ambient-occlusion");
    this->Occlusion->EnabledOn();
    this->Occlusion->SetParameter("samples", std::min(256, 8 * samples));
    pass->GetTechnique("temporal-accumulation")->SetEnabled(accumulates);
    pass->GetTechnique("anti-aliasing")->EnabledOff();
  }

  /// Display values of the pixels of the next frame.
  Values Frame()
  {
    this->Scene.Window->Render();
    return this->Last();
  }

  Values Last()
  {
    vtkNew<vtkImageData> radiance;
    this->Pass->GetRadiance(this->Scene.Renderer, radiance);
    const auto* pixels = static_cast<const float*>(radiance->GetScalarPointer());
    Values values;
    for (int i = 0; i < radiance->GetNumberOfPoints(); ++i)
    {
      const float* rgb = pixels + 4 * i;
      values.push_back(255.0 * (rgb[0] + rgb[1] + rgb[2]) / 3.0);
    }
    return values;
  }

  void AddSheet()
  {
    this->Sheet = GridAround(4.0, 80);
    this->Scene.Add(this->Sheet.Get())->GetProperty()->SetColor(0.9, 0.9, 0.9);
  }

  /// Move the sheet's travelling hills to a time, by new points or in place.
  void Wave(double time, bool inPlace)
  {
    vtkPoints* old = this->Sheet->GetPoints();
    vtkSmartPointer<vtkPoints> points = old;
    if (!inPlace)
    {
      points = vtkSmartPointer<vtkPoints>::New();
      points->DeepCopy(old);
    }
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      std::array<double, 3> p;
      points->GetPoint(i, p.data());
      p[2] = 0.5 + 0.4 * std::sin(2.0 * p[0] + 3.0 * time) * std::cos(1.5 * p[1] - 2.0 * time);
      points->SetPoint(i, p.data());
    }
    points->Modified();
    points->GetData()->Modified();
    this->Sheet->SetPoints(points);
    this->Sheet->Modified();
  }

  Values Frames(int count)
  {
    Values last;
    for (int i = 0; i < count; ++i)
    {
      last = this->Frame();
    }
    return last;
  }

  Stage Scene;
  vtkSmartPointer<vtkGIPass> Pass;
  vtkNew<vtkLight> Sun;
  vtkActor* Box = nullptr;
  vtkActor* Ball = nullptr;
  vtkSmartPointer<vtkPolyData> Sheet;
  vtkGITechnique* Shadows = nullptr;
  vtkGITechnique* Occlusion = nullptr;
};

/// Root of the mean squared difference.
inline double Error(const Values& a, const Values& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return std::sqrt(sum / a.size());
}
}
