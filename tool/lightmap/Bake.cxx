// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bake.h"

#include "GatherLight.h"
#include "Progress.h"

#include "../scene/Checkpoint.h"
#include "../scene/Failure.h"

#include "private/BakedScene.h"

#include <OpenImageIO/hash.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

namespace penumbra::lightmap
{
namespace
{
constexpr std::uint32_t BlockSize = 32768; // texels between two looks at the clock

class Baker
{
public:
  Baker(vtkRenderer* renderer, const BakeSettings& settings, tool::Reporter& reporter)
    : Options(settings)
    , Reporter(reporter)
    , Renderer(renderer)
    , Gather(renderer, settings.Bounces, settings.Directional)
  {
  }

  BakeResult Run()
  {
    this->Unwrap();
    this->ReadEarlier();
    this->GatherAll();
    this->Finish();
    return std::move(this->Result);
  }

private:
  void Unwrap()
  {
    tool::Step step(this->Reporter, "unwrapping surfaces");
    this->Scene = GatherSurfaces(this->Renderer);
    for (const std::string& note : this->Scene.Notes)
    {
      this->Reporter.Note(note);
    }
    if (this->Scene.Triangles.empty())
    {
      tool::Fail("the scene has no opaque surface that is lit: a lightmap is for such");
    }
    this->Charts = MakeCharts(this->Scene);
    constexpr double fine = 128.0;
    const double texel =
      this->Options.TexelSize > 0.0 ? this->Options.TexelSize : this->Scene.Diagonal() / fine;
    const std::vector<std::array<bool, 2>> wanted = this->FindLitSides(texel, step);
    try
    {
      this->Places = PackAtlas(this->Charts, wanted, texel, this->Options.LargestSide);
    }
    catch (const std::runtime_error& error)
    {
      tool::Fail("{}", error.what());
    }
    if (this->Options.TexelSize > 0.0 && this->Places.TexelSize > texel)
    {
      this->Reporter.Note(
        fmt::format("texels are {:.3g} wide, to fit into --max-size", this->Places.TexelSize));
    }
    this->Texels = PlaceTexels(this->Scene, this->Charts, this->Places);
    this->Result.TexelSize = this->Places.TexelSize;
    this->Result.Charts = this->Charts.size();
    this->Result.Tiles = this->Places.Tiles.size();
    this->Result.Texels = this->Texels.size();
    BakedSceneCache cache;
    const auto& names = this->Options.Names;
    this->Result.Map.Scene = BakedScene::Of(this->Renderer, cache, [&names](vtkProp* prop) {
      const auto found = names.find(prop);
      return found == names.end() ? std::string() : "'" + found->second + "'";
    }).ToText();
    AddSurfaces(this->Result.Map, this->Scene, this->Charts, this->Places);
    this->MakePatches();
  }

  /// Sides of charts that some light reaches: within solids, and where a room turns its back, there is none.
  std::vector<std::array<bool, 2>> FindLitSides(double texel, tool::Step& step)
  {
    constexpr int least = 8, most = 64, paths = 16;
    std::vector<Vec3> points, normals;
    std::vector<std::pair<std::size_t, int>> sides;
    for (std::size_t c = 0; c < this->Charts.size(); ++c)
    {
      const Chart& chart = this->Charts[c];
      const double texels = chart.Size.x * chart.Size.y / (texel * texel);
      const int count = std::clamp(static_cast<int>(std::min(texels, 1e6) / 4), least, most);
      for (int back = 0; back < 2; ++back)
      {
        if (this->Scene.Triangles[chart.Triangles.front()].Drawn[back])
        {
          ScatterPoints(this->Scene, chart, back != 0, count, points, normals);
          sides.resize(points.size(), { c, back });
        }
      }
    }
    this->Gather(points, normals, 0, paths, [&step](double share) { step.Advance(share); });
    for (const std::string& note : this->Gather.Notes())
    {
      this->Reporter.Note(note);
    }
    std::vector<std::array<bool, 2>> lit(this->Charts.size(), { { false, false } });
    const auto channels = static_cast<std::size_t>(this->Gather.Channels());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const float* light = &this->Gather.Light[i * channels];
      bool& side = lit[sides[i].first][static_cast<std::size_t>(sides[i].second)];
      side = side || light[0] > 0.0f || light[1] > 0.0f || light[2] > 0.0f;
    }
    std::size_t tiles = 0;
    for (const auto& side : lit)
    {
      this->Result.DarkSides += (side[0] ? 0 : 1) + (side[1] ? 0 : 1);
      tiles += (side[0] ? 1 : 0) + (side[1] ? 1 : 0);
    }
    if (tiles == 0)
    {
      tool::Fail(
        "no indirect light reaches any surface: give the scene lights, an environment or surfaces "
        "that glow");
    }
    return lit;
  }

