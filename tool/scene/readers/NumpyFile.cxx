// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/readers/NumpyFile.h"

#include "common/Failure.h"

#include <minizip/unzip.h>
#include <vtkByteSwap.h>
#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

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
/// Maximum size in bytes, enough for an elevation model of a continent in doubles. A larger size means a damaged header.
constexpr std::size_t LargestMember = std::size_t(1) << 32;

/// An array of VTK for an array-protocol type string of NumPy without its byte order; null if there is none.
vtkSmartPointer<vtkDataArray> MakeArray(const std::string& code)
{
  static const std::map<std::string, int> types = { { "i1", VTK_SIGNED_CHAR },
    { "u1", VTK_UNSIGNED_CHAR }, { "b1", VTK_UNSIGNED_CHAR }, { "i2", VTK_SHORT },
    { "u2", VTK_UNSIGNED_SHORT }, { "i4", VTK_INT }, { "u4", VTK_UNSIGNED_INT },
    { "i8", VTK_LONG_LONG }, { "u8", VTK_UNSIGNED_LONG_LONG }, { "f4", VTK_FLOAT },
    { "f8", VTK_DOUBLE } };
  const auto found = types.find(code);
  return vtk::TakeSmartPointer(
    found == types.end() ? nullptr : vtkDataArray::CreateDataArray(found->second));
}

/// Converts a two-dimensional array from Fortran order (first index fastest) to C order.
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
  const auto values = MakeArray(type[2]);
  if (!values)
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
  if (count > (bytes.size() - start) / values->GetDataTypeSize())
  {
    Fail("'{}' is cut off: an array in it needs more values than the file has", path);
  }
  values->SetNumberOfTuples(static_cast<vtkIdType>(count));
  std::memcpy(values->GetVoidPointer(0), bytes.data() + start, count * values->GetDataTypeSize());
  if (type[1] == ">")
  {
    vtkByteSwap::SwapVoidRange(values->GetVoidPointer(0), count, values->GetDataTypeSize());
  }
  array.Values.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    array.Values[i] = values->GetComponent(static_cast<vtkIdType>(i), 0);
  }
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
