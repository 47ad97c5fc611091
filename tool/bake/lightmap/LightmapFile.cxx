// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/LightmapFile.h"

#include "common/Failure.h"

#include <OpenImageIO/hash.h>
#include <OpenImageIO/imageio.h>

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>

namespace penumbra::lightmap
{
namespace
{
using tool::Fail;
namespace fs = std::filesystem;

constexpr const char* Kind = "penumbra:kind";
constexpr const char* ThisKind = "lightmap 1";
constexpr int TableWidth = 1024; // of parts that hold tables, a row of the table in each pixel

/// A part of the file: channels of one type, all of its pixels as bytes.
struct Part
{
  std::string Name;
  OIIO::TypeDesc Type;
  std::vector<std::string> Channels;
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Bytes;

  std::size_t PixelBytes() const { return this->Type.size() * this->Channels.size(); }
};

const std::vector<std::string> PointChannels = { "x", "y", "z", "u", "v", "nx", "ny", "nz" };
const std::vector<std::string> TriangleChannels = { "a", "b", "c" };
const std::vector<std::string> PatchChannels = { "x", "y", "width", "height", "high", "low" };

/// What a file holds of light.
struct Kinds
{
  bool Directional = false;
  bool Lamps = false;

  int Each() const { return this->Directional ? 12 : 3; } ///< channels of one kind
};

void AddChannels(std::vector<std::string>& names, const std::string& layer)
{
  for (const char* color : { "R", "G", "B" })
  {
    names.push_back(layer.empty() ? color : layer + "." + color);
  }
}

std::vector<std::string> LightChannels(const Kinds& kinds)
{
  std::vector<std::string> names;
  for (const std::string of : { "", "lamps" })
  {
    if (of.empty() || kinds.Lamps)
    {
      AddChannels(names, of);
      for (const char* axis : { "x", "y", "z" })
      {
        if (kinds.Directional)
        {
          AddChannels(names, (of.empty() ? "moment-" : of + "-moment-") + std::string(axis));
        }
      }
    }
  }
  AddChannels(names, "first");
  return names;
}

Kinds FindKinds(const OIIO::ImageSpec& spec)
{
  const auto& names = spec.channelnames;
  const auto has = [&names](const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  return { has("moment-x.R"), has("lamps.R") };
}

/// Lights whose channels lie beside one another in a file's picture.
template <typename Map>
auto LightsOf(Map& lightmap)
{
  return std::array{ &lightmap.Baked, &lightmap.Lamps, &lightmap.First };
}

Part LightPart(const Lightmap& lightmap)
{
  const Light& baked = lightmap.Baked;
  const Kinds kinds{ baked.Channels > 3, lightmap.Lamps.Channels > 0 };
  Part part{ "light", OIIO::TypeDesc::HALF, LightChannels(kinds), baked.Width, baked.Height, {} };
  const std::size_t pixels = std::size_t(baked.Width) * baked.Height;
  const std::size_t channels = part.Channels.size();
  std::vector<std::uint16_t> values(pixels * channels);
  constexpr float largest = 65504.0f; // of half floats
  for (std::size_t i = 0; i < pixels; ++i)
  {
    std::uint16_t* to = &values[i * channels];
    for (const Light* light : LightsOf(lightmap))
    {
      for (int c = 0; c < light->Channels; ++c)
      {
        *to++ = glm::packHalf1x16(glm::clamp(light->At(i)[c], -largest, largest));
      }
    }
  }
  part.Bytes.resize(values.size() * sizeof(values[0]));
  std::memcpy(part.Bytes.data(), values.data(), part.Bytes.size());
  return part;
}

template <typename Value>
Part Table(const char* name, OIIO::TypeDesc type, const std::vector<std::string>& channels,
  const std::vector<Value>& values)
{
  Part part{ name, type, channels, TableWidth, 0, {} };
  const std::size_t rows = values.size() / channels.size();
  part.Height = std::max(1, static_cast<int>((rows + TableWidth - 1) / TableWidth));
  part.Bytes.assign(part.PixelBytes() * TableWidth * part.Height, 0);
  std::memcpy(part.Bytes.data(), values.data(), values.size() * sizeof(Value));
  return part;
}

std::vector<Part> MakeParts(const Lightmap& lightmap)
{
  std::vector<float> points;
  for (std::size_t i = 0; i < lightmap.Points.size(); ++i)
  {
    const glm::vec3& p = lightmap.Points[i];
    const glm::vec3& n = lightmap.Normals[i];
    const glm::vec2& uv = lightmap.Places[i];
    points.insert(points.end(), { p.x, p.y, p.z, uv.x, uv.y, n.x, n.y, n.z });
  }
  std::vector<std::uint32_t> triangles;
  for (const glm::uvec3& t : lightmap.Triangles)
  {
    triangles.insert(triangles.end(), { t.x, t.y, t.z });
  }
  std::vector<std::uint32_t> patches;
  for (const Patch& p : lightmap.Patches)
  {
    patches.insert(patches.end(),
      { std::uint32_t(p.At.x), std::uint32_t(p.At.y), std::uint32_t(p.Texels.x),
        std::uint32_t(p.Texels.y), std::uint32_t(p.Key >> 32), std::uint32_t(p.Key) });
  }
  return { LightPart(lightmap), Table("points", OIIO::TypeDesc::FLOAT, PointChannels, points),
    Table("triangles", OIIO::TypeDesc::UINT32, TriangleChannels, triangles),
    Table("patches", OIIO::TypeDesc::UINT32, PatchChannels, patches) };
}

std::string Checksum(const std::vector<Part>& parts, const std::string& text)
{
  OIIO::SHA1 sum(text.data(), text.size());
  for (const Part& part : parts)
  {
    sum.append(part.Bytes.data(), part.Bytes.size());
  }
  return sum.digest();
}

/// All that is not pixels, in one text.
std::string HeadText(const Lightmap& lightmap)
{
  return fmt::format("{:.17g} {:.17g} {:.17g} {} {} {}\n{}\n{}\n{}", lightmap.Origin.x,
    lightmap.Origin.y, lightmap.Origin.z, lightmap.Points.size(), lightmap.Triangles.size(),
    lightmap.Patches.size(), lightmap.Made, lightmap.Settings, lightmap.Scene);
}

void ReadHead(Lightmap& lightmap, const std::string& text, std::size_t counts[3])
{
  std::istringstream head(text);
  head >> lightmap.Origin.x >> lightmap.Origin.y >> lightmap.Origin.z >> counts[0] >> counts[1] >>
    counts[2];
  head.ignore(1);
  std::getline(head, lightmap.Made);
  std::getline(head, lightmap.Settings);
  lightmap.Scene.assign(std::istreambuf_iterator<char>(head), {});
}

// All parts of a file have the same display window.
OIIO::ImageSpec SpecOf(const Part& part, const Part& shown)
{
  OIIO::ImageSpec spec(part.Width, part.Height, static_cast<int>(part.Channels.size()), part.Type);
  spec.channelnames = part.Channels;
  spec.full_width = shown.Width;
  spec.full_height = shown.Height;
  spec.attribute("compression", "zip");
  spec.attribute("oiio:subimagename", part.Name);
  return spec;
}

/// The part's pixels with their channels in this order: OpenEXR keeps an order of its own. Without bytes where it
/// cannot be read or has other channels.
Part ReadPart(OIIO::ImageInput& input, int number, const std::vector<std::string>& channels)
{
  const OIIO::ImageSpec spec = input.spec(number);
  Part part{ "", spec.format, channels, spec.width, spec.height, {} };
  constexpr int largest = 65536;
  if (spec.width < 1 || spec.height < 1 || spec.width > largest || spec.height > largest ||
    spec.depth > 1 || !spec.channelformats.empty() ||
    spec.nchannels != static_cast<int>(channels.size()))
  {
    return part;
  }
  const std::size_t size = spec.format.size();
  std::vector<unsigned char> stored(part.PixelBytes() * spec.width * spec.height);
  if (!input.read_image(number, 0, 0, spec.nchannels, spec.format, stored.data()))
  {
    return part;
  }
  part.Bytes.resize(stored.size());
  for (std::size_t c = 0; c < channels.size(); ++c)
  {
    const auto found = std::find(spec.channelnames.begin(), spec.channelnames.end(), channels[c]);
    if (found == spec.channelnames.end())
    {
      part.Bytes.clear();
      return part;
    }
    const auto from = static_cast<std::size_t>(found - spec.channelnames.begin());
    for (std::size_t at = 0; at < stored.size(); at += part.PixelBytes())
    {
      std::memcpy(&part.Bytes[at + c * size], &stored[at + from * size], size);
    }
  }
  return part;
}

template <typename Value>
std::vector<Value> ValuesOf(const Part& part, std::size_t rows)
{
  std::vector<Value> values(rows * part.Channels.size());
  if (values.size() * sizeof(Value) > part.Bytes.size())
  {
    return {};
  }
  std::memcpy(values.data(), part.Bytes.data(), values.size() * sizeof(Value));
  return values;
}

void TakeLight(const Part& part, const Kinds& kinds, Lightmap& lightmap)
{
  lightmap.Baked = Light(part.Width, part.Height, kinds.Each());
  lightmap.Lamps = Light(part.Width, part.Height, kinds.Lamps ? kinds.Each() : 0);
  lightmap.First = Light(part.Width, part.Height, 3);
  const std::size_t pixels = std::size_t(part.Width) * part.Height;
  const auto values = ValuesOf<std::uint16_t>(part, pixels);
  for (std::size_t i = 0; i < pixels; ++i)
  {
    const std::uint16_t* from = &values[i * part.Channels.size()];
    for (Light* light : LightsOf(lightmap))
    {
      for (int c = 0; c < light->Channels; ++c)
      {
        light->At(i)[c] = glm::unpackHalf1x16(*from++);
      }
    }
  }
}

void TakeTables(const std::vector<Part>& parts, const std::size_t counts[3], Lightmap& lightmap)
{
  const auto points = ValuesOf<float>(parts[1], counts[0]);
  for (std::size_t i = 0; i + 7 < points.size(); i += 8)
  {
    lightmap.Points.emplace_back(points[i], points[i + 1], points[i + 2]);
    lightmap.Places.emplace_back(points[i + 3], points[i + 4]);
    lightmap.Normals.emplace_back(points[i + 5], points[i + 6], points[i + 7]);
  }
  const auto triangles = ValuesOf<std::uint32_t>(parts[2], counts[1]);
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
  {
    lightmap.Triangles.emplace_back(triangles[i], triangles[i + 1], triangles[i + 2]);
  }
  const auto patches = ValuesOf<std::uint32_t>(parts[3], counts[2]);
  for (std::size_t i = 0; i + 5 < patches.size(); i += 6)
  {
    lightmap.Patches.push_back({ { patches[i], patches[i + 1] }, { patches[i + 2], patches[i + 3] },
      std::uint64_t(patches[i + 4]) << 32 | patches[i + 5] });
  }
}
}

void WriteLightmap(const std::string& path, const Lightmap& lightmap)
{
  const std::vector<Part> parts = MakeParts(lightmap);
  std::vector<OIIO::ImageSpec> specs;
  for (const Part& part : parts)
  {
    specs.push_back(SpecOf(part, parts.front()));
  }
  const std::string head = HeadText(lightmap);
  specs.front().attribute(Kind, ThisKind);
  specs.front().attribute("penumbra:bake", head);
  specs.front().attribute("penumbra:checksum", Checksum(parts, head));
  specs.front().attribute("Software", "Penumbra");
  // The writer is chosen by the name's end.
  const std::string partial = path + ".part.exr";
  auto output = OIIO::ImageOutput::create(partial);
  bool written = output && output->open(partial, static_cast<int>(specs.size()), specs.data());
  for (std::size_t i = 0; i < parts.size() && written; ++i)
  {
    written = (i == 0 || output->open(partial, specs[i], OIIO::ImageOutput::AppendSubimage)) &&
      output->write_image(parts[i].Type, parts[i].Bytes.data());
  }
  written = output && output->close() && written;
  std::error_code error;
  if (written)
  {
    fs::rename(partial, path, error);
  }
  if (!written || error)
  {
    const std::string reason = error ? error.message() : output ? output->geterror() : "";
    fs::remove(partial, error);
    Fail("'{}' cannot be written: make room on the disk, or choose another file with -o ({})", path,
      reason);
  }
}

bool IsLightmap(const std::string& path)
{
  auto input = OIIO::ImageInput::open(path);
  const bool is =
    input && std::string(input->spec().get_string_attribute(Kind)).rfind("lightmap", 0) == 0;
  OIIO::geterror(); // that it is none is no error
  return is;
}

Lightmap ReadLightmap(const std::string& path)
{
  std::error_code error;
  if (!fs::is_regular_file(path, error))
  {
    Fail("the lightmap '{}' does not exist: bake it with penumbra bake lightmap", path);
  }
  auto input = OIIO::ImageInput::open(path);
  if (!input)
  {
    OIIO::geterror();
    Fail("'{}' is not a lightmap, or damaged beyond reading: bake it with penumbra bake lightmap",
      path);
  }
  const std::string kind(input->spec().get_string_attribute(Kind));
  if (kind.rfind("lightmap", 0) != 0)
  {
    Fail(
      "'{}' is a picture but not a lightmap: give a file that penumbra bake lightmap wrote", path);
  }
  if (kind != ThisKind)
  {
    Fail("'{}' is of another version of Penumbra ({}, and this one reads {}): bake it again", path,
      kind, ThisKind);
  }
  const std::string head(input->spec().get_string_attribute("penumbra:bake"));
  const std::string sum(input->spec().get_string_attribute("penumbra:checksum"));
  const Kinds kinds = FindKinds(input->spec());
  const std::vector<std::vector<std::string>> channels = { LightChannels(kinds), PointChannels,
    TriangleChannels, PatchChannels };
  std::vector<Part> parts;
  for (std::size_t i = 0; i < channels.size() && input->seek_subimage(static_cast<int>(i), 0); ++i)
  {
    parts.push_back(ReadPart(*input, static_cast<int>(i), channels[i]));
  }
  input->geterror();
  Lightmap lightmap;
  std::size_t counts[3] = {};
  ReadHead(lightmap, head, counts);
  const bool whole = parts.size() == channels.size() && Checksum(parts, head) == sum;
  if (!whole || parts[0].Type != OIIO::TypeDesc::HALF)
  {
    Fail("the lightmap '{}' is damaged: its checksum does not fit; bake it again", path);
  }
  TakeLight(parts[0], kinds, lightmap);
  TakeTables(parts, counts, lightmap);
  return lightmap;
}
}
