// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/EarlierBake.h"

#include "common/Failure.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace penumbra::lightmap
{
EarlierBake::EarlierBake(const BakeSettings& settings, const std::string& description)
{
  std::error_code error;
  if (settings.FromScratch || !std::filesystem::exists(settings.Output, error))
  {
    return;
  }
  try
  {
    this->Map = ReadLightmap(settings.Output);
  }
  catch (const tool::Failure& failure)
  {
    tool::Fail("{}; --from-scratch overwrites it", failure.what());
  }
  if (this->Map->Settings != description)
  {
    this->Map.reset();
    return;
  }
  for (const Patch& patch : this->Map->Patches)
  {
    this->Patches[patch.Key] = &patch;
  }
}

void EarlierBake::AddTo(OIIO::SHA1& identity) const
{
  if (this->Map)
  {
    const std::vector<float>& first = this->Map->First.Values;
    identity.append(this->Map->Scene.data(), this->Map->Scene.size());
    identity.append(first.data(), first.size() * sizeof(float));
  }
}

const Patch* EarlierBake::Find(const Patch& patch) const
{
  const auto found = this->Patches.find(patch.Key);
  const bool same = found != this->Patches.end() && found->second->Texels == patch.Texels;
  return same ? found->second : nullptr;
}

/// A texel's index in the earlier atlas.
std::size_t EarlierBake::IndexIn(const Patch& patch, const Layout& layout, const Texel& texel) const
{
  const auto index = static_cast<int>(texel.Index);
  const int width = layout.Packing.Width;
  const glm::ivec2 within =
    glm::ivec2(index % width, index / width) - layout.Packing.Tiles[texel.Tile].At;
  const glm::ivec2 there = patch.At + within;
  return std::size_t(there.y) * this->Map->Baked.Width + there.x;
}

void EarlierBake::FindSame(const Layout& layout, const std::vector<float>& first,
  std::size_t channels, std::vector<unsigned char>& kept)
{
  if (!this->Map)
  {
    return;
  }
  std::vector<const Patch*> same;
  for (const Patch& patch : layout.Patches)
  {
    same.push_back(this->Find(patch));
  }
  constexpr float rounding = 2e-3f; // of half floats, and because of another origin of rays
  for (std::size_t i = 0; i < layout.Texels.size(); ++i)
  {
    const Texel& texel = layout.Texels[i];
    const Patch*& patch = same[texel.Tile];
    const float* old =
      patch ? this->Map->First.Pixel(this->IndexIn(*patch, layout, texel)) : nullptr;
    for (std::size_t c = 0; c < 3 && old; ++c)
    {
      const float current = first[i * channels + c];
      if (std::abs(current - old[c]) > rounding * std::max(current, old[c]) + 1e-6f)
      {
        patch = nullptr;
        break;
      }
    }
  }
  for (std::size_t i = 0; i < layout.Texels.size(); ++i)
  {
    kept[i] = same[layout.Texels[i].Tile] ? 1 : 0;
  }
}

std::size_t EarlierBake::Copy(const Layout& layout, const std::vector<unsigned char>& kept,
  Light& to, std::vector<unsigned char>& known) const
{
  std::vector<bool> tiles(layout.Patches.size(), false);
  for (std::size_t i = 0; i < layout.Texels.size(); ++i)
  {
    const Texel& texel = layout.Texels[i];
    const Patch* patch = kept[i] ? this->Find(layout.Patches[texel.Tile]) : nullptr;
    if (patch)
    {
      tiles[texel.Tile] = true;
      const float* old = this->Map->Baked.Pixel(this->IndexIn(*patch, layout, texel));
      std::copy_n(old, to.Channels, to.Pixel(texel.Index));
      known[texel.Index] = 1;
    }
  }
  return static_cast<std::size_t>(std::count(tiles.begin(), tiles.end(), true));
}
}
