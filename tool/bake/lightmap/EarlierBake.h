// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The lightmap that a bake overwrites. Unchanged tiles keep their light.
#pragma once

#include "bake/lightmap/Layout.h"

#include <OpenImageIO/hash.h>

#include <cstdint>
#include <optional>

namespace penumbra::lightmap
{
class EarlierBake
{
public:
  /// Reads the output file if it exists and was made with the same settings. Throws a Failure if it is damaged.
  EarlierBake(const BakeSettings& settings, const std::string& description);
  EarlierBake(const EarlierBake&) = delete;
  EarlierBake& operator=(const EarlierBake&) = delete;

  /// Adds the compared data to a checksum.
  void AddTo(OIIO::SHA1& identity) const;

  /// Finds unchanged tiles, and sets kept to 1 for their texels. Paths are the same for the same texel, sample and scene, so
  /// if the first round has the same result at all texels of a tile, none of its paths hit anything that changed.
  /// first: light of the first round, with a number of channels per texel.
  void FindSame(const Layout& layout, const std::vector<float>& first, std::size_t channels,
    std::vector<unsigned char>& kept);

  /// Copies the light of kept texels. Returns the number of their tiles.
  std::size_t Copy(const Layout& layout, const std::vector<unsigned char>& kept, Light& to,
    std::vector<unsigned char>& known) const;

private:
  const Patch* Find(const Patch& patch) const;
  std::size_t IndexIn(const Patch& patch, const Layout& layout, const Texel& texel) const;

  std::optional<Lightmap> Map;
  std::map<std::uint64_t, const Patch*> Patches; ///< by key
};
}
