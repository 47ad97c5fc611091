// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/Light.h"

#include "common/ForEach.h"

#include <algorithm>
#include <cmath>

namespace penumbra::lightmap
{
namespace
{
constexpr int Reach = 5;             // radius of the averaged texels
constexpr int Patch = 1;             // radius of the patches that are compared
constexpr double NoiseFactor = 0.45; // Rousselle's k: tolerance relative to the noise
constexpr int Colors = 3;            // number of compared channels

class Filter
{
public:
  Filter(const Light& first, const Light& second, const std::vector<unsigned char>& known,
    const std::vector<Texel>& texels, const Atlas& atlas)
    : Halves{ { first, second } }
    , Known(known)
    , Packing(atlas)
    , Normals(known.size())
    , Variance(first.Width, first.Height, Colors)
  {
    for (const Texel& texel : texels)
    {
      this->Normals[texel.Index] = glm::vec3(texel.Normal);
    }
    this->MakeVariance(texels);
  }

  /// The filtered mean of a texel.
  void Apply(const Texel& texel, float* result) const
  {
    const Tile& tile = this->Packing.Tiles[texel.Tile];
    const int width = this->Packing.Width;
    const int x = static_cast<int>(texel.Index) % width, y = static_cast<int>(texel.Index) / width;
    const int channels = this->Halves[0].Channels;
    std::array<double, 2> sums{};
    std::vector<double> light(2 * static_cast<std::size_t>(channels), 0.0);
    for (int j = std::max(y - Reach, tile.At.y);
         j <= std::min(y + Reach, tile.At.y + tile.Texels.y - 1); ++j)
    {
      for (int i = std::max(x - Reach, tile.At.x);
           i <= std::min(x + Reach, tile.At.x + tile.Texels.x - 1); ++i)
      {
        const auto other = static_cast<std::size_t>(j) * width + i;
        if (!this->Known[other])
        {
          continue;
        }
        const double facing = glm::dot(this->Normals[texel.Index], this->Normals[other]);
        const double turned = std::pow(std::max(facing, 0.0), 8.0);
        for (int half = 0; half < 2; ++half)
        {
          // From the other half: the noise of this one must not influence its weights.
          const double weight = turned * this->Similarity(1 - half, tile, { x, y }, { i, j });
          sums[half] += weight;
          for (int c = 0; c < channels; ++c)
          {
            light[half * channels + c] += weight * this->Halves[half].Pixel(other)[c];
          }
        }
      }
    }
    for (int c = 0; c < channels; ++c)
    {
      result[c] = static_cast<float>(0.5 * (light[c] / sums[0] + light[channels + c] / sums[1]));
    }
  }

private:
  /// Variance of a half, from the difference of the two, averaged over the texels around.
  void MakeVariance(const std::vector<Texel>& texels)
  {
    for (const Texel& texel : texels)
    {
      const Tile& tile = this->Packing.Tiles[texel.Tile];
      const int x = static_cast<int>(texel.Index) % this->Packing.Width;
      const int y = static_cast<int>(texel.Index) / this->Packing.Width;
      int count = 0;
      for (int j = std::max(y - 2, tile.At.y); j <= std::min(y + 2, tile.At.y + tile.Texels.y - 1);
           ++j)
      {
        for (int i = std::max(x - 2, tile.At.x);
             i <= std::min(x + 2, tile.At.x + tile.Texels.x - 1); ++i)
        {
          const auto other = static_cast<std::size_t>(j) * this->Packing.Width + i;
          if (this->Known[other])
          {
            ++count;
            for (int c = 0; c < Colors; ++c)
            {
              const float apart = this->Halves[0].Pixel(other)[c] - this->Halves[1].Pixel(other)[c];
              this->Variance.Pixel(texel.Index)[c] += 0.5f * apart * apart;
            }
          }
        }
      }
      for (int c = 0; c < Colors && count > 0; ++c)
      {
        this->Variance.Pixel(texel.Index)[c] /= static_cast<float>(count);
      }
    }
  }

