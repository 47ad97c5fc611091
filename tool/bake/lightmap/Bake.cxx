// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/Bake.h"

#include "bake/lightmap/EarlierBake.h"
#include "bake/lightmap/GatherLight.h"
#include "bake/lightmap/DirectLight.h"
#include "bake/lightmap/Layout.h"
#include "bake/lightmap/Progress.h"

#include "bake/BakedScene.h"

#include <algorithm>

namespace penumbra::lightmap
{
namespace
{
constexpr std::uint32_t BlockSize = 32768; // texels between checks whether to save

/// Settings that must be the same to reuse the light of an earlier bake.
std::string Describe(const BakeSettings& settings)
{
  return fmt::format("{} samples, {} bounces{}{}{}{}{}", settings.Samples, settings.Bounces,
    settings.MaximumAlbedo < 1.0 ? fmt::format(", white reflects {:g}", settings.MaximumAlbedo) : "",
    settings.EnergyCompensation ? ", metals keep their light" : "",
    settings.Directional ? ", directional" : "", settings.Denoise ? ", denoised" : "",
    settings.Direct ? ", with the lamps' light" : "");
}

std::string DescribeScene(vtkRenderer* renderer, const BakeSettings& settings)
{
  BakedSceneCache cache;
  const auto& names = settings.Names;
  return BakedScene::Of(renderer, cache, [&names](vtkProp* prop) {
    const auto found = names.find(prop);
    return found == names.end() ? std::string() : "'" + found->second + "'";
  }).ToText();
}

Layout Unwrap(vtkRenderer* renderer, const BakeSettings& settings, GatherLight& gather,
  tool::Reporter& reporter)
{
  gather.Include(true, settings.Direct);
  Layout layout = MakeLayout(renderer, settings, gather, reporter);
  gather.Include(true, false);
  return layout;
}

class Baker
{
public:
  Baker(vtkRenderer* renderer, const BakeSettings& settings, tool::Reporter& reporter)
    : Options(settings)
    , Notes(reporter)
    , Gather(renderer, settings)
    , Unwrapped(Unwrap(renderer, settings, this->Gather, reporter))
    , Direct(this->Unwrapped, this->Gather, settings.Samples / BakeSettings::Rounds)
    , Earlier(settings, Describe(settings))
  {
    Lightmap& map = this->Result.Map;
    map.Settings = Describe(settings);
    map.Made = fmt::format("{}, {} texels up to {:.6g} wide in {} charts", map.Settings,
      this->Unwrapped.Texels.size(), this->Unwrapped.Packing.TexelSize,
      this->Unwrapped.Charts.size());
    map.Scene = DescribeScene(renderer, settings);
    map.Patches = this->Unwrapped.Patches;
    AddSurfaces(map, this->Unwrapped.Scene, this->Unwrapped.Charts, this->Unwrapped.Packing);
    this->Result.TexelSize = this->Unwrapped.Packing.TexelSize;
    this->Result.Charts = this->Unwrapped.Charts.size();
    this->Result.Tiles = this->Unwrapped.Packing.Tiles.size();
    this->Result.Texels = this->Unwrapped.Texels.size();
    this->Result.DarkSides = this->Unwrapped.DarkSides;
  }

  BakeResult Run()
  {
    const ProgressFile file = this->GatherAll();
    this->Finish();
    WriteLightmap(this->Options.Output, this->Result.Map);
    file.Remove();
    return std::move(this->Result);
  }

private:
  std::string Identity() const
  {
    const Lightmap& map = this->Result.Map;
    OIIO::SHA1 sum(map.Scene.data(), map.Scene.size());
    sum.append(map.Made.data(), map.Made.size());
    for (const Patch& patch : map.Patches)
    {
      sum.append(&patch, sizeof(patch));
    }
    this->Earlier.AddTo(sum);
    return sum.digest();
  }

  void Allocate()
  {
    const std::size_t count = this->Unwrapped.Texels.size();
    const auto channels = static_cast<std::size_t>(this->Gather.Channels());
    for (auto& half : this->Sums.Halves)
    {
      half.assign(count * channels, 0.0f);
    }
    this->Sums.First.assign(count * channels, 0.0f);
    this->Sums.Backs.assign(count, 0.0f);
    this->Sums.Kept.assign(count, 0);
    this->Sums.Direct.assign(this->Options.Direct ? count * channels : 0, 0.0f);
    this->Sums.DirectRounds.assign(this->Options.Direct ? count : 0, 0);
  }

  ProgressFile GatherAll()
  {
    this->Allocate();
    ProgressFile file(this->Options.Output + ".baking", this->Identity());
    if (!this->Options.FromScratch)
    {
      const std::string reason = file.Load(this->Sums);
      if (!reason.empty())
      {
        this->Notes.Note(
          fmt::format("'{}.baking' {}: baking starts from scratch", this->Options.Output, reason));
      }
    }
    const auto count = static_cast<std::uint32_t>(this->Unwrapped.Texels.size());
    const std::uint32_t blocks = (count + BlockSize - 1) / BlockSize;
    const auto share = [&](double within) {
      return (this->Sums.Round + (this->Sums.Block + within) / blocks) / BakeSettings::Rounds;
    };
    this->Result.Resumed = share(0.0);
    tool::Step step(this->Notes, "gathering light");
    while (this->Sums.Round < BakeSettings::Rounds)
    {
      const std::size_t first = std::size_t(this->Sums.Block) * BlockSize;
      const std::size_t last = std::min<std::size_t>(first + BlockSize, count);
      const double indirect = this->Options.Direct ? 0.8 : 1.0; // approximate share of time
      this->GatherBlock(
        first, last, [&](double within) { step.Advance(share(indirect * within)); });
      if (this->Options.Direct)
      {
        this->Direct.AddRound(first, last, this->Sums,
          [&](double within) { step.Advance(share(indirect + (1.0 - indirect) * within)); });
      }
      if (++this->Sums.Block == blocks)
      {
        this->Sums.Block = 0;
        ++this->Sums.Round;
        if (this->Sums.Round == 1)
        {
          this->Earlier.FindSame(this->Unwrapped, this->Sums.First,
            static_cast<std::size_t>(this->Gather.Channels()), this->Sums.Kept);
        }
      }
      file.Save(this->Sums);
    }
    return file;
  }

