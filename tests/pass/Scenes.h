// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene with props of several kinds, for tests of the pass in a program.
#pragma once

#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkGITechnique.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

namespace penumbra_test
{
/// Two opaque actors, a translucent one and text.
struct Scene : public Stage
{
  explicit Scene(bool text = true)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(24);
    sphere->SetPhiResolution(24);
    this->Ball = this->Add(sphere);
    this->Ball->GetProperty()->SetSpecular(0.4);
    vtkNew<vtkCubeSource> cube;
    this->Box = this->Add(cube);
    this->Box->SetPosition(1.2, 0.0, 0.0);
    this->Box->GetProperty()->SetColor(0.3, 0.8, 0.4);
    vtkNew<vtkConeSource> cone;
    cone->SetResolution(20);
    this->Glass = this->Add(cone);
    this->Glass->SetPosition(0.5, 0.7, 0.6);
    this->Glass->GetProperty()->SetOpacity(0.5);
    if (text)
    {
      vtkNew<vtkTextActor> label;
      label->SetInput("label");
      label->GetTextProperty()->SetFontSize(24);
      this->Renderer->AddViewProp(label);
    }
    this->Renderer->CreateLight();
    LookAround(this->Renderer);
  }

  /// A pass on the first renderer.
  vtkGIPass* SetPass()
  {
    vtkNew<vtkGIPass> pass;
    this->Renderer->SetPass(pass);
    return pass;
  }

  vtkActor* Ball = nullptr;
  vtkActor* Box = nullptr;
  vtkActor* Glass = nullptr;
};

/// Set a preset with so many samples that frames of different noise look the same, for tests that look for stale parts
/// of a picture.
inline void SetQuietPreset(vtkGIPass* pass, const char* preset)
{
  pass->SetPreset(preset);
  pass->GetTechnique("ambient-occlusion")->SetParameter("samples", 128);
}

/// Expect a picture that is not empty and another one that equals it up to rounding.
inline void ExpectSame(const Picture& a, const Picture& b, double share = 0.999)
{
  EXPECT_GT(Busyness(a), 0.01);
  EXPECT_GE(Compare(a, b, 2).Within, share);
}
}
