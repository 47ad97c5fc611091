// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/LightmapFile.h"

#include "common/Failure.h"
#include "techniques/lightmap/LightmapImage.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkGIBakeFile.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cstring>
#include <map>
#include <stdexcept>

namespace penumbra::lightmap
{
namespace
{
using tool::Fail;

float Rounded(float value)
{
  constexpr float largest = 65504.0f; // of half floats
  return glm::unpackHalf1x16(glm::packHalf1x16(glm::clamp(value, -largest, largest)));
}

/// Adds channels of light as an array at the image's points.
void AddLayer(vtkImageData* image, const char* name, const Light& light, int first, int components)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  float* to = array->GetPointer(0);
  for (std::size_t i = 0; i < std::size_t(light.Width) * light.Height; ++i)
  {
    to = std::transform(light.Pixel(i) + first, light.Pixel(i) + first + components, to, Rounded);
  }
  image->GetPointData()->AddArray(array);
}

/// Adds rows of numbers as an array in the image's field data.
template <typename Array, typename Row>
void AddTable(vtkImageData* image, const char* name, const std::vector<Row>& rows)
{
  using Number = typename Array::ValueType;
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(sizeof(Row) / sizeof(Number)));
  array->SetNumberOfTuples(static_cast<vtkIdType>(rows.size()));
  std::memcpy(array->GetPointer(0), rows.data(), rows.size() * sizeof(Row));
  image->GetFieldData()->AddArray(array);
}

/// The existing layers of an image as consecutive channels.
Light ReadLayers(vtkImageData* image, std::initializer_list<const char*> layers)
{
  std::vector<vtkDataArray*> arrays;
  int channels = 0;
  for (const char* layer : layers)
  {
    if (vtkDataArray* array = image->GetPointData()->GetArray(layer))
    {
      arrays.push_back(array);
      channels += array->GetNumberOfComponents();
    }
  }
  const int* size = image->GetDimensions();
  Light light(size[0], size[1], channels);
  float* to = light.Values.data();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    for (vtkDataArray* array : arrays)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        *to++ = static_cast<float>(array->GetComponent(i, c));
      }
    }
  }
  return light;
}
}

void AddSurfaces(Lightmap& lightmap, const Surfaces& surfaces, const std::vector<Chart>& charts,
  const Atlas& atlas)
{
  for (const Tile& tile : atlas.Tiles)
  {
    const Chart& chart = charts[tile.Chart];
    // Share corners with the same point and normal.
    std::map<std::pair<std::uint32_t, std::array<double, 3>>, int> points;
    for (const std::uint32_t t : chart.Triangles)
    {
      const Triangle& triangle = surfaces.Triangles[t];
      glm::ivec3 corners(0);
      for (int k = 0; k < 3; ++k)
      {
        const Vec3 normal = triangle.Normals[k] * (tile.Back ? -1.0 : 1.0);
        const std::uint32_t point = triangle.Points[k];
        const auto found = points.emplace(
          std::make_pair(point, std::array<double, 3>{ normal.x, normal.y, normal.z }),
          static_cast<int>(lightmap.Points.size()));
        if (found.second)
        {
          const Vec3& at = surfaces.Points[point];
          lightmap.Points.push_back(at);
          lightmap.Normals.emplace_back(normal);
          const Vec2 place = tile.ToTexels(chart, chart.Project(at)) + Vec2(tile.At) + 0.5;
          lightmap.TextureCoordinates.emplace_back(place / Vec2(atlas.Width, atlas.Height));
        }
        corners[tile.Back ? 2 - k : k] = found.first->second;
      }
      lightmap.Triangles.push_back(corners);
    }
  }
}

vtkSmartPointer<vtkImageData> MakeImage(const Lightmap& lightmap)
{
  namespace parts = lightmap_image;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(lightmap.Baked.Width, lightmap.Baked.Height, 1);
  const Light* lights[] = { &lightmap.Baked, &lightmap.Direct };
  for (std::size_t i = 0; i < parts::Layers.size(); ++i)
  {
    const int first = i % 2 == 0 ? 0 : parts::Layers[0].Components; // moments follow their light
    if (lights[i / 2]->Channels > first)
    {
      AddLayer(image, parts::Layers[i].Name, *lights[i / 2], first, parts::Layers[i].Components);
    }
  }
  AddLayer(image, parts::First, lightmap.First, 0, 3);
  image->GetPointData()->SetActiveScalars(parts::Layers[0].Name);
  AddTable<vtkDoubleArray>(image, parts::Points, lightmap.Points);
  AddTable<vtkFloatArray>(image, parts::Normals, lightmap.Normals);
  AddTable<vtkFloatArray>(image, parts::Places, lightmap.TextureCoordinates);
  AddTable<vtkIntArray>(image, parts::Triangles, lightmap.Triangles);
  std::vector<std::array<int, 6>> tiles;
  for (const Patch& p : lightmap.Patches)
  {
    tiles.push_back({ p.At.x, p.At.y, p.Texels.x, p.Texels.y, static_cast<int>(p.Key >> 32),
      static_cast<int>(p.Key) });
  }
  AddTable<vtkIntArray>(image, parts::Tiles, tiles);
  vtkFieldData* fields = image->GetFieldData();
  SetText(fields, BakedSceneText, lightmap.Scene);
  SetText(fields, parts::Made, lightmap.Made);
  SetText(fields, parts::Settings, lightmap.Settings);
  parts::Seal(image);
  return image;
}

void WriteLightmap(const std::string& path, const Lightmap& lightmap)
{
  vtkNew<vtkGIBakeFile> file;
  if (!file->Write(path.c_str(), MakeImage(lightmap)))
  {
    Fail("{}", file->GetLastError());
  }
}

Lightmap ReadLightmap(const std::string& path)
{
  vtkNew<vtkGIBakeFile> file;
  vtkNew<vtkImageData> image;
  if (!file->Read(path.c_str(), image))
  {
    Fail("{}", file->GetLastError());
  }
  try
  {
    lightmap_image::RequireWhole(image);
  }
  catch (const std::invalid_argument& error)
  {
    Fail("the lightmap '{}' cannot be used: {}", path, error.what());
  }
  Lightmap map;
  map.Baked = ReadLayers(image, { lightmap_image::Layers[0].Name, lightmap_image::Layers[1].Name });
  map.First = ReadLayers(image, { lightmap_image::First });
  vtkFieldData* fields = image->GetFieldData();
  map.Scene = GetText(fields, BakedSceneText);
  map.Made = GetText(fields, lightmap_image::Made);
  map.Settings = GetText(fields, lightmap_image::Settings);
  auto* tiles = vtkIntArray::SafeDownCast(fields->GetAbstractArray(lightmap_image::Tiles));
  for (vtkIdType i = 0; tiles && i < tiles->GetNumberOfTuples(); ++i)
  {
    const int* n = tiles->GetPointer(6 * i);
    const auto high = static_cast<std::uint32_t>(n[4]), low = static_cast<std::uint32_t>(n[5]);
    map.Patches.push_back({ { n[0], n[1] }, { n[2], n[3] }, std::uint64_t(high) << 32 | low });
  }
  return map;
}
}
