// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Terrain from a picture of heights.
#pragma once

#include "scene/build/Surfaces.h"

namespace penumbra::tool
{
/// Warps the picture by its values; the part keeps them as its active scalars.
Part MakeTerrain(
  const Loaded& loaded, const Object& object, const TriangleBudget& budget, Reporter& reporter);
}
