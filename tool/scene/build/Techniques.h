// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Applies a scene's technique settings to the pass.
#pragma once

#include "scene/model/SceneModel.h"

class vtkGIPass;

namespace penumbra::tool
{
/// Preset first, then switches, then parameters. Throws a Failure that names what the pass does not
/// have, or the value it refuses.
void ApplyTechniques(const TechniqueSettings& settings, vtkGIPass* pass);
}
