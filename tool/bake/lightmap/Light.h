// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// What is stored in an atlas' texels, and what is done to it once it is baked.
#pragma once

#include "bake/lightmap/Texels.h"

#include <vector>

namespace penumbra::lightmap
{
/// Interleaved floats, row by row.
struct Light
{
  int Width = 0;
  int Height = 0;
  int Channels = 0; ///< irradiance divided by pi, and for directional maps nine more
  std::vector<float> Values;

  Light() = default;
  Light(int width, int height, int channels)
    : Width(width)
    , Height(height)
    , Channels(channels)
    , Values(std::size_t(width) * height * channels, 0.0f)
  {
  }
  float* At(std::size_t texel) { return &this->Values[texel * this->Channels]; }
  const float* At(std::size_t texel) const { return &this->Values[texel * this->Channels]; }
  /// Between four texels, as the graphics card interpolates; whole numbers are texels' middles.
  double Sample(const Vec2& at, int channel) const;
};

/// Gives texels that have no value of their own (known is 0) the mean of their neighbours, as far as tiles and
/// their gutters reach, from the inside out.
void Dilate(Light& light, std::vector<unsigned char>& known, const Atlas& atlas);

/// Makes the light on both sides of seams the same where it is interpolated: least squares of what differs there
/// and of how much texels change (Iwanicki 2013, Lighting Technology of The Last of Us). fixed: where not 0, the texel stays
/// as it is; seams between such are closed already, and closing them once more would carry their light away.
void CloseSeams(
  Light& light, const std::vector<SeamLine>& lines, const std::vector<unsigned char>& fixed = {});

/// The greatest difference across seams, of the light there, or of a tenth of the seams' mean where that is more.
double SeamStep(const Light& light, const std::vector<SeamLine>& lines);

/// Takes noise out of the mean of two halves of the samples, within tiles: what one half knows tells which texels
/// of the other are alike (Rousselle, Knaus and Zwicker 2012, Adaptive Rendering with Non-Local Means Filtering).
/// known: texels that have a value.
Light Denoise(const Light& first, const Light& second, const std::vector<unsigned char>& known,
  const std::vector<Texel>& texels, const Atlas& atlas);
}
