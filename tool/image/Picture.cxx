// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "../scene/Failure.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace penumbra::tool
{
namespace
{
const std::vector<std::string> WrittenFormats = { ".png", ".exr", ".hdr", ".tif", ".tiff", ".jpg" };
constexpr int LargestSide = 65536; // beyond it a picture file is damaged, not big

std::string Extension(const std::string& path)
{
  std::string end = std::filesystem::path(path).extension();
  std::transform(
    end.begin(), end.end(), end.begin(), [](unsigned char c) { return std::tolower(c); });
  return end;
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
    Fail("the picture '{}' cannot be read: it is damaged or of an unknown format ({})", path,
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
  Picture picture(spec.width, spec.height, std::min(spec.nchannels, 4));
  if (!file->read_image(0, 0, 0, picture.Channels, OIIO::TypeDesc::FLOAT, picture.Values.data()))
  {
    Fail("the picture '{}' cannot be read to its end: it is damaged or cut off ({})", path,
      file->geterror());
  }
  return picture;
}

void RequireWritablePicture(const std::string& path)
{
  const std::string end = Extension(path);
  if (std::find(WrittenFormats.begin(), WrittenFormats.end(), end) == WrittenFormats.end())
  {
    FailUsage("the output '{}' has no picture format: end its name in one of {}", path,
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

void WritePicture(const std::string& path, const Picture& picture)
{
  const auto file = OIIO::ImageOutput::create(path);
  const OIIO::TypeDesc stored = HoldsRadiance(path) ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
  OIIO::ImageSpec spec(picture.Width, picture.Height, picture.Channels, stored);
  spec.attribute("Software", "Penumbra");
  if (HoldsRadiance(path))
  {
    spec.attribute("compression", "zip");
  }
  const bool written = file && file->open(path, spec) &&
    file->write_image(OIIO::TypeDesc::FLOAT, picture.Values.data()) && file->close();
  if (!written)
  {
    Fail(
      "the output '{}' cannot be written ({})", path, file ? file->geterror() : OIIO::geterror());
  }
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
