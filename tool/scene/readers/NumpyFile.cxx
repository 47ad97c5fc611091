// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/readers/NumpyFile.h"

#include "common/Failure.h"

#include <minizip/unzip.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <regex>

namespace penumbra::tool
{
namespace
{
/// An elevation model of a continent in doubles; beyond it a header is damaged.
constexpr std::size_t LargestMember = std::size_t(1) << 32;

template <typename Stored>
std::vector<double> Convert(const char* bytes, std::size_t count, bool swap)
{
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    char raw[sizeof(Stored)];
    std::memcpy(raw, bytes + i * sizeof(Stored), sizeof(Stored));
    if (swap)
    {
      std::reverse(raw, raw + sizeof(Stored));
    }
    Stored value;
    std::memcpy(&value, raw, sizeof(Stored));
    values[i] = static_cast<double>(value);
  }
  return values;
}

using Converter = std::vector<double> (*)(const char*, std::size_t, bool);
struct ElementType
{
  std::size_t Size;
  Converter ToDouble;
};

/// NumPy's array-protocol type strings, without the byte order.
std::optional<ElementType> FindElementType(const std::string& code)
{
  static const std::map<std::string, ElementType> types = {
    { "i1", { 1, Convert<std::int8_t> } },
    { "u1", { 1, Convert<std::uint8_t> } },
    { "i2", { 2, Convert<std::int16_t> } },
    { "u2", { 2, Convert<std::uint16_t> } },
    { "i4", { 4, Convert<std::int32_t> } },
    { "u4", { 4, Convert<std::uint32_t> } },
    { "i8", { 8, Convert<std::int64_t> } },
    { "u8", { 8, Convert<std::uint64_t> } },
    { "f4", { 4, Convert<float> } },
    { "f8", { 8, Convert<double> } },
    { "b1", { 1, Convert<std::uint8_t> } },
  };
  const auto found = types.find(code);
  return found == types.end() ? std::nullopt : std::optional<ElementType>(found->second);
}

/// Brings an array in Fortran order (first index fastest) into C order; two axes suffice here.
void TransposeFromFortran(NumpyArray& array)
{
  if (array.Shape.size() != 2)
  {
    return;
  }
  const std::size_t rows = array.Shape[0], columns = array.Shape[1];
  std::vector<double> ordered(array.Values.size());
  for (std::size_t i = 0; i < ordered.size(); ++i)
  {
    ordered[(i % rows) * columns + i / rows] = array.Values[i];
  }
  array.Values.swap(ordered);
}

/// The .npy format, versions 1 to 3: magic, header length, a Python dictionary, the values.
std::optional<NumpyArray> ParseArray(const std::string& bytes, const std::string& path)
{
  const bool isArray = bytes.size() >= 12 && bytes.compare(0, 6, "\x93NUMPY") == 0;
  const std::size_t lengthBytes = isArray && bytes[6] >= 2 ? 4 : 2;
  std::size_t header = 0;
  for (std::size_t i = 0; isArray && i < lengthBytes; ++i)
  {
    header |= std::size_t(static_cast<unsigned char>(bytes[8 + i])) << (8 * i);
  }
  const std::size_t start = 8 + lengthBytes + header;
  constexpr std::size_t longestHeader = 65536;
  if (!isArray || header > longestHeader || start > bytes.size())
  {
    Fail("'{}' is damaged: an array in it has no NumPy header", path);
  }
  const std::string text = bytes.substr(8 + lengthBytes, header);
  static const std::regex typePattern("'descr': *'([<>|=])([a-zA-Z]\\d+)'");
  static const std::regex orderPattern("'fortran_order': *(True|False)");
  static const std::regex shapePattern("'shape': *\\(([0-9, ]*)\\)");
  std::smatch type, order, shape;
  if (!std::regex_search(text, type, typePattern) ||
    !std::regex_search(text, order, orderPattern) || !std::regex_search(text, shape, shapePattern))
  {
    return std::nullopt;
  }
  const auto element = FindElementType(type[2]);
  if (!element)
  {
    return std::nullopt;
  }
  NumpyArray array;
  std::size_t count = 1;
  const std::string axes = shape[1];
  static const std::regex number("\\d{1,12}");
  for (std::sregex_iterator axis(axes.begin(), axes.end(), number), end; axis != end; ++axis)
  {
    array.Shape.push_back(std::stoull(axis->str()));
    const bool fits = array.Shape.back() == 0 || count <= LargestMember / array.Shape.back();
    count = fits ? count * array.Shape.back() : LargestMember;
  }
  if (count > (bytes.size() - start) / element->Size)
  {
    Fail("'{}' is cut off: an array in it needs more values than the file has", path);
  }
  array.Values = element->ToDouble(bytes.data() + start, count, type[1] == ">");
  if (order[1] == "True")
  {
    TransposeFromFortran(array);
  }
  return array;
}

std::map<std::string, NumpyArray> ReadArchive(const std::string& path)
{
  const std::unique_ptr<void, int (*)(unzFile)> zip(unzOpen64(path.c_str()), unzClose);
  if (!zip)
  {
    Fail("'{}' is damaged or cut off: it is no zip archive, as .npz files are", path);
  }
  std::map<std::string, NumpyArray> arrays;
  for (int state = unzGoToFirstFile(zip.get()); state == UNZ_OK; state = unzGoToNextFile(zip.get()))
  {
    char name[256] = {};
    unz_file_info64 info = {};
    unzGetCurrentFileInfo64(zip.get(), &info, name, sizeof(name) - 1, nullptr, 0, nullptr, 0);
    std::string bytes;
    bool whole = info.uncompressed_size <= LargestMember && unzOpenCurrentFile(zip.get()) == UNZ_OK;
    constexpr std::size_t piece = 1 << 20;
    for (int got = 1; whole && got > 0;)
    {
      const std::size_t had = bytes.size();
      bytes.resize(had + piece);
      got = unzReadCurrentFile(zip.get(), &bytes[had], piece);
      bytes.resize(had + std::max(got, 0));
      whole = got >= 0 && bytes.size() <= LargestMember;
    }
    if (!whole || unzCloseCurrentFile(zip.get()) != UNZ_OK)
    {
      Fail("'{}' is damaged: '{}' in it cannot be unpacked", path, name);
    }
    if (const auto array = ParseArray(bytes, path))
    {
      arrays[std::regex_replace(std::string(name), std::regex("\\.npy$"), "")] = *array;
    }
  }
  return arrays;
}
}

std::map<std::string, NumpyArray> ReadNumpyFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  if (static_cast<char>(file.get()) != '\x93')
  {
    return ReadArchive(path);
  }
  file.seekg(0);
  const std::string bytes{ std::istreambuf_iterator<char>(file), {} };
  std::map<std::string, NumpyArray> arrays;
  if (const auto array = ParseArray(bytes, path))
  {
    arrays[""] = *array;
  }
  return arrays;
}
}
