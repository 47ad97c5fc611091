// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/DirectLight.h"

namespace penumbra::lightmap
{
namespace
{
/// Hammersley's points (1960), centred in their strips. Rounds have different positions across a shadow edge of any
/// direction.
Vec2 Shift(int round)
{
  constexpr int count = BakeSettings::Rounds;
  double mirrored = 0.0;
  double digit = 0.5;
  for (int bits = round; bits > 0; bits /= 2)
  {
    mirrored += (bits % 2) * digit;
    digit /= 2.0;
  }
  return Vec2(double(round) / count, mirrored) + 0.5 / count - 0.5;
}
}

/// Finds points within solids: they receive no direct and no indirect light, and most of their rays hit back faces.
std::vector<unsigned char> DirectLight::FindBuried(const std::vector<Vec3>& points,
  const std::vector<Vec3>& normals, const std::vector<float>& light)
{
  const std::size_t channels = light.size() / points.size();
  std::vector<std::size_t> dark;
  std::vector<Vec3> darkPoints, darkNormals;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const float* at = &light[i * channels];
    if (at[0] + at[1] + at[2] == 0.0f)
    {
      dark.push_back(i);
      darkPoints.push_back(points[i]);
      darkNormals.push_back(normals[i]);
    }
  }
  std::vector<unsigned char> buried(points.size(), 0);
  if (!dark.empty())
  {
    constexpr int paths = 8;
    this->Gather(darkPoints, darkNormals, 0, paths, [](double) {});
  }
  for (std::size_t k = 0; k < dark.size(); ++k)
  {
    constexpr float most = 0.5f;
    const float* at = &this->Gather.Light[k * channels];
    buried[dark[k]] = at[0] + at[1] + at[2] == 0.0f && this->Gather.Backs[k] > most ? 1 : 0;
  }
  return buried;
}

void DirectLight::AddRound(
  std::size_t first, std::size_t last, Gathered& sums, const std::function<void(double)>& advance)
{
  const auto round = static_cast<int>(sums.Round);
  if (this->Round != round)
  {
    this->Texels = PlaceTexels(
      this->Unwrapped.Scene, this->Unwrapped.Charts, this->Unwrapped.Packing, Shift(round));
    this->Round = round;
  }
  std::vector<Vec3> points, normals;
  for (std::size_t i = first; i < last; ++i)
  {
    points.push_back(this->Texels[i].At);
    normals.push_back(this->Texels[i].Normal);
  }
  this->Gather.Include(false, true);
  this->Gather(points, normals, round * this->Samples, this->Samples, advance);
  this->Gather.Include(true, false);
  const std::vector<float> light = this->Gather.Light;
  const std::vector<unsigned char> buried = this->FindBuried(points, normals, light);
  const auto channels = static_cast<std::size_t>(this->Gather.Channels());
  for (std::size_t i = first; i < last; ++i)
  {
    const std::size_t k = i - first;
    for (std::size_t c = 0; c < channels && !buried[k]; ++c)
    {
      sums.Direct[i * channels + c] += light[k * channels + c];
    }
    sums.DirectRounds[i] += buried[k] ? 0 : 1;
  }
}

Light DirectLight::Mean(const Gathered& sums, std::vector<unsigned char>& known) const
{
  const int channels = this->Gather.Channels();
  Light mean(this->Unwrapped.Packing.Width, this->Unwrapped.Packing.Height, channels);
  known.assign(std::size_t(mean.Width) * mean.Height, 0);
  for (std::size_t i = 0; i < this->Unwrapped.Texels.size(); ++i)
  {
    const std::uint32_t index = this->Unwrapped.Texels[i].Index;
    known[index] = sums.DirectRounds[i] > 0 ? 1 : 0;
    for (int c = 0; c < channels && known[index]; ++c)
    {
      mean.Pixel(index)[c] =
        sums.Direct[i * channels + c] / static_cast<float>(sums.DirectRounds[i]);
    }
  }
  return mean;
}
}
