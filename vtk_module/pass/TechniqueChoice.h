// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Chooses the techniques that take part in a frame.
 */
#pragma once

#include "vtkGITechnique.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace penumbra
{
class FrameBuilder;
class LightingPlan;

/// Choose the techniques that take part in a frame, and let each tell the plan how it will light the frame. These are
/// the enabled ones, but only one per offered resource (see vtkGITechnique::GetOfferedResource()), and those that
/// stand in for others. The order of techniques affects only the order of the result. Notes name those that stand
/// back.
std::vector<vtkGITechnique*> ChooseTechniques(
  const std::vector<vtkSmartPointer<vtkGITechnique>>& techniques, FrameBuilder& frame,
  LightingPlan& plan);
}
