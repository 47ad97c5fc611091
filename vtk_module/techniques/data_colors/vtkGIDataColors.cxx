// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIDataColors.h"

#include "technique/FrameBuilder.h"

vtkStandardNewMacro(vtkGIDataColors);

using namespace penumbra;

vtkGIDataColors::vtkGIDataColors() = default;
vtkGIDataColors::~vtkGIDataColors() = default;

void vtkGIDataColors::Plan(LightingPlan& plan, FrameBuilder&)
{
  plan.Rules().DataKeepsHue = this->KeepHue;
  plan.Rules().DataFloor = this->Floor;
}

// The capture, rays and direct light follow the plan's rules.
void vtkGIDataColors::Contribute(FrameBuilder&) {}
