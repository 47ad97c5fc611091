// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIReflectance.h"

#include "technique/FrameBuilder.h"

vtkStandardNewMacro(vtkGIReflectance);

using namespace penumbra;

vtkGIReflectance::vtkGIReflectance() = default;
vtkGIReflectance::~vtkGIReflectance() = default;

void vtkGIReflectance::Plan(LightingPlan& plan, FrameBuilder&)
{
  plan.Rules().Reflectance = this->MaximumAlbedo;
  plan.Rules().Compensates = this->EnergyCompensation;
}

// The capture, rays and direct light follow the plan's rules.
void vtkGIReflectance::Contribute(FrameBuilder&) {}
