// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/LampLight.h"

namespace penumbra::lightmap
{
namespace
{
/// Hammersley's points (1960), in the middle of their strips: whichever way a shadow ends across a texel, each round
/// is at another place along it.
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

/// Within a solid: dark, reached by no indirect light, and around it mostly backs.
std::vector<unsigned char> LampLight::FindBuried(const std::vector<Vec3>& points,
  const std::vector<Vec3>& normals, const std::vector<float>& light)
{
  const std::size_t channels = light.size() / points.size();
  std::vector<std::size_t> which;
  std::vector<Vec3> darkPoints, darkNormals;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const float* at = &light[i * channels];
    if (at[0] + at[1] + at[2] == 0.0f)
    {
      which.push_back(i);
      darkPoints.push_back(points[i]);
      darkNormals.push_back(normals[i]);
    }
  }
  std::vector<unsigned char> buried(points.size(), 0);
  if (!which.empty())
  {
    constexpr int paths = 8;
    this->Gather(darkPoints, darkNormals, 0, paths, [](double) {});
  }
  for (std::size_t k = 0; k < which.size(); ++k)
  {
    constexpr float mostly = 0.5f;
    const float* at = &this->Gather.Light[k * channels];
    buried[which[k]] = at[0] + at[1] + at[2] == 0.0f && this->Gather.Backs[k] > mostly ? 1 : 0;
  }
  return buried;
}

void LampLight::AddRound(
  std::size_t first, std::size_t last, Gathered& sums, const std::function<void(double)>& advance)
{
  const auto round = static_cast<int>(sums.Round);
  if (this->Round != round)
  {
    this->Texels =
      PlaceTexels(this->Places.Scene, this->Places.Charts, this->Places.Places, Shift(round));
    this->Round = round;
  }
  std::vector<Vec3> points, normals;
  for (std::size_t i = first; i < last; ++i)
  {
    points.push_back(this->Texels[i].At);
    normals.push_back(this->Texels[i].Normal);
  }
  this->Gather.Count(false, true);
  this->Gather(points, normals, round * this->Samples, this->Samples, advance);
  this->Gather.Count(true, false);
  const std::vector<float> light = this->Gather.Light;
  const std::vector<unsigned char> buried = this->FindBuried(points, normals, light);
  const auto channels = static_cast<std::size_t>(this->Gather.Channels());
  for (std::size_t i = first; i < last; ++i)
  {
    const std::size_t k = i - first;
    for (std::size_t c = 0; c < channels && !buried[k]; ++c)
    {
      sums.Lamps[i * channels + c] += light[k * channels + c];
    }
    sums.LampRounds[i] += buried[k] ? 0 : 1;
  }
}

Light LampLight::Mean(const Gathered& sums, std::vector<unsigned char>& known) const
{
  const int channels = this->Gather.Channels();
  Light mean(this->Places.Places.Width, this->Places.Places.Height, channels);
  known.assign(std::size_t(mean.Width) * mean.Height, 0);
  for (std::size_t i = 0; i < this->Places.Texels.size(); ++i)
  {
    const std::uint32_t index = this->Places.Texels[i].Index;
    known[index] = sums.LampRounds[i] > 0 ? 1 : 0;
    for (int c = 0; c < channels && known[index]; ++c)
    {
      mean.At(index)[c] = sums.Lamps[i * channels + c] / static_cast<float>(sums.LampRounds[i]);
    }
  }
  return mean;
}
}
