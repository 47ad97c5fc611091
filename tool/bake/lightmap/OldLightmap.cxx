// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/LightmapFile.h"

#include "common/Failure.h"

#include <OpenImageIO/hash.h>
#include <OpenImageIO/imageio.h>

#include <glm/gtc/packing.hpp>

#include <array>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string_view>

namespace penumbra::lightmap
{
namespace
{
using tool::Fail;
using Names = std::vector<std::string>;

Names LightChannels(const OIIO::ImageSpec& spec)
{
  Names names;
  for (const std::string layer : { "", "moment-x.", "moment-y.", "moment-z.", "lamps.",
         "lamps-moment-x.", "lamps-moment-y.", "lamps-moment-z.", "first." })
  {
    for (const char* color : { "R", "G", "B" })
    {
      if (spec.channelindex(layer + color) >= 0)
      {
        names.push_back(layer + color);
      }
    }
  }
  return names;
}

/// Values of a part of the file, interleaved with the given order of channels. Empty if it cannot be read.
template <typename Value>
std::vector<Value> ReadPart(
  OIIO::ImageInput& input, int number, OIIO::TypeDesc type, const Names& channels)
{
  const OIIO::ImageSpec spec = input.spec(number);
  constexpr int largest = 65536;
  if (spec.format != type || spec.width > largest || spec.height > largest ||
    spec.nchannels != static_cast<int>(channels.size()))
  {
    return {};
  }
  std::vector<Value> values(spec.image_pixels() * channels.size());
  for (std::size_t c = 0; c < channels.size(); ++c)
  {
    const int at = spec.channelindex(channels[c]);
    const auto stride = static_cast<OIIO::stride_t>(channels.size() * sizeof(Value));
    if (at < 0 || !input.read_image(number, 0, at, at + 1, type, &values[c], stride))
    {
      return {};
    }
  }
  return values;
}

void SetLight(const std::vector<std::uint16_t>& halves, Lightmap& map)
{
  const std::uint16_t* from = halves.data();
  for (std::size_t i = 0; i < std::size_t(map.Baked.Width) * map.Baked.Height; ++i)
  {
    for (Light* light : { &map.Baked, &map.Direct, &map.First })
    {
      for (int c = 0; c < light->Channels; ++c)
      {
        light->Pixel(i)[c] = glm::unpackHalf1x16(*from++);
      }
    }
  }
}
}

bool IsOpenExr(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::array<char, 4> magic{};
  file.read(magic.data(), magic.size());
  return std::string_view(magic.data(), magic.size()) == "\x76\x2f\x31\x01";
}

Lightmap ReadOldLightmap(const std::string& path)
{
  auto input = OIIO::ImageInput::open(path);
  OIIO::geterror();
  if (!input || input->spec().get_string_attribute("penumbra:kind") != "lightmap 1")
  {
    Fail("'{}' is an OpenEXR file that holds no baked light, or is damaged: give a file written by "
         "penumbra bake lightmap",
      path);
  }
  const OIIO::ImageSpec spec = input->spec();
  const std::string text(spec.get_string_attribute("penumbra:bake"));
  const Names channels = LightChannels(spec);
  const auto light = ReadPart<std::uint16_t>(*input, 0, OIIO::TypeDesc::HALF, channels);
  const auto points = ReadPart<float>(
    *input, 1, OIIO::TypeDesc::FLOAT, { "x", "y", "z", "u", "v", "nx", "ny", "nz" });
  const auto triangles =
    ReadPart<std::uint32_t>(*input, 2, OIIO::TypeDesc::UINT32, { "a", "b", "c" });
  const auto patches = ReadPart<std::uint32_t>(
    *input, 3, OIIO::TypeDesc::UINT32, { "x", "y", "width", "height", "high", "low" });
  input->geterror();
  OIIO::SHA1 sum(text.data(), text.size());
  const auto add = [&sum](
                     const auto& part) { sum.append(part.data(), part.size() * sizeof(part[0])); };
  add(light);
  add(points);
  add(triangles);
  add(patches);
  Lightmap map;
  const int each = spec.channelindex("moment-x.R") >= 0 ? 12 : 3;
  map.Baked = Light(spec.width, spec.height, each);
  map.Direct = Light(spec.width, spec.height, spec.channelindex("lamps.R") >= 0 ? each : 0);
  map.First = Light(spec.width, spec.height, 3);
  std::istringstream head(text);
  Vec3 origin(0.0);
  std::size_t counts[3] = {}; // other pixels of a table are unused
  head >> origin.x >> origin.y >> origin.z >> counts[0] >> counts[1] >> counts[2];
  head.ignore(1);
  std::getline(head, map.Made);
  std::getline(head, map.Settings);
  map.Scene.assign(std::istreambuf_iterator<char>(head), {});
  const std::size_t values =
    map.Baked.Values.size() + map.Direct.Values.size() + map.First.Values.size();
  if (sum.digest() != spec.get_string_attribute("penumbra:checksum") || light.size() != values ||
    counts[0] > points.size() / 8 || counts[1] > triangles.size() / 3 ||
    counts[2] > patches.size() / 6)
  {
    Fail("the lightmap '{}' is damaged: its checksum does not match; bake it again", path);
  }
  SetLight(light, map);
  for (const float* p = points.data(); map.Points.size() < counts[0]; p += 8)
  {
    map.Points.push_back(origin + Vec3(p[0], p[1], p[2]));
    map.TextureCoordinates.emplace_back(p[3], p[4]);
    map.Normals.emplace_back(p[5], p[6], p[7]);
  }
  for (const std::uint32_t* t = triangles.data(); map.Triangles.size() < counts[1]; t += 3)
  {
    map.Triangles.emplace_back(t[0], t[1], t[2]);
  }
  for (const std::uint32_t* p = patches.data(); map.Patches.size() < counts[2]; p += 6)
  {
    map.Patches.push_back({ { p[0], p[1] }, { p[2], p[3] }, std::uint64_t(p[4]) << 32 | p[5] });
  }
  return map;
}
}
