// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/readers/Completeness.h"

#include "common/Failure.h"
#include "common/Names.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>
#include <vector>

namespace penumbra::tool
{
namespace
{
namespace fs = std::filesystem;

void RequireSize(const std::string& path, double needed, double present, const char* unit = "bytes")
{
  if (present < needed)
  {
    Fail(
      "'{}' is cut off: its header requires {:.0f} {} and it has {:.0f}; copy or download it again",
      path, needed, unit, present);
  }
}

double FileSize(const std::string& path)
{
  std::error_code error;
  const auto size = fs::file_size(path, error);
  return error ? 0 : static_cast<double>(size);
}

/// Size in bytes of a type: "uchar", "int16", "float".
double PlySize(const std::string& type)
{
  const auto has = [&type](const char* part) { return type.find(part) != std::string::npos; };
  return has("char") || has("int8") ? 1
    : has("short") || has("16")     ? 2
    : has("double") || has("64")    ? 8
                                    : 4;
}

/// Size in bytes of a classic netCDF file up to its last value, according to its header; 0 for other files. Follows "The
/// NetCDF Classic Format Specification" (Unidata 2011) and its names. Throws std::ios::failure if the header is truncated.
double ClassicNetcdfSize(std::istream& file)
{
  file.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
  const auto integer = [&file](int bytes) {
    double value = 0;
    for (; bytes > 0; --bytes)
    {
      value = value * 256 + file.get();
    }
    return value;
  };
  constexpr double magic = 0x434446; // "CDF"
  const double version = integer(3) == magic ? integer(1) : 0;
  if (version != 1 && version != 2 && version != 5)
  {
    return 0;
  }
  const int wide = version == 5 ? 8 : 4;
  const auto skip = [&file](double bytes) {
    const double padded = std::min(1e12, 4 * std::ceil(bytes / 4));
    file.seekg(static_cast<std::streamoff>(padded), std::ios::cur);
  };
  // A tag, a length, and elements that begin with a name.
  const auto forList = [&](const auto& read) {
    integer(4);
    for (double left = integer(wide); left > 0; --left)
    {
      skip(integer(wide));
      read();
    }
  };
  const auto skipAttributes = [&] {
    forList([&] {
      static constexpr double sizes[] = { 0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8 }; // by nc_type
      const auto type = static_cast<std::size_t>(integer(4));
      skip(integer(wide) * sizes[type < std::size(sizes) ? type : 0]);
    });
  };
  const double records = integer(wide);
  std::vector<bool> isRecord;
  forList([&] { isRecord.push_back(integer(wide) == 0); });
  skipAttributes();
  double end = 0, firstRecord = 0, recordSize = 0;
  forList([&] {
    const auto axes = static_cast<std::size_t>(integer(wide));
    bool record = false;
    for (std::size_t axis = 0; axis < axes; ++axis)
    {
      const auto dimension = static_cast<std::size_t>(integer(wide));
      record = record || (axis == 0 && dimension < isRecord.size() && isRecord[dimension]);
    }
    skipAttributes();
    integer(4); // nc_type
    const double size = integer(wide);
    const double begin = integer(version == 1 ? 4 : 8);
    if (record)
    {
      firstRecord = firstRecord > 0 ? std::min(firstRecord, begin) : begin;
      recordSize += size;
    }
    else if (constexpr double tooLarge = 4294967295.0;
             size != tooLarge) // stands for sizes that vsize cannot hold
    {
      end = std::max(end, begin + size);
    }
  });
  return std::max(end, firstRecord > 0 ? firstRecord + records * recordSize : 0) -
    3; // the last value may lack padding
}
}

void RequireCompleteXml(const std::string& path, vtkDataObject*)
{
  // VTK's parser stops where appended data begins, and does not detect missing values.
  std::ifstream file(path, std::ios::binary);
  const std::string end = "</VTKFile>";
  constexpr double searched = 4096;
  const double size = FileSize(path);
  file.seekg(static_cast<std::streamoff>(std::max(0.0, size - searched)));
  const std::string tail{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  if (file && size > 0 && tail.find(end) == std::string::npos)
  {
    Fail(
      "'{}' is damaged or cut off: it does not end with {}; copy or download it again", path, end);
  }
}

void RequireCompleteStl(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  char start[512] = {};
  file.read(start, sizeof(start));
  const bool text = std::strncmp(start, "solid", 5) == 0 && std::strstr(start, "facet") != nullptr;
  constexpr double header = 84, triangle = 50; // bytes
  std::uint32_t count = 0;
  std::memcpy(&count, start + 80, sizeof(count));
  RequireSize(path, text ? 0 : header + triangle * count, FileSize(path));
}

/// Counts bytes, or words in a text file. Lists have the lengths that VTK's reader found; the last one may be invented.
void RequireCompletePly(const std::string& path, vtkDataObject* data)
{
  auto* surface = vtkPolyData::SafeDownCast(data);
  std::ifstream file(path, std::ios::binary);
  bool binary = false;
  double count = 0, needed = 0;
  for (std::string line; std::getline(file, line) && Trim(line) != "end_header";)
  {
    std::istringstream words(line);
    std::string key, type, listed, name;
    words >> key >> type;
    if (key == "format")
    {
      binary = type != "ascii";
    }
    else if (key == "element")
    {
      words >> count;
    }
    else if (key == "property")
    {
      if (type == "list")
      {
        words >> type >> listed >> name; // the types of its length and of its values
      }
      needed += count * (binary ? PlySize(type) : 1);
      if (surface && name.rfind("vertex_ind", 0) == 0)
      {
        needed += static_cast<double>(surface->GetPolys()->GetNumberOfConnectivityIds()) *
          (binary ? PlySize(listed) : 1);
      }
    }
  }
  if (binary)
  {
    const double start = file ? static_cast<double>(file.tellg()) : 0;
    RequireSize(path, start + needed, FileSize(path));
    return;
  }
  using Words = std::istream_iterator<std::string>;
  RequireSize(path, needed, static_cast<double>(std::distance(Words(file), Words())), "numbers");
}

void RequireCompleteMetaImage(const std::string& path, vtkDataObject* data)
{
  auto* image = vtkImageData::SafeDownCast(data);
  vtkDataArray* values = image ? image->GetPointData()->GetScalars() : nullptr;
  std::ifstream file(path, std::ios::binary);
  std::string dataFile;
  bool compressed = false;
  for (std::string line; dataFile.empty() && std::getline(file, line);)
  {
    const auto equals = line.find('=');
    if (equals != std::string::npos)
    {
      const std::string key = Trim(line.substr(0, equals));
      const std::string value = Trim(line.substr(equals + 1));
      compressed = compressed || (key == "CompressedData" && value == "True");
      dataFile = key == "ElementDataFile" ? value : "";
    }
  }
  if (!values || dataFile.empty() || dataFile == "LIST" || dataFile.find('%') != std::string::npos)
  {
    return;
  }
  if (dataFile != "LOCAL" && dataFile != "Local" && dataFile != "local")
  {
    dataFile = (fs::path(path).parent_path() / dataFile).string();
    file = std::ifstream(dataFile, std::ios::binary);
    if (!file)
    {
      Fail("'{}' stores its values in '{}', which cannot be opened: copy that file too", path,
        dataFile);
    }
  }
  else
  {
    dataFile = path;
  }
  const auto start = static_cast<double>(file.tellg());
  // MET_LONG has four or eight bytes, depending on the system that wrote it.
  const int type = values->GetDataType();
  const bool either = type == VTK_LONG || type == VTK_UNSIGNED_LONG;
  const auto needed =
    static_cast<std::size_t>(values->GetDataSize()) * (either ? 4 : values->GetDataTypeSize());
  if (!compressed)
  {
    RequireSize(dataFile, start + static_cast<double>(needed), FileSize(dataFile));
  }
  if (!compressed || either)
  {
    return;
  }
  const std::string packed{ std::istreambuf_iterator<char>(file), {} };
  std::vector<unsigned char> unpacked(needed);
  vtkNew<vtkZLibDataCompressor> zlib; // reports damage as errors of VTK
  zlib->Uncompress(
    reinterpret_cast<const unsigned char*>(packed.data()), packed.size(), unpacked.data(), needed);
}

/// United States Geological Survey 1998, Standards for Digital Elevation Models, part 2: columns 859 to 864 of a record of
/// 1024 bytes hold the number of profiles that follow.
void RequireCompleteDem(const std::string& path)
{
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
    std::fopen(path.c_str(), "rb"), std::fclose);
  std::array<char, 1025> header = {};
  const std::size_t length = file ? std::fread(header.data(), 1, header.size() - 1, file.get()) : 0;
  RequireSize(path, header.size() - 1, static_cast<double>(length));
  const int profiles = std::atoi(std::string(header.data() + 858, 6).c_str());
  for (int profile = 1; profile <= profiles; ++profile)
  {
    int row = 0, column = 0, rows = 0, columns = 0, elevation = 0;
    std::array<char, 120> plan = {};
    bool whole = std::fscanf(file.get(), "%6d%6d%6d%6d", &row, &column, &rows, &columns) == 4 &&
      std::fread(plan.data(), 1, plan.size(), file.get()) == plan.size();
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

void RequireCompleteNetcdf(const std::string& path)
{
  try
  {
    std::ifstream file(path, std::ios::binary);
    RequireSize(path, ClassicNetcdfSize(file), FileSize(path));
  }
  catch (const std::ios::failure&)
  {
    // The library reports what is missing in a header.
  }
}
}
