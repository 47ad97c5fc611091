// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Pictures and their files, read and written with OpenImageIO.
#pragma once

#include "base/Luminance.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace penumbra::tool
{
/// Interleaved floats, first row at the top. 8- and 16-bit files give values from 0 to 1.
struct Picture
{
  int Width = 0;
  int Height = 0;
  int Channels = 0;
  std::vector<float> Values;
  std::vector<std::string> Layers; ///< names of channels after colour and alpha

  Picture() = default;
  Picture(int width, int height, int channels)
    : Width(width)
    , Height(height)
    , Channels(channels)
    , Values(std::size_t(width) * height * channels)
  {
  }
  std::size_t PixelCount() const { return std::size_t(this->Width) * this->Height; }
  float* Pixel(std::size_t index) { return &this->Values[index * this->Channels]; }
  const float* Pixel(std::size_t index) const { return &this->Values[index * this->Channels]; }
  /// Red, green or blue, or the value of a gray picture.
  float Color(std::size_t index, int channel) const
  {
    return this->Pixel(index)[this->Channels >= 3 ? channel : 0];
  }
  /// Relative luminance, with Rec. 709 weights and without a transfer curve.
  float Luminance(std::size_t index) const
  {
    return static_cast<float>(
      penumbra::Luminance(this->Color(index, 0), this->Color(index, 1), this->Color(index, 2)));
  }
};

/// Reads colour and alpha of any file that OpenImageIO supports. Throws a Failure.
Picture ReadPicture(const std::string& path);

/// Throws a Failure if the extension is of no supported format, or the file cannot be written.
void RequireWritablePicture(const std::string& path);

/// Whether the format holds linear radiance (.exr, .hdr).
bool HoldsRadiance(const std::string& path);
/// Whether the format holds more channels than colour and alpha.
bool HoldsLayers(const std::string& path);

/// Writes floats to formats for radiance (half floats in EXR would lose precision), and 8 bits to others.
void WritePicture(const std::string& path, const Picture& picture);

/// Replaces NaN and infinite values by 0. Returns the number of pixels that had any.
std::size_t RemoveNonFinite(Picture& picture);
}
