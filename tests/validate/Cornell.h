// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Studio.h"

namespace validate
{
/// A room after Goral et al. 1984, "Modeling the Interaction of Light Between Diffuse Surfaces":
/// from -1 to 1 with z up, open to the eye, its left wall red, its right one green, a square light
/// under the ceiling and two blocks.
void BuildCornellBox(Studio& studio, int pixels);
}
