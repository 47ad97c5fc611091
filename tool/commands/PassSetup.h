// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Sets up the pass for a scene.
#pragma once

#include "common/Reporter.h"
#include "scene/model/SceneModel.h"

class vtkGIPass;
class vtkRenderer;

namespace penumbra::tool
{
/// Applies the preset, then switches, then parameters, then loads baked light. Throws a Failure that names what the pass
/// does not have, the value it refuses, or the file that is damaged or of another kind.
void SetUpPass(const Scene& scene, vtkGIPass* pass, Reporter& reporter);

/// Gives the scene's look to a renderer. pass: set up by SetUpPass(), or nullptr for VTK alone. What the scene itself says
/// of background and techniques comes after the look.
void ApplyLook(const Scene& scene, vtkRenderer* renderer, vtkGIPass* pass, Reporter& reporter);

/// Reflection of surfaces by the scene's technique settings, as in vtkGIReflectance.
struct Reflection
{
  double MaximumAlbedo = 1;
  bool EnergyCompensation = false;
};
Reflection ReflectionIn(const Scene& scene);
}
