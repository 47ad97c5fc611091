// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The vertical of a look that is fixed to the world.
 */
#pragma once

#include "looks/LookDescription.h"

#include <glm/glm.hpp>

class vtkRenderer;

namespace penumbra
{
/// The axis that a look names as up, or the coordinate axis nearest to the camera's view-up.
glm::dvec3 UpOf(const LookDescription& look, vtkRenderer* renderer);

/// The side from which things are seen by default: from +z where y is up, else from -y, as maps are from the south.
glm::dvec3 FrontOf(const glm::dvec3& up);
}
