// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads the shape that vtkGILightShape stored in a light.
 */
#pragma once

class vtkLight;

namespace penumbra
{
struct Light;

/// Read a light's shape, and for a flat one its axes in world coordinates, given its direction there. A light whose
/// size is unusable is a point.
void ReadShape(vtkLight* light, Light& entry);
}
