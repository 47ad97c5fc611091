// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// What texels get straight from lamps: means over the texels, so that shadows end as softly as texels are wide and not
/// in steps.
#pragma once

#include "bake/lightmap/GatherLight.h"
#include "bake/lightmap/Layout.h"
#include "bake/lightmap/Progress.h"

namespace penumbra::lightmap
{
class LampLight
{
public:
  /// samples: of a round, for lamps that are picked by chance and for translucent shadows.
  LampLight(const Layout& layout, GatherLight& gather, int samples)
    : Places(layout)
    , Gather(gather)
    , Samples(samples)
  {
  }

  /// Adds a round's light of the texels from first to last. Each round has other points in the texels. The gatherer
  /// counts indirect light alone after this, as before.
  void AddRound(std::size_t first, std::size_t last, Gathered& sums,
    const std::function<void(double)>& advance);

  /// The means, and which texels have one, by their index in the picture.
  Light Mean(const Gathered& sums, std::vector<unsigned char>& known) const;

private:
  std::vector<unsigned char> FindBuried(const std::vector<Vec3>& points,
    const std::vector<Vec3>& normals, const std::vector<float>& light);

  const Layout& Places;
  GatherLight& Gather;
  int Samples;
  std::vector<Texel> Texels; ///< with the points of a round
  int Round = -1;
};
}