  void MakePatches()
  {
    std::vector<OIIO::SHA1> keys(this->Places.Tiles.size());
    for (const Texel& texel : this->Texels)
    {
      // Of the middle of the surfaces, as rays are traced from there: to its rounding.
      const glm::vec3 at(texel.At - this->Scene.Center());
      const glm::vec3 normal(texel.Normal);
      keys[texel.Tile].append(&at, sizeof(at));
      keys[texel.Tile].append(&normal, sizeof(normal));
    }
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
      const Tile& tile = this->Places.Tiles[i];
      std::uint64_t key = 0;
      std::memcpy(&key, keys[i].digest().data(), sizeof(key));
      this->Result.Map.Patches.push_back({ tile.At, tile.Texels, key });
    }
    this->Result.Map.Settings = fmt::format("{} samples, {} bounces{}{}", this->Options.Samples,
      this->Options.Bounces, this->Options.Directional ? ", directional" : "",
      this->Options.Denoise ? ", denoised" : "");
    this->Result.Map.Made = fmt::format("{}, {} texels up to {:.6g} wide in {} charts",
      this->Result.Map.Settings, this->Texels.size(), this->Places.TexelSize, this->Charts.size());
  }

  /// A bake that is there already, if it can be compared with.
  void ReadEarlier()
  {
    std::error_code error;
    if (this->Options.Anew || !std::filesystem::exists(this->Options.Output, error))
    {
      return;
    }
    try
    {
      this->Earlier = ReadLightmap(this->Options.Output);
    }
    catch (const tool::Failure& failure)
    {
      tool::Fail("{}; --anew bakes over it", failure.what());
    }
    if (this->Earlier->Settings != this->Result.Map.Settings)
    {
      this->Earlier.reset();
    }
  }

  std::string Identity() const
  {
    OIIO::SHA1 sum(this->Result.Map.Scene.data(), this->Result.Map.Scene.size());
    sum.append(this->Result.Map.Made.data(), this->Result.Map.Made.size());
    for (const Patch& patch : this->Result.Map.Patches)
    {
      sum.append(&patch, sizeof(patch));
    }
    if (this->Earlier)
    {
      sum.append(this->Earlier->Scene.data(), this->Earlier->Scene.size());
      sum.append(
        this->Earlier->First.Values.data(), this->Earlier->First.Values.size() * sizeof(float));
    }
    return sum.digest();
  }

  void GatherAll()
  {
    const std::size_t count = this->Texels.size();
    const auto channels = static_cast<std::size_t>(this->Gather.Channels());
    for (auto& half : this->Sums.Halves)
    {
      half.assign(count * channels, 0.0f);
    }
    this->Sums.First.assign(count * channels, 0.0f);
    this->Sums.Backs.assign(count, 0.0f);
    this->Sums.Kept.assign(count, 0);
    ProgressFile file(this->Options.Output + ".baking", this->Identity());
    if (!this->Options.Anew)
    {
      const std::string reason = file.Load(this->Sums);
      if (!reason.empty())
      {
        this->Reporter.Note(
          fmt::format("'{}.baking' {}: baking begins anew", this->Options.Output, reason));
      }
    }
    const auto blocks = static_cast<std::uint32_t>((count + BlockSize - 1) / BlockSize);
    const auto share = [&](double within) {
      return (this->Sums.Round + (this->Sums.Block + within) / blocks) / BakeSettings::Rounds;
    };
    this->Result.Resumed = share(0.0);
    tool::Step step(this->Reporter, "gathering light");
    while (this->Sums.Round < BakeSettings::Rounds)
    {
      this->GatherBlock([&](double within) { step.Advance(share(within)); });
      if (++this->Sums.Block == blocks)
      {
        this->Sums.Block = 0;
        ++this->Sums.Round;
        if (this->Sums.Round == 1)
        {
          this->KeepWhatIsTheSame();
        }
      }
      file.Save(this->Sums);
    }
    this->Partial = std::make_unique<ProgressFile>(file);
  }

