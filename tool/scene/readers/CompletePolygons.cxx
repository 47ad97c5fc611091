// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/readers/Completeness.h"
#include "scene/readers/CompletenessTools.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

namespace penumbra::tool
{
namespace
{
/// Bytes of a scalar by its name in PLY files; 0 for a name there is not.
std::size_t PlyTypeSize(const std::string& name)
{
  static const std::map<std::string, std::size_t> sizes = { { "char", 1 }, { "uchar", 1 },
    { "int8", 1 }, { "uint8", 1 }, { "short", 2 }, { "ushort", 2 }, { "int16", 2 }, { "uint16", 2 },
    { "int", 4 }, { "uint", 4 }, { "int32", 4 }, { "uint32", 4 }, { "float", 4 }, { "float32", 4 },
    { "double", 8 }, { "float64", 8 } };
  const auto found = sizes.find(name);
  return found == sizes.end() ? 0 : found->second;
}

struct PlyProperty
{
  std::size_t CountSize = 0; ///< of a list's length; 0 for a single value
  std::size_t ValueSize = 0;
};

struct PlyElement
{
  double Count = 0;
  std::vector<PlyProperty> Properties;
};

struct PlyHeader
{
  bool Binary = false;
  bool BigEndian = false;
  bool Understood = true;
  std::vector<PlyElement> Elements;
};

PlyHeader ReadPlyHeader(std::istream& file)
{
  PlyHeader header;
  std::string line;
  constexpr int longest = 1000; // lines; beyond it this is no header
  for (int i = 0; i < longest && std::getline(file, line) && Trimmed(line) != "end_header"; ++i)
  {
    std::istringstream words(line);
    std::string key, type, name;
    words >> key >> type;
    if (key == "format")
    {
      header.Binary = type.rfind("binary", 0) == 0;
      header.BigEndian = type == "binary_big_endian";
    }
    else if (key == "element")
    {
      header.Elements.emplace_back();
      words >> header.Elements.back().Count;
    }
    else if (key == "property" && !header.Elements.empty())
    {
      PlyProperty property;
      if (type == "list")
      {
        words >> name >> type;
        property.CountSize = PlyTypeSize(name);
        header.Understood = header.Understood && property.CountSize > 0;
      }
      property.ValueSize = PlyTypeSize(type);
      header.Understood = header.Understood && property.ValueSize > 0;
      header.Elements.back().Properties.push_back(property);
    }
  }
  header.Understood = header.Understood && Trimmed(line) == "end_header";
  return header;
}

// Where a text ends early, VTK's reader asserts or goes on with what it has.
void RequireCompletePlyText(const std::string& path, std::istream& file, const PlyHeader& header)
{
  std::string word;
  for (const PlyElement& element : header.Elements)
  {
    for (double i = 0; i < element.Count; ++i)
    {
      for (const PlyProperty& property : element.Properties)
      {
        file >> word;
        for (double left = property.CountSize > 0 ? std::strtod(word.c_str(), nullptr) : 0;
             left >= 1 && file; --left)
        {
          file >> word;
        }
        if (!file)
        {
          Fail("'{}' is damaged or cut off: it ends before the last of its elements", path);
        }
      }
    }
  }
}

double ReadCount(std::istream& file, std::size_t size, bool bigEndian)
{
  unsigned char bytes[8] = {};
  file.read(reinterpret_cast<char*>(bytes), static_cast<std::streamsize>(size));
  double value = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    value = value * 256 + bytes[bigEndian ? i : size - 1 - i];
  }
  return value;
}
}

void RequireCompleteStl(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  char start[512] = {};
  file.read(start, sizeof(start));
  const bool text = std::strncmp(start, "solid", 5) == 0 && std::strstr(start, "facet") != nullptr;
  constexpr double header = 84, triangle = 50; // bytes
  if (text)
  {
    return;
  }
  const double size = FileSize(path);
  std::uint32_t count = 0;
  std::memcpy(&count, start + 80, sizeof(count));
  if (size < header + triangle * count)
  {
    FailShort(path, header + triangle * count, size);
  }
}

void RequireCompletePly(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const PlyHeader header = ReadPlyHeader(file);
  if (!header.Understood)
  {
    return;
  }
  if (!header.Binary)
  {
    RequireCompletePlyText(path, file, header);
    return;
  }
  const double size = FileSize(path);
  double position = static_cast<double>(file.tellg());
  for (const PlyElement& element : header.Elements)
  {
    double fixed = 0;
    bool lists = false;
    for (const PlyProperty& property : element.Properties)
    {
      fixed += property.CountSize > 0 ? property.CountSize : property.ValueSize;
      lists = lists || property.CountSize > 0;
    }
    if (position + fixed * element.Count > size)
    {
      FailShort(path, position + fixed * element.Count, size);
    }
    for (double i = 0; lists && i < element.Count; ++i)
    {
      for (const PlyProperty& property : element.Properties)
      {
        file.seekg(static_cast<std::streamoff>(position));
        const double values =
          property.CountSize > 0 ? ReadCount(file, property.CountSize, header.BigEndian) : 1;
        position += property.CountSize + values * property.ValueSize;
        if (position > size)
        {
          FailShort(path, position, size);
        }
      }
    }
    position += lists ? 0 : fixed * element.Count;
  }
}
}
