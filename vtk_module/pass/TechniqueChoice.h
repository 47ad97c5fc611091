// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which techniques take part in a frame.
 */
#pragma once

#include "vtkGITechnique.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace penumbra
{
class FrameBuilder;
class LightingPlan;

/// The techniques that take part in a frame, once each has told the plan how it will light it: those that are enabled,
/// but one for each offered resource (see vtkGITechnique::GetOfferedResource()), and those that stand in for others.
/// The result does not depend on the order of the techniques, but for its own order. Notes name those that stand back.
std::vector<vtkGITechnique*> ChooseTechniques(
  const std::vector<vtkSmartPointer<vtkGITechnique>>& techniques, FrameBuilder& frame,
  LightingPlan& plan);
}