  void GatherBlock(const std::function<void(double)>& advance)
  {
    const std::size_t first = std::size_t(this->Sums.Block) * BlockSize;
    const std::size_t last = std::min<std::size_t>(first + BlockSize, this->Texels.size());
    std::vector<std::size_t> which;
    std::vector<Vec3> points, normals;
    for (std::size_t i = first; i < last; ++i)
    {
      if (!this->Sums.Kept[i])
      {
        which.push_back(i);
        points.push_back(this->Texels[i].At);
        normals.push_back(this->Texels[i].Normal);
      }
    }
    if (which.empty())
    {
      return;
    }
    const int samples = this->Options.Samples / BakeSettings::Rounds;
    this->Gather(points, normals, static_cast<int>(this->Sums.Round) * samples, samples, advance);
    const auto channels = static_cast<std::size_t>(this->Gather.Channels());
    std::vector<float>& half = this->Sums.Halves[this->Sums.Round % 2];
    for (std::size_t k = 0; k < which.size(); ++k)
    {
      for (std::size_t c = 0; c < channels; ++c)
      {
        half[which[k] * channels + c] += this->Gather.Light[k * channels + c];
      }
      this->Sums.Backs[which[k]] += this->Gather.Backs[k];
    }
    if (this->Sums.Round == 0)
    {
      for (std::size_t i = first * channels; i < last * channels; ++i)
      {
        this->Sums.First[i] = half[i];
      }
    }
  }

  /// Paths are the same for the same texel, sample and scene. Where the first round finds at every texel of a tile
  /// what it found for the earlier bake, no path there met what has changed since: its light is kept.
  void KeepWhatIsTheSame()
  {
    if (!this->Earlier)
    {
      return;
    }
    std::map<std::uint64_t, const Patch*> known;
    for (const Patch& patch : this->Earlier->Patches)
    {
      known[patch.Key] = &patch;
    }
    const auto& patches = this->Result.Map.Patches;
    std::vector<const Patch*> same(patches.size(), nullptr);
    for (std::size_t i = 0; i < patches.size(); ++i)
    {
      const auto found = known.find(patches[i].Key);
      same[i] = found != known.end() && found->second->Texels == patches[i].Texels ? found->second
                                                                                   : nullptr;
    }
    const auto channels = static_cast<std::size_t>(this->Gather.Channels());
    constexpr float rounding = 2e-3f; // of half floats, and of another origin of the rays
    for (std::size_t i = 0; i < this->Texels.size(); ++i)
    {
      const std::uint32_t tile = this->Texels[i].Tile;
      const float* old =
        same[tile] ? this->Earlier->First.At(this->IndexIn(*same[tile], i)) : nullptr;
      for (std::size_t c = 0; c < 3 && old; ++c)
      {
        const float now = this->Sums.First[i * channels + c];
        if (std::abs(now - old[c]) > rounding * std::max(now, old[c]) + 1e-6f)
        {
          same[tile] = nullptr;
          break;
        }
      }
    }
    for (std::size_t i = 0; i < this->Texels.size(); ++i)
    {
      this->Sums.Kept[i] = same[this->Texels[i].Tile] ? 1 : 0;
    }
  }

  /// Where in the earlier bake's picture a texel was.
  std::size_t IndexIn(const Patch& patch, std::size_t i) const
  {
    const Tile& tile = this->Places.Tiles[this->Texels[i].Tile];
    const auto index = static_cast<int>(this->Texels[i].Index);
    const glm::ivec2 within =
      glm::ivec2(index % this->Places.Width, index / this->Places.Width) - tile.At;
    const glm::ivec2 there = patch.At + within;
    return std::size_t(there.y) * this->Earlier->Baked.Width + there.x;
  }

