// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/readers/Completeness.h"
#include "scene/readers/CompletenessTools.h"

#include <zlib.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <vector>

namespace penumbra::tool
{
namespace
{
/// Inflates all that follows and throws it away; true where it ends properly with enough bytes.
bool InflatesTo(std::istream& file, double wanted)
{
  z_stream stream = {};
  constexpr int zlibOrGzip = 15 + 32;
  if (inflateInit2(&stream, zlibOrGzip) != Z_OK)
  {
    return false;
  }
  std::vector<unsigned char> in(1 << 18), out(1 << 20);
  int state = Z_OK;
  while (state == Z_OK)
  {
    file.read(reinterpret_cast<char*>(in.data()), static_cast<std::streamsize>(in.size()));
    stream.next_in = in.data();
    stream.avail_in = static_cast<uInt>(file.gcount());
    if (stream.avail_in == 0)
    {
      break;
    }
    do
    {
      stream.next_out = out.data();
      stream.avail_out = static_cast<uInt>(out.size());
      state = inflate(&stream, Z_NO_FLUSH);
    } while (state == Z_OK && stream.avail_out == 0);
  }
  const double produced = static_cast<double>(stream.total_out);
  inflateEnd(&stream);
  return state == Z_STREAM_END && produced >= wanted;
}

/// The keys up to ElementDataFile, after which a MetaImage's own data begins.
std::map<std::string, std::string> ReadMetaHeader(std::istream& file)
{
  std::map<std::string, std::string> keys;
  std::string line;
  constexpr int longest = 1000;
  for (int i = 0; i < longest && !keys.count("ElementDataFile") && std::getline(file, line); ++i)
  {
    const auto equals = line.find('=');
    if (equals != std::string::npos)
    {
      keys[Trimmed(line.substr(0, equals))] = Trimmed(line.substr(equals + 1));
    }
  }
  return keys;
}

double MetaDataSize(std::map<std::string, std::string>& keys)
{
  static const std::map<std::string, double> sizes = { { "MET_CHAR", 1 }, { "MET_UCHAR", 1 },
    { "MET_SHORT", 2 }, { "MET_USHORT", 2 }, { "MET_INT", 4 }, { "MET_UINT", 4 }, { "MET_LONG", 4 },
    { "MET_ULONG", 4 }, { "MET_LONG_LONG", 8 }, { "MET_ULONG_LONG", 8 }, { "MET_FLOAT", 4 },
    { "MET_DOUBLE", 8 } };
  const auto type = sizes.find(keys["ElementType"]);
  double bytes = type == sizes.end() ? 0 : type->second;
  std::istringstream dimensions(keys["DimSize"]);
  for (double n; dimensions >> n;)
  {
    bytes *= n;
  }
  const std::string channels = keys["ElementNumberOfChannels"];
  return channels.empty() ? bytes : bytes * std::strtod(channels.c_str(), nullptr);
}

double NrrdDataSize(std::map<std::string, std::string>& keys)
{
  static const std::vector<std::pair<std::string, double>> sizes = { { "char", 1 }, { "int8", 1 },
    { "short", 2 }, { "int16", 2 }, { "long long", 8 }, { "longlong", 8 }, { "int64", 8 },
    { "int", 4 }, { "float", 4 }, { "double", 8 } };
  double bytes = 0;
  for (const auto& [name, size] : sizes)
  {
    // "unsigned short", "ushort", "int16_t": the first of these names that occurs.
    bytes = bytes == 0 && keys["type"].find(name) != std::string::npos ? size : bytes;
  }
  std::istringstream dimensions(keys["sizes"]);
  for (double n; dimensions >> n;)
  {
    bytes *= n;
  }
  return bytes;
}
}

void RequireCompleteMetaImage(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::map<std::string, std::string> keys = ReadMetaHeader(file);
  const std::string dataFile = keys["ElementDataFile"];
  const bool listed = dataFile == "LIST" || dataFile.find('%') != std::string::npos;
  if (dataFile.empty() || listed)
  {
    return;
  }
  const bool local = dataFile == "LOCAL" || dataFile == "Local" || dataFile == "local";
  const std::string data =
    local ? path : (std::filesystem::path(path).parent_path() / dataFile).string();
  if (!std::filesystem::exists(data))
  {
    Fail("'{}' keeps its values in '{}', which does not exist: put it beside it", path, data);
  }
  const double needed = MetaDataSize(keys);
  const double start = local ? static_cast<double>(file.tellg()) : 0;
  std::ifstream values(data, std::ios::binary);
  values.seekg(static_cast<std::streamoff>(start));
  const bool compressed = keys["CompressedData"] == "True";
  if (compressed && !InflatesTo(values, needed))
  {
    Fail("'{}' is damaged or cut off: its values cannot be decompressed to {:.0f} bytes", data,
      needed);
  }
  if (!compressed && FileSize(data) - start < needed)
  {
    FailShort(data, start + needed, FileSize(data));
  }
}

void RequireCompleteNrrd(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::map<std::string, std::string> keys;
  std::string line;
  bool ended = false;
  constexpr int longest = 1000;
  for (int i = 0; i < longest && !ended && std::getline(file, line); ++i)
  {
    const std::string text = Trimmed(line);
    const auto colon = text.find(':');
    ended = text.empty();
    if (colon != std::string::npos && text[0] != '#')
    {
      keys[text.substr(0, colon)] = Trimmed(text.substr(colon + 1));
    }
  }
  const bool detached = keys.count("data file") + keys.count("datafile") > 0;
  if (!keys.count("sizes") || !keys.count("type") || (!ended && !detached))
  {
    Fail("'{}' is damaged or cut off: its header has no {}", path,
      !keys.count("sizes") ? "sizes" : (!keys.count("type") ? "type" : "end"));
  }
  if (detached)
  {
    return;
  }
  const double needed = NrrdDataSize(keys);
  const double start = static_cast<double>(file.tellg());
  const std::string encoding = keys["encoding"];
  if ((encoding == "gzip" || encoding == "gz") && !InflatesTo(file, needed))
  {
    Fail("'{}' is damaged or cut off: its values cannot be decompressed to {:.0f} bytes", path,
      needed);
  }
  if (encoding == "raw" && FileSize(path) - start < needed)
  {
    FailShort(path, start + needed, FileSize(path));
  }
}

/// United States Geological Survey 1998, Standards for Digital Elevation Models, part 2: a record of
/// 1024 bytes says in its columns 859 to 864 how many profiles follow.
void RequireCompleteDem(const std::string& path)
{
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
    std::fopen(path.c_str(), "rb"), std::fclose);
  std::array<char, 1025> header = {};
  const std::size_t length = file ? std::fread(header.data(), 1, header.size() - 1, file.get()) : 0;
  if (length < header.size() - 1)
  {
    FailShort(path, static_cast<double>(header.size() - 1), static_cast<double>(length));
  }
  const int profiles = std::atoi(std::string(header.data() + 858, 6).c_str());
  for (int profile = 1; profile <= profiles; ++profile)
  {
    int row = 0, column = 0, rows = 0, columns = 0;
    std::array<char, 120> plan = {};
    bool whole = std::fscanf(file.get(), "%6d%6d%6d%6d", &row, &column, &rows, &columns) == 4 &&
      std::fread(plan.data(), 1, plan.size(), file.get()) == plan.size();
    int elevation = 0;
    for (int i = 0; whole && i < rows; ++i)
    {
      whole = std::fscanf(file.get(), "%6d", &elevation) == 1;
    }
    if (!whole || row < 1 || column < 1 || column > profiles)
    {
      Fail("'{}' is damaged or cut off in profile {} of {}: copy or download it again", path,
        profile, profiles);
    }
  }
}
}
