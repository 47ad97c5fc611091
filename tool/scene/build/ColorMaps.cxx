// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build/ColorMaps.h"

#include "common/Failure.h"
#include "common/Names.h"

#include <vtkCellData.h>
#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <limits>
#include <set>

namespace penumbra::tool
{
namespace
{
using Stops = std::vector<unsigned>; // 0xRRGGBB, evenly spaced

const std::map<std::string, Stops>& Maps()
{
  static const std::map<std::string, Stops> maps = {
    // Smith and van der Walt 2015, A Better Default Colormap for Matplotlib.
    { "viridis",
      { 0x440154, 0x482878, 0x3e4a89, 0x31688e, 0x26828e, 0x1f9e89, 0x35b779, 0x6dcd59, 0xb4de2c,
        0xfde725 } },
    { "plasma",
      { 0x0d0887, 0x47039f, 0x7301a8, 0x9c179e, 0xbd3786, 0xd8576b, 0xed7953, 0xfa9e3b, 0xfdc926,
        0xf0f921 } },
    { "inferno",
      { 0x000004, 0x1b0c42, 0x4b0c6b, 0x781c6d, 0xa52c60, 0xcf4446, 0xed6925, 0xfb9a06, 0xf7d03c,
        0xfcffa4 } },
    // Moreland 2009, Diverging Color Maps for Scientific Visualization.
    { "cool-warm",
      { 0x3b4cc0, 0x6282ea, 0x8db0fe, 0xb8d0f9, 0xdddddd, 0xf5c4ad, 0xf49a7b, 0xde604d,
        0xb40426 } },
    // Hypsometric tints after Imhof 1965, Cartographic Relief Presentation: green valleys to bare tops.
    { "terrain",
      { 0x5f8a5a, 0x86a366, 0xb3b878, 0xcdb981, 0xb99468, 0x9b7657, 0xa89484, 0xd2c9c0,
        0xf4f2f0 } },
    { "gray", { 0x202020, 0xf0f0f0 } },
  };
  return maps;
}

/// The array at points, or else at cells.
vtkDataArray* FindArray(vtkPolyData* geometry, const std::string& name, bool& atPoints)
{
  vtkDataArray* array = geometry->GetPointData()->GetArray(name.c_str());
  atPoints = array != nullptr;
  return array ? array : geometry->GetCellData()->GetArray(name.c_str());
}

/// The index of a component; -1 for the magnitude, as in vtkDataArray::GetRange().
int ComponentIndex(const ColorBy& color, int components, const std::string& what)
{
  if (components == 1)
  {
    return 0;
  }
  if (color.Component.empty() || color.Component == "magnitude")
  {
    return -1;
  }
  static const std::vector<std::string> letters = { "x", "y", "z" };
  const auto letter = std::find(letters.begin(), letters.end(), color.Component);
  const bool number = color.Component.find_first_not_of("0123456789") == std::string::npos &&
    color.Component.size() < 4;
  const int index = letter != letters.end() ? static_cast<int>(letter - letters.begin())
                                            : (number ? std::stoi(color.Component) : components);
  if (index >= components)
  {
    FailUsage(
      "array '{}' of {} has no component '{}': it has {}; use magnitude, x, y, z or 0 to {}",
      color.Array, what, color.Component, components, components - 1);
  }
  return index;
}
/// The map as a table of 256 colours over a range. Throws a Failure for an unknown name.
vtkSmartPointer<vtkLookupTable> MakeColorMap(const std::string& name, const double range[2])
{
  const auto map = Maps().find(name);
  if (map == Maps().end())
  {
    std::vector<std::string> names;
    for (const auto& row : Maps())
    {
      names.push_back(row.first);
    }
    FailUsage("{}", UnknownName("colour map", name, "", names));
  }
  vtkNew<vtkColorTransferFunction> curve;
  curve->SetColorSpaceToLab();
  const Stops& stops = map->second;
  for (std::size_t i = 0; i < stops.size(); ++i)
  {
    curve->AddRGBPoint(double(i) / (stops.size() - 1), (stops[i] >> 16 & 255) / 255.0,
      (stops[i] >> 8 & 255) / 255.0, (stops[i] & 255) / 255.0);
  }
  constexpr int colors = 256;
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(colors);
  for (int i = 0; i < colors; ++i)
  {
    double rgb[3];
    curve->GetColor(double(i) / (colors - 1), rgb);
    table->SetTableValue(i, rgb[0], rgb[1], rgb[2]);
  }
  table->SetTableRange(range[0], range[1]);
  table->SetNanColor(0.6, 0.6, 0.6, 1);
  return table;
}
}

vtkSmartPointer<vtkLookupTable> MakeColoring(
  const std::vector<Part>& parts, const ColorBy& color, const std::string& what)
{
  double range[2] = { std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest() };
  bool found = false;
  int component = 0;
  for (const Part& part : parts)
  {
    bool atPoints;
    if (vtkDataArray* array = FindArray(part.Geometry, color.Array, atPoints))
    {
      component = ComponentIndex(color, array->GetNumberOfComponents(), what);
      double own[2];
      array->GetFiniteRange(own, component);
      range[0] = std::min(range[0], own[0]);
      range[1] = std::max(range[1], own[1]);
      found = true;
    }
  }
  if (!found)
  {
    std::set<std::string> names;
    for (const Part& part : parts)
    {
      for (vtkFieldData* fields : std::initializer_list<vtkFieldData*>{
             part.Geometry->GetPointData(), part.Geometry->GetCellData() })
      {
        const auto known = ArrayNames(fields);
        names.insert(known.begin(), known.end());
      }
    }
    FailUsage("{}", UnknownName("array", color.Array, what, { names.begin(), names.end() }));
  }
  if (color.Range)
  {
    std::copy(color.Range->begin(), color.Range->end(), range);
  }
  if (!(range[0] < range[1]))
  {
    // A single value, or no finite one: any range that contains it.
    range[1] = range[0] = range[0] > range[1] ? 0 : range[0];
    range[1] += 1;
  }
  auto table = MakeColorMap(color.Map, range);
  if (component < 0)
  {
    table->SetVectorModeToMagnitude();
  }
  else
  {
    table->SetVectorModeToComponent();
    table->SetVectorComponent(component);
  }
  return table;
}

void ColorMapper(
  vtkMapper* mapper, vtkPolyData* geometry, const ColorBy& color, vtkLookupTable* table)
{
  bool atPoints;
  if (!FindArray(geometry, color.Array, atPoints))
  {
    mapper->ScalarVisibilityOff();
    return;
  }
  mapper->ScalarVisibilityOn();
  if (atPoints)
  {
    mapper->SetScalarModeToUsePointFieldData();
  }
  else
  {
    mapper->SetScalarModeToUseCellFieldData();
  }
  mapper->SelectColorArray(color.Array.c_str());
  mapper->SetColorModeToMapScalars();
  mapper->SetLookupTable(table);
  mapper->UseLookupTableScalarRangeOn();
}
}
