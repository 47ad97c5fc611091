// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Pictures in memory and their files, through OpenImageIO.
#pragma once

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
  std::vector<std::string> Layers; ///< names of the channels after colour and alpha

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
  /// One of red, green and blue, or the only value of a grey picture.
  float Color(std::size_t index, int channel) const
  {
    return this->Pixel(index)[this->Channels >= 3 ? channel : 0];
  }
  /// Relative luminance with Rec. 709 weights, without any transfer curve.
  float Luminance(std::size_t index) const
  {
    return 0.2126f * this->Color(index, 0) + 0.7152f * this->Color(index, 1) +
      0.0722f * this->Color(index, 2);
  }
};

/// Reads any file OpenImageIO knows, colour and alpha only; throws a Failure that names it.
Picture ReadPicture(const std::string& path);

/// Throws a Failure unless the name ends in a format we write and its folder is writable.
void RequireWritablePicture(const std::string& path);

/// True for formats that hold linear radiance (.exr, .hdr).
bool HoldsRadiance(const std::string& path);
/// Whether it can hold more than a picture: layers.
bool HoldsLayers(const std::string& path);

/// Writes the picture: floats (half in EXR would lose precision) for radiance formats, else 8 bits.
void WritePicture(const std::string& path, const Picture& picture);

/// Replaces NaN and infinite values by 0 and returns how many pixels had one.
std::size_t RemoveNonFinite(Picture& picture);
}
