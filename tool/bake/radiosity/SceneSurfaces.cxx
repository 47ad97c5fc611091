// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/SceneSurfaces.h"

#include "scene/build/OpaqueMeshes.h"

#include "rays/TexturePixels.h"

#include <glm/gtc/packing.hpp>
#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkMapper.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace penumbra::radiosity
{
namespace
{
/// Reads textures, and makes functions that look up texture coordinates, with repetition unless it is off.
class TextureReader
{
public:
  Texture operator()(vtkTexture* texture)
  {
    if (!texture)
    {
      return {};
    }
    auto& pixels = this->Pixels[texture];
    if (!pixels)
    {
      pixels = std::make_shared<TexturePixels>(ReadTexturePixels(texture));
    }
    if (pixels->Width == 0)
    {
      return {};
    }
    const bool repeats = texture->GetRepeat() != 0;
    return [pixels = pixels, repeats](const glm::dvec2& uv) {
      const auto place = [repeats](double t, int size) {
        const double within = repeats ? t - std::floor(t) : t;
        return std::clamp(static_cast<int>(within * size), 0, size - 1);
      };
      return Color(pixels->At(place(uv.x, pixels->Width), place(uv.y, pixels->Height)));
    };
  }

private:
  std::map<vtkTexture*, std::shared_ptr<TexturePixels>> Pixels;
};

Color Unpack(std::uint32_t rgba)
{
  return Color(glm::unpackUnorm4x8(rgba));
}

SideMaterial MakeSide(
  const shared::RaySurface& surface, const RayPart& part, bool front, TextureReader& textures)
{
  const int flags = surface.Where.z;
  const int model = flags & GI_SURFACE_MODEL;
  const double diffuse = model == GI_SURFACE_PBR ? 1.0 - surface.Factors.z : 1.0;
  SideMaterial side;
  side.Present = (flags & (front ? GI_SURFACE_CULL_FRONT : GI_SURFACE_CULL_BACK)) == 0;
  side.Reflectance = Color(surface.Color) * diffuse;
  side.Emission = Color(surface.Emission);
  side.TintReflects = surface.Factors.x * diffuse;
  side.TintsEmission = model == GI_SURFACE_PHONG;
  side.TintEmits = surface.Factors.y;
  if (front || (flags & GI_SURFACE_FRONT_PICTURES) == 0)
  {
    side.Base = textures(
      part.Pictures[ColorPicture] ? part.Pictures[ColorPicture] : part.Pictures[BasePicture]);
    side.BaseOnEmission = model != GI_SURFACE_PBR;
    side.Glow = textures(part.Pictures[EmissionPicture]);
  }
  if (part.Pictures[ColorPicture])
  {
    // The texture replaces the colour.
    side.Reflectance = Color(side.TintReflects);
    side.Emission = side.TintsEmission ? Color(side.TintEmits) : side.Emission;
  }
  if (model == GI_SURFACE_UNLIT)
  {
    // It shows its colour, independent of light.
    side.Emission = side.Reflectance;
    side.Reflectance = Color(0.0);
    side.TintEmits = side.TintReflects;
    side.TintReflects = 0.0;
    side.TintsEmission = true;
  }
  return side;
}

/// The values of a cell array of three components for each triangle; empty if there is no such array.
std::vector<Color> ForTriangles(vtkPolyData* data, const char* name)
{
  std::vector<Color> values;
  vtkDataArray* array = data ? data->GetCellData()->GetArray(name) : nullptr;
  if (!array || array->GetNumberOfComponents() != 3)
  {
    return values;
  }
  vtkIdType cell = data->GetNumberOfVerts() + data->GetNumberOfLines();
  for (vtkCellArray* cells : { data->GetPolys(), data->GetStrips() })
  {
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i, ++cell)
    {
      Color value;
      array->GetTuple(cell, &value[0]);
      for (vtkIdType k = 2; k < cells->GetCellSize(i); ++k)
      {
        values.push_back(value);
      }
    }
  }
  return values;
}

vtkPolyData* InputPolygons(const RayPart& part)
{
  auto* actor = vtkActor::SafeDownCast(part.Prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  return mapper ? vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0)) : nullptr;
}

bool HasHighlight(const RayPart& part)
{
  const int model = part.Surface.Where.z & GI_SURFACE_MODEL;
  return model == GI_SURFACE_PBR ? part.Surface.Specular.w > 0.0f || part.Surface.Factors.z > 0.0f
                                 : model == GI_SURFACE_PHONG &&
      part.Surface.Specular != glm::vec4(0, 0, 0, part.Surface.Specular.w);
}

class MeshBuilder
{
public:
  MeshBuilder(PatchMesh& mesh, double maximumAlbedo)
    : Mesh(mesh)
    , MaximumAlbedo(maximumAlbedo)
  {
  }

