// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Skyboxes that stand behind everything. They are part of the background: drawn by VTK before the passes run, which then
 * filter, trace and average over them. Linear pictures have their radiance.
 */
#pragma once

#include <vector>

class vtkOpenGLRenderer;
class vtkProp;

namespace penumbra
{
class Frame;

/// Whether the prop is a skybox without a place in the scene. One that is projected to a floor has a place.
bool IsSky(vtkProp* prop);

/// Draw them into the window, as VTK does. Returns how many were drawn.
int DrawSkies(vtkOpenGLRenderer* renderer, const std::vector<vtkProp*>& skies);

/// Add the pass that writes resource::Sky, for those who read it.
void ContributeSky(Frame& frame, const std::vector<vtkProp*>& skies);
}