  void GatherBlock(std::size_t first, std::size_t last, const std::function<void(double)>& advance)
  {
    std::vector<std::size_t> which;
    std::vector<Vec3> points, normals;
    for (std::size_t i = first; i < last; ++i)
    {
      if (!this->Sums.Kept[i])
      {
        which.push_back(i);
        points.push_back(this->Unwrapped.Texels[i].At);
        normals.push_back(this->Unwrapped.Texels[i].Normal);
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

  void Finish()
  {
    tool::Step step(this->Notes, "filtering light");
    Lightmap& map = this->Result.Map;
    std::vector<unsigned char> known;
    map.Baked = this->FilterLight(known);
    this->Result.KeptTiles = this->Earlier.Copy(this->Unwrapped, this->Sums.Kept, map.Baked, known);
    Dilate(map.Baked, known, this->Unwrapped.Packing);
    if (this->Options.Direct)
    {
      map.Direct = this->Direct.Mean(this->Sums, known);
      Dilate(map.Direct, known, this->Unwrapped.Packing);
    }
    const auto lines = PlaceSeams(this->Unwrapped.Scene, this->Unwrapped.Charts,
      this->Unwrapped.Packing, FindSeams(this->Unwrapped.Scene, this->Unwrapped.Charts));
    std::vector<unsigned char> kept(known.size(), 0), shown(known.size(), 0);
    for (std::size_t i = 0; i < this->Unwrapped.Texels.size(); ++i)
    {
      kept[this->Unwrapped.Texels[i].Index] = this->Sums.Kept[i];
      shown[this->Unwrapped.Texels[i].Index] = 1;
    }
    for (Light* light : { &map.Baked, &map.Direct })
    {
      if (light->Channels == 0)
      {
        continue;
      }
      this->Result.OpenSeamStep = std::max(this->Result.OpenSeamStep, SeamStep(*light, lines));
      if (this->Options.CloseSeams)
      {
        // Direct light is always gathered again.
        CloseSeams(*light, lines, light == &map.Baked ? kept : std::vector<unsigned char>());
        auto filled = shown;
        Dilate(*light, filled, this->Unwrapped.Packing);
      }
      this->Result.SeamStep = std::max(this->Result.SeamStep, SeamStep(*light, lines));
    }
  }

  /// The mean of all rounds. Finds the texels that have one, and stores their first round in the map.
  Light FilterLight(std::vector<unsigned char>& known)
  {
    const int channels = this->Gather.Channels();
    const int width = this->Unwrapped.Packing.Width, height = this->Unwrapped.Packing.Height;
    known.assign(std::size_t(width) * height, 0);
    Light halves[2] = { { width, height, channels }, { width, height, channels } };
    Light& first = this->Result.Map.First;
    first = Light(width, height, 3);
    for (std::size_t i = 0; i < this->Unwrapped.Texels.size(); ++i)
    {
      const std::uint32_t index = this->Unwrapped.Texels[i].Index;
      const bool buried = this->IsBuried(i);
      known[index] = buried ? 0 : 1;
      this->Result.Buried += buried ? 1 : 0;
      for (int c = 0; c < channels; ++c)
      {
        for (int half = 0; half < 2; ++half)
        {
          halves[half].Pixel(index)[c] =
            this->Sums.Halves[half][i * channels + c] / (BakeSettings::Rounds / 2);
        }
        if (c < 3)
        {
          first.Pixel(index)[c] = this->Sums.First[i * channels + c];
        }
      }
    }
    if (this->Options.Denoise)
    {
      return Denoise(halves[0], halves[1], known, this->Unwrapped.Texels, this->Unwrapped.Packing);
    }
    for (std::size_t i = 0; i < halves[0].Values.size(); ++i)
    {
      halves[0].Values[i] = 0.5f * (halves[0].Values[i] + halves[1].Values[i]);
    }
    return std::move(halves[0]);
  }

  /// Whether a texel is within a solid: it receives no light, and most of its rays hit back faces.
  bool IsBuried(std::size_t i) const
  {
    constexpr float most = 0.5f;
    const auto channels = static_cast<std::size_t>(this->Gather.Channels());
    const float* a = &this->Sums.Halves[0][i * channels];
    const float* b = &this->Sums.Halves[1][i * channels];
    const bool dark = a[0] + a[1] + a[2] + b[0] + b[1] + b[2] == 0.0f;
    return dark && !this->Sums.Kept[i] && this->Sums.Backs[i] > most * BakeSettings::Rounds;
  }

  const BakeSettings& Options;
  tool::Reporter& Notes;
  GatherLight Gather;
  Layout Unwrapped;
  DirectLight Direct;
  EarlierBake Earlier;
  Gathered Sums;
  BakeResult Result;
};
}

BakeResult BakeLightmap(
  vtkRenderer* renderer, const BakeSettings& settings, tool::Reporter& reporter)
{
  return Baker(renderer, settings, reporter).Run();
}
}
