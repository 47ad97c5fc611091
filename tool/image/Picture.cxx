// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image/Picture.h"

#include "common/Failure.h"
#include "common/Names.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace penumbra::tool
{
namespace
{
const std::vector<std::string> WrittenFormats = { ".png", ".exr", ".hdr", ".tif", ".tiff", ".jpg" };
constexpr int LargestSide = 65536; // larger sizes mean a damaged file

std::string Extension(const std::string& path)
{
  return Lower(std::filesystem::path(path).extension());
}

/// Writes a file. Removes an incomplete one if the disk is full.
void WriteBytes(const std::string& path, const std::vector<unsigned char>& bytes)
{
  std::ofstream file(path, std::ios::binary);
  file.write(
    reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file)
  {
    const std::string reason = std::generic_category().message(errno);
    if (std::filesystem::is_regular_file(path))
    {
      std::error_code ignored;
      std::filesystem::remove(path, ignored);
    }
    Fail("the output '{}' cannot be written completely ({}): make room on the disk", path, reason);
  }
}

/// A JPEG file ends with the marker EOI (ITU-T T.81). The decoder fills missing parts with gray.
void RequireCompleteJpeg(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), {});
  const std::array<char, 2> marker = { '\xff', '\xd9' };
  if (std::find_end(bytes.begin(), bytes.end(), marker.begin(), marker.end()) == bytes.end())
  {
    Fail("the picture '{}' is cut off: copy or download it again", path);
  }
}
}

Picture ReadPicture(const std::string& path)
{
  if (!std::ifstream(path) || std::filesystem::is_directory(path))
  {
    Fail("the picture '{}' cannot be opened: check the name and that you may read it", path);
  }
  const auto file = OIIO::ImageInput::open(path);
  if (!file)
  {
    Fail("the picture '{}' cannot be read: it is damaged or in an unknown format ({})", path,
      OIIO::geterror());
  }
  const OIIO::ImageSpec& spec = file->spec();
  const bool sane = spec.width > 0 && spec.height > 0 && spec.nchannels > 0 && spec.depth <= 1 &&
    spec.width <= LargestSide && spec.height <= LargestSide;
  if (!sane)
  {
    Fail("the picture '{}' has a size of {} by {} pixels: it is damaged or too big", path,
      spec.width, spec.height);
  }
  if (std::string(file->format_name()) == "jpeg")
  {
    RequireCompleteJpeg(path);
  }
  // A fourth channel that is not alpha is another layer.
  const bool layers =
    spec.nchannels > 3 && spec.format == OIIO::TypeDesc::FLOAT && spec.alpha_channel < 0;
  Picture picture(spec.width, spec.height, layers ? 3 : std::min(spec.nchannels, 4));
  if (!file->read_image(0, 0, 0, picture.Channels, OIIO::TypeDesc::FLOAT, picture.Values.data()))
  {
    Fail("the picture '{}' cannot be read completely: it is damaged or cut off ({})", path,
      file->geterror());
  }
  return picture;
}

void RequireWritablePicture(const std::string& path)
{
  const std::string end = Extension(path);
  if (std::find(WrittenFormats.begin(), WrittenFormats.end(), end) == WrittenFormats.end())
  {
    FailUsage("the output '{}' has no extension of a picture format: use one of {}", path,
      fmt::join(WrittenFormats, ", "));
  }
  const auto folder = std::filesystem::absolute(path).parent_path();
  if (!std::filesystem::is_directory(folder))
  {
    Fail(
      "the output '{}' cannot be written: the folder '{}' does not exist", path, folder.string());
  }
  const bool existed = std::filesystem::exists(path);
  if (std::filesystem::is_directory(path) || !std::ofstream(path, std::ios::app))
  {
    Fail("the output '{}' cannot be written: choose a file in a folder you may write to", path);
  }
  if (!existed)
  {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
}

bool HoldsRadiance(const std::string& path)
{
  const std::string end = Extension(path);
  return end == ".exr" || end == ".hdr";
}

bool HoldsLayers(const std::string& path)
{
  return Extension(path) == ".exr";
}

void WritePicture(const std::string& path, const Picture& picture)
{
  // Encode in memory: some encoders do not detect a full disk, and one never returns.
  OIIO::Filesystem::IOVecOutput memory;
  const auto encoder = OIIO::ImageOutput::create(path);
  const OIIO::TypeDesc stored = HoldsRadiance(path) ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
  OIIO::ImageSpec spec(picture.Width, picture.Height, picture.Channels, stored);
  for (std::size_t i = 0; i < picture.Layers.size(); ++i)
  {
    spec.channelnames[spec.nchannels - picture.Layers.size() + i] = picture.Layers[i];
  }
  if (spec.nchannels - picture.Layers.size() < 4)
  {
    spec.alpha_channel = -1;
  }
  spec.attribute("Software", "Penumbra");
  if (HoldsRadiance(path))
  {
    spec.attribute("compression", "zip");
  }
  const bool encoded = encoder && encoder->set_ioproxy(&memory) && encoder->open(path, spec) &&
    encoder->write_image(OIIO::TypeDesc::FLOAT, picture.Values.data()) && encoder->close();
  if (!encoded)
  {
    Fail("the output '{}' cannot be encoded ({})", path,
      encoder ? encoder->geterror() : OIIO::geterror());
  }
  WriteBytes(path, memory.buffer());
}

std::size_t RemoveNonFinite(Picture& picture)
{
  std::size_t bad = 0;
  for (std::size_t i = 0; i < picture.PixelCount(); ++i)
  {
    bool finite = true;
    for (int channel = 0; channel < picture.Channels; ++channel)
    {
      float& value = picture.Pixel(i)[channel];
      finite = finite && std::isfinite(value);
      value = std::isfinite(value) ? value : 0;
    }
    bad += finite ? 0 : 1;
  }
  return bad;
}
}