  /// Adds the triangles. Returns the number of degenerate ones.
  std::size_t Add(const tool::MeshInstance& instance)
  {
    const RayPart& part = instance.Part;
    vtkPolyData* polygons = InputPolygons(part);
    const std::vector<Color> albedos = ForTriangles(polygons, "albedo");
    const std::vector<Color> emissions = ForTriangles(polygons, "emission");
    const Surface material = this->MakeSurface(part);
    std::uint32_t surface = this->Mesh.AddSurface(material);
    std::size_t degenerate = 0;
    for (std::size_t i = 0; i < instance.Geometry.Triangles.size(); ++i)
    {
      std::array<Vertex, 3> corners;
      for (int k = 0; k < 3; ++k)
      {
        const std::uint32_t index = instance.Geometry.Triangles[i][k];
        const shared::RayPoint& point = instance.Attributes.Points[index];
        Vertex& corner = corners[instance.CornerAt(k)];
        corner.At = instance.PointAt(index);
        corner.Tint = material.Tints == Surface::OfPoints ? Unpack(point.Color) : Color(1.0);
        corner.Uv = material.Sides[0].Base || material.Sides[0].Glow
          ? glm::dvec2(point.TextureU, point.TextureV)
          : glm::dvec2(0.0);
      }
      if (i < albedos.size() || i < emissions.size())
      {
        surface = this->FindOrAdd(material, i < albedos.size() ? &albedos[i] : nullptr,
          i < emissions.size() ? &emissions[i] : nullptr);
      }
      const bool instanceColor =
        instance.Place && (part.Surface.Where.z & GI_SURFACE_PLACE_COLORS) != 0;
      const std::uint32_t color =
        instanceColor ? instance.Place->Color : instance.Attributes.Primitives[i].Color;
      degenerate += this->Mesh.Add(corners, surface, Unpack(color)) ? 0 : 1;
    }
    return degenerate;
  }

private:
  Surface MakeSurface(const RayPart& part)
  {
    Surface surface;
    surface.Sides[0] = MakeSide(part.Surface, part, true, this->Textures);
    surface.Sides[1] =
      MakeSide(part.HasBack ? part.Back : part.Surface, part, false, this->Textures);
    for (SideMaterial& side : surface.Sides)
    {
      side.Reflectance *= this->MaximumAlbedo;
      side.TintReflects *= this->MaximumAlbedo;
    }
    const int flags = part.Surface.Where.z;
    surface.Tints = (flags & GI_SURFACE_POINT_COLORS) != 0                ? Surface::OfPoints
      : (flags & (GI_SURFACE_CELL_COLORS | GI_SURFACE_PLACE_COLORS)) != 0 ? Surface::OfFaces
                                                                          : Surface::Untinted;
    return surface;
  }

  /// The material with values from the data. Equal values share a surface.
  std::uint32_t FindOrAdd(const Surface& material, const Color* albedo, const Color* emission)
  {
    const Color a = albedo ? *albedo : Color(-1.0);
    const Color e = emission ? *emission : Color(-1.0);
    const auto [found, isNew] = this->DataSurfaces.try_emplace({ a.x, a.y, a.z, e.x, e.y, e.z }, 0);
    if (isNew)
    {
      Surface surface = material;
      surface.Tints = albedo ? Surface::Untinted : material.Tints;
      for (SideMaterial& side : surface.Sides)
      {
        side.Reflectance = albedo ? this->MaximumAlbedo * a : side.Reflectance;
        side.Emission = emission ? e : side.Emission;
        side.TintsEmission = side.TintsEmission && !emission;
      }
      found->second = this->Mesh.AddSurface(surface);
    }
    return found->second;
  }

  PatchMesh& Mesh;
  double MaximumAlbedo;
  TextureReader Textures;
  std::map<std::array<double, 6>, std::uint32_t> DataSurfaces;
};
}

GatheredScene GatherScene(
  vtkRenderer* renderer, double maximumAlbedo, tool::Reporter& reporter)
{
  GatheredScene scene;
  MeshBuilder builder(scene.Mesh, maximumAlbedo);
  bool clipped = false, highlights = false;
  tool::ForEachOpaqueMesh(renderer, true, reporter, [&](const tool::MeshInstance& instance) {
    clipped = clipped || !instance.Part.Clip.empty();
    highlights = highlights || HasHighlight(instance.Part);
    return builder.Add(instance);
  });
  if (clipped)
  {
    reporter.Note("clipping planes are ignored");
  }
  if (highlights)
  {
    reporter.Note("highlights and mirrors are left out: radiosity is for diffuse reflection");
  }
  scene.Light = GatherLights(renderer, reporter);
  return scene;
}
}
