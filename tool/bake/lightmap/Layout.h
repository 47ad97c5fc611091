// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A renderer's surfaces unwrapped: what a lightmap is baked for, and where in its picture.
#pragma once

#include "bake/lightmap/Bake.h"

namespace penumbra::lightmap
{
class GatherLight;

struct Layout
{
  Surfaces Scene;
  std::vector<Chart> Charts;
  Atlas Places;
  std::vector<Texel> Texels;
  std::vector<Patch> Patches; ///< the atlas' tiles, for the file
  std::size_t DarkSides = 0;  ///< of charts: no light reaches them, so that they have no tile
};

/// With tiles for the sides that light reaches of which the gatherer counts any. Throws a Failure.
Layout MakeLayout(vtkRenderer* renderer, const BakeSettings& settings, GatherLight& gather,
  tool::Reporter& reporter);
}
