// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A renderer's surfaces and their layout in the atlas.
#pragma once

#include "bake/lightmap/Bake.h"

namespace penumbra::lightmap
{
class GatherLight;

struct Layout
{
  Surfaces Scene;
  std::vector<Chart> Charts;
  Atlas Packing;
  std::vector<Texel> Texels;
  std::vector<Patch> Patches; ///< the tiles, for the file
  std::size_t DarkSides = 0;  ///< sides of charts without a tile, because no light reaches them
};

/// Makes tiles for the sides that light reaches, of the kinds that the gatherer includes. Throws a Failure.
Layout MakeLayout(vtkRenderer* renderer, const BakeSettings& settings, GatherLight& gather,
  tool::Reporter& reporter);
}
