// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The lightmap that a bake writes over, of which what did not change is kept.
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
  /// The file at the settings' output, if there is one, made as the text says. Throws a Failure where it is damaged.
  EarlierBake(const BakeSettings& settings, const std::string& made);
  EarlierBake(const EarlierBake&) = delete;
  EarlierBake& operator=(const EarlierBake&) = delete;

  /// Of what is compared with.
  void AddTo(OIIO::SHA1& identity) const;

  /// Paths are the same for the same texel, sample and scene. Where the first round finds at every texel of a tile
  /// what it found for the earlier bake, no path there met what has changed since: kept is set to 1 for its texels.
  /// first: of the first round, so many channels of each texel.
  void FindSame(const Layout& layout, const std::vector<float>& first, std::size_t channels,
    std::vector<unsigned char>& kept);

  /// The light of kept texels. Returns how many tiles those are of.
  std::size_t Copy(const Layout& layout, const std::vector<unsigned char>& kept, Light& to,
    std::vector<unsigned char>& known) const;

private:
  const Patch* Find(const Patch& patch) const;
  std::size_t IndexIn(const Patch& patch, const Layout& layout, const Texel& texel) const;

  std::optional<Lightmap> Map;
  std::map<std::uint64_t, const Patch*> Known; ///< by key
};
}