  double Similarity(int half, const Tile& tile, const glm::ivec2& a, const glm::ivec2& b) const
  {
    constexpr double least = 1e-12; // avoids a division of 0 by 0
    const Light& light = this->Halves[half];
    double distance = 0.0;
    int count = 0;
    for (int j = -Patch; j <= Patch; ++j)
    {
      for (int i = -Patch; i <= Patch; ++i)
      {
        const glm::ivec2 p = a + glm::ivec2(i, j), q = b + glm::ivec2(i, j);
        if (!this->Inside(tile, p) || !this->Inside(tile, q))
        {
          continue;
        }
        const auto one = static_cast<std::size_t>(p.y) * this->Packing.Width + p.x;
        const auto other = static_cast<std::size_t>(q.y) * this->Packing.Width + q.x;
        for (int c = 0; c < Colors; ++c)
        {
          const double apart = double(light.Pixel(one)[c]) - light.Pixel(other)[c];
          const double here = this->Variance.Pixel(one)[c], there = this->Variance.Pixel(other)[c];
          distance += (apart * apart - (here + std::min(here, there))) /
            (least + NoiseFactor * NoiseFactor * (here + there));
        }
        count += Colors;
      }
    }
    return count > 0 ? std::exp(-std::max(distance / count, 0.0)) : 0.0;
  }

  bool Inside(const Tile& tile, const glm::ivec2& p) const
  {
    const glm::ivec2 there = p - tile.At;
    return there.x >= 0 && there.y >= 0 && there.x < tile.Texels.x && there.y < tile.Texels.y &&
      this->Known[static_cast<std::size_t>(p.y) * this->Packing.Width + p.x] != 0;
  }

  std::array<const Light, 2> Halves;
  const std::vector<unsigned char>& Known;
  const Atlas& Packing;
  std::vector<glm::vec3> Normals;
  Light Variance;
};
}

Light Denoise(const Light& first, const Light& second, const std::vector<unsigned char>& known,
  const std::vector<Texel>& texels, const Atlas& atlas)
{
  Light result(first.Width, first.Height, first.Channels);
  const Filter filter(first, second, known, texels, atlas);
  tool::ForEach(texels.size(), [&](std::size_t i) {
    if (known[texels[i].Index])
    {
      filter.Apply(texels[i], result.Pixel(texels[i].Index));
    }
  });
  return result;
}

void Dilate(Light& light, std::vector<unsigned char>& known, const Atlas& atlas)
{
  for (const Tile& tile : atlas.Tiles)
  {
    const glm::ivec2 low = tile.At - Atlas::Gutter;
    const glm::ivec2 high = tile.At + tile.Texels - 1 + Atlas::Gutter;
    for (bool grown = true; grown;)
    {
      std::vector<std::size_t> ring;
      std::vector<float> values;
      for (int y = low.y; y <= high.y; ++y)
      {
        for (int x = low.x; x <= high.x; ++x)
        {
          const auto index = static_cast<std::size_t>(y) * light.Width + x;
          if (known[index])
          {
            continue;
          }
          std::vector<double> sum(static_cast<std::size_t>(light.Channels), 0.0);
          int count = 0;
          for (int j = std::max(y - 1, low.y); j <= std::min(y + 1, high.y); ++j)
          {
            for (int i = std::max(x - 1, low.x); i <= std::min(x + 1, high.x); ++i)
            {
              const auto other = static_cast<std::size_t>(j) * light.Width + i;
              count += known[other] ? 1 : 0;
              for (int c = 0; c < light.Channels && known[other]; ++c)
              {
                sum[c] += light.Pixel(other)[c];
              }
            }
          }
          if (count > 0)
          {
            ring.push_back(index);
            for (const double value : sum)
            {
              values.push_back(static_cast<float>(value / count));
            }
          }
        }
      }
      for (std::size_t i = 0; i < ring.size(); ++i)
      {
        known[ring[i]] = 1;
        std::copy_n(&values[i * light.Channels], light.Channels, light.Pixel(ring[i]));
      }
      grown = !ring.empty();
    }
  }
}
}
