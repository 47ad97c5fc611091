// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Skyboxes behind everything. They are part of the background: VTK draws them before the passes run, which then
 * filter, trace and average over them. Linear pictures contain their radiance.
 */
#pragma once

#include <vector>

class vtkOpenGLRenderer;
class vtkProp;

namespace penumbra
{
class Frame;

/// Whether the prop is a skybox at infinity. A skybox that is projected to a floor is not.
bool IsSky(vtkProp* prop);

/// Draw skyboxes into the window, as VTK does. Returns the number of skyboxes drawn.
int DrawSkies(vtkOpenGLRenderer* renderer, const std::vector<vtkProp*>& skies);

/// Add the pass that writes resource::Sky.
void ContributeSky(Frame& frame, const std::vector<vtkProp*>& skies);
}
