// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameOverlay.h"

#include "vtkGIFrameChart.h"
#include "vtkGIPass.h"

#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkRenderer.h"

#include <cstring>

namespace penumbra
{
namespace
{
// Pixels. Large enough for the history and the knobs; smaller views show what fits.
constexpr int Margin = 10;
constexpr int Width = 640;
constexpr int Height = 240;
}

FrameOverlay::FrameOverlay()
{
  this->Chart->SetArea(Margin, Margin, Width, Height);
  this->Actor->GetScene()->AddItem(this->Chart);
  this->Actor->VisibilityOff(); // until there is something to show
}

FrameOverlay::~FrameOverlay()
{
  this->SetRenderer(nullptr);
}

void FrameOverlay::SetRenderer(vtkRenderer* renderer)
{
  if (renderer == this->Renderer)
  {
    return;
  }
  if (this->Renderer)
  {
    this->Renderer->RemoveViewProp(this->Actor);
    this->Actor->VisibilityOff();
  }
  this->Renderer = renderer;
  if (renderer)
  {
    renderer->AddViewProp(this->Actor);
  }
}

void FrameOverlay::Update(vtkGIPass* pass, bool visible)
{
  if (!this->Renderer)
  {
    return;
  }
  const char* statistics = visible ? pass->GetStatistics() : "{}";
  const bool any = std::strcmp(statistics, "{}") != 0;
  this->Actor->SetVisibility(any && this->Chart->SetStatistics(statistics));
}
}
