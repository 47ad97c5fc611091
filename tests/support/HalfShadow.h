// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The penumbra of a straight edge.
 */
#pragma once

#include "Picture.h"
#include "SceneParts.h"

#include "vtkGITechnique.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace penumbra_test
{
constexpr double Pi = 3.14159265358979323846;

/// Share of a disc of radius 1 that lies to the right of a vertical line at -t.
inline double DiscShare(double t)
{
  t = std::clamp(t, -1.0, 1.0);
  return 0.5 + (t * std::sqrt(1.0 - t * t) + std::asin(t)) / Pi;
}

/// A floor with a blocker over its left half. The camera looks down from below the blocker; the picture is one world
/// unit wide. Frames at rest are averaged.
struct HalfShadow
{
  static constexpr int Side = 200;

  /// Both surfaces reach from -extent to extent.
  HalfShadow(const char* technique, double blockerHeight, double extent)
  {
    this->Scene.Window->SetSize(Side, Side);
    this->Scene.Renderer->AutomaticLightCreationOff();
    for (vtkActor* surface : { AddFloor(this->Scene, -extent, extent, -extent, extent),
           AddFloor(this->Scene, -extent, 0.0, -extent, extent, blockerHeight) })
    {
      surface->GetProperty()->SetColor(1.0, 1.0, 1.0);
    }
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5);
    camera->SetPosition(0.0, 0.0, 0.5 * blockerHeight);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetClippingRange(0.1 * blockerHeight, 2.0 * blockerHeight);
    vtkGIPass* pass = this->Scene.SetPasses().front();
    this->Shadows = pass->GetTechnique(technique);
    this->Shadows->EnabledOn();
    vtkGITechnique* average = pass->GetTechnique("anti-aliasing");
    average->EnabledOn();
    average->SetParameterFromText("mode", "accumulate");
  }

  /// Mean grey of each column, 0 to 1, after a number of frames at rest.
  std::vector<double> Profile(int frames)
  {
    for (int i = 1; i < frames; ++i)
    {
      this->Scene.Window->Render();
    }
    const Picture picture = Shoot(this->Scene.Window);
    std::vector<double> profile;
    for (int x = 0; x < Side; ++x)
    {
      profile.push_back(picture.MeanGrey(x, 0, x + 1, Side) / 255.0);
    }
    return profile;
  }

  Stage Scene;
  vtkGITechnique* Shadows = nullptr;
};
}
