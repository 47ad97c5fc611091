// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Direct light of texels. It is averaged over the area of each texel, so that shadow edges are smooth.
#pragma once

#include "bake/lightmap/GatherLight.h"
#include "bake/lightmap/Layout.h"
#include "bake/lightmap/Progress.h"

namespace penumbra::lightmap
{
class DirectLight
{
public:
  /// samples: number per round, for lights chosen at random and for translucent shadows.
  DirectLight(const Layout& layout, GatherLight& gather, int samples)
    : Unwrapped(layout)
    , Gather(gather)
    , Samples(samples)
  {
  }

  /// Adds a round of light to the texels from first to last, excluding last. Each round has different points in the texels.
  /// Afterwards the gatherer includes only indirect light, as before.
  void AddRound(std::size_t first, std::size_t last, Gathered& sums,
    const std::function<void(double)>& advance);

  /// Means over rounds. known: set for texels that have one, by index in the atlas.
  Light Mean(const Gathered& sums, std::vector<unsigned char>& known) const;

private:
  std::vector<unsigned char> FindBuried(const std::vector<Vec3>& points,
    const std::vector<Vec3>& normals, const std::vector<float>& light);

  const Layout& Unwrapped;
  GatherLight& Gather;
  int Samples;
  std::vector<Texel> Texels; ///< with the points of the current round
  int Round = -1;
};
}
