// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Studio.h"

namespace validate
{
/// Build a room after Goral et al. 1984, "Modeling the Interaction of Light Between Diffuse Surfaces": from -1 to 1
/// with z up, open toward the camera, with a red left wall, a green right wall, a square light in the ceiling, and two
/// blocks.
void BuildCornellBox(Studio& studio, int pixels);
}