  void Finish()
  {
    tool::Step step(this->Reporter, "filtering light");
    Lightmap& map = this->Result.Map;
    const int channels = this->Gather.Channels();
    const int width = this->Places.Width, height = this->Places.Height;
    std::vector<unsigned char> known(std::size_t(width) * height, 0);
    Light halves[2] = { { width, height, channels }, { width, height, channels } };
    map.First = Light(width, height, 3);
    for (std::size_t i = 0; i < this->Texels.size(); ++i)
    {
      const std::uint32_t index = this->Texels[i].Index;
      const bool dark = this->IsBuried(i);
      known[index] = dark ? 0 : 1;
      this->Result.Buried += dark ? 1 : 0;
      for (int c = 0; c < channels; ++c)
      {
        for (int half = 0; half < 2; ++half)
        {
          halves[half].At(index)[c] =
            this->Sums.Halves[half][i * channels + c] / (BakeSettings::Rounds / 2);
        }
        if (c < 3)
        {
          map.First.At(index)[c] = this->Sums.First[i * channels + c];
        }
      }
    }
    if (this->Options.Denoise)
    {
      map.Baked = Denoise(halves[0], halves[1], known, this->Texels, this->Places);
    }
    else
    {
      map.Baked = halves[0];
      for (std::size_t i = 0; i < map.Baked.Values.size(); ++i)
      {
        map.Baked.Values[i] = 0.5f * (halves[0].Values[i] + halves[1].Values[i]);
      }
    }
    this->TakeKept(known);
    Dilate(map.Baked, known, this->Places);
    const auto lines =
      PlaceSeams(this->Scene, this->Charts, this->Places, FindSeams(this->Scene, this->Charts));
    this->Result.OpenSeamStep = SeamStep(map.Baked, lines);
    if (this->Options.CloseSeams)
    {
      CloseSeams(map.Baked, lines);
    }
    this->Result.SeamStep = SeamStep(map.Baked, lines);
    WriteLightmap(this->Options.Output, map);
    this->Partial->Remove();
  }

  /// Within a solid: no light at all, and around it mostly backs.
  bool IsBuried(std::size_t i) const
  {
    constexpr float mostly = 0.5f;
    const auto channels = static_cast<std::size_t>(this->Gather.Channels());
    const float* a = &this->Sums.Halves[0][i * channels];
    const float* b = &this->Sums.Halves[1][i * channels];
    const bool dark = a[0] + a[1] + a[2] + b[0] + b[1] + b[2] == 0.0f;
    return dark && !this->Sums.Kept[i] && this->Sums.Backs[i] > mostly * BakeSettings::Rounds;
  }

  void TakeKept(std::vector<unsigned char>& known)
  {
    std::vector<bool> kept(this->Places.Tiles.size(), false);
    for (std::size_t i = 0; i < this->Texels.size(); ++i)
    {
      if (!this->Sums.Kept[i])
      {
        continue;
      }
      const std::uint32_t tile = this->Texels[i].Tile;
      kept[tile] = true;
      const auto& patches = this->Earlier->Patches;
      const auto found = std::find_if(patches.begin(), patches.end(),
        [&](const Patch& patch) { return patch.Key == this->Result.Map.Patches[tile].Key; });
      const float* old = this->Earlier->Baked.At(this->IndexIn(*found, i));
      std::copy_n(old, this->Gather.Channels(), this->Result.Map.Baked.At(this->Texels[i].Index));
      known[this->Texels[i].Index] = 1;
    }
    this->Result.KeptTiles = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), true));
  }

  const BakeSettings& Options;
  tool::Reporter& Reporter;
  vtkRenderer* Renderer;
  GatherLight Gather;
  Surfaces Scene;
  std::vector<Chart> Charts;
  Atlas Places;
  std::vector<Texel> Texels;
  std::optional<Lightmap> Earlier;
  Gathered Sums;
  std::unique_ptr<ProgressFile> Partial;
  BakeResult Result;
};
}

BakeResult BakeLightmap(
  vtkRenderer* renderer, const BakeSettings& settings, tool::Reporter& reporter)
{
  return Baker(renderer, settings, reporter).Run();
}
}
