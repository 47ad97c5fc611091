// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/SceneSurfaces.h"

#include "bake/radiosity/SceneLights.h"

#include "rays/RayPart.h"
#include "rays/TexturePixels.h"
#include "rays/parts/GatherCache.h"

#include <fmt/format.h>
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
struct LeftOut
{
  std::size_t Translucent = 0, Balls = 0, Clipped = 0, Triangles = 0;
  bool Shiny = false;
};

/// Reads the picture at texture coordinates, repeating it as VTK's textures do unless told otherwise.
class PictureReader
{
public:
  Texture operator()(vtkTexture* texture)
  {
    if (!texture)
    {
      return {};
    }
    auto& pixels = this->Read[texture];
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
  std::map<vtkTexture*, std::shared_ptr<TexturePixels>> Read;
};

Color Unpack(std::uint32_t rgba)
{
  return Color(glm::unpackUnorm4x8(rgba));
}

SideMaterial MakeSide(
  const shared::RaySurface& surface, const RayPart& part, bool front, PictureReader& pictures)
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
    side.Base = pictures(
      part.Pictures[ColorPicture] ? part.Pictures[ColorPicture] : part.Pictures[BasePicture]);
    side.BaseOnEmission = model != GI_SURFACE_PBR;
    side.Glow = pictures(part.Pictures[EmissionPicture]);
  }
  if (part.Pictures[ColorPicture])
  {
    // The picture is the colour, not a factor of it.
    side.Reflectance = Color(side.TintReflects);
    side.Emission = side.TintsEmission ? Color(side.TintEmits) : side.Emission;
  }
  if (model == GI_SURFACE_UNLIT)
  {
    // It shows its colour, whatever light falls on it.
    side.Emission = side.Reflectance;
    side.Reflectance = Color(0.0);
    side.TintEmits = side.TintReflects;
    side.TintReflects = 0.0;
    side.TintsEmission = true;
  }
  return side;
}

/// A cell array of three components of the polygons that an actor draws, for each triangle.
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

vtkPolyData* DrawnPolygons(const RayPart& part)
{
  auto* actor = vtkActor::SafeDownCast(part.Prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  return mapper ? vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0)) : nullptr;
}

/// Adds a part of the scene.
class PartAdder
{
public:
  PartAdder(GatheredScene& scene, LeftOut& left)
    : Scene(scene)
    , Left(left)
  {
  }

  void Add(const RayPart& part)
  {
    if (part.Surface.Color.a < 1.0f)
    {
      ++this->Left.Translucent;
      return;
    }
    const RayGeometry geometry = part.MakeGeometry();
    const RayAttributes attributes = part.MakeAttributes();
    this->Left.Balls += geometry.Spheres.size() + geometry.Cylinders.size();
    this->Left.Clipped += part.Clip.empty() ? 0 : 1;
    const int model = part.Surface.Where.z & GI_SURFACE_MODEL;
    const bool highlight = model == GI_SURFACE_PBR
      ? part.Surface.Specular.w > 0.0f || part.Surface.Factors.z > 0.0f
      : model == GI_SURFACE_PHONG &&
        part.Surface.Specular != glm::vec4(0, 0, 0, part.Surface.Specular.w);
    this->Left.Shiny = this->Left.Shiny || highlight;
    if (!part.Places)
    {
      this->AddAt(part, geometry, attributes, part.ToWorld, nullptr);
      return;
    }
    for (const RayPlace& place : *part.Places)
    {
      glm::dmat4 turn{ glm::dmat3(place.Turn) };
      turn[3] = glm::dvec4(place.At, 1.0);
      this->AddAt(part, geometry, attributes, part.ToWorld * turn, &place);
    }
  }

private:
  Surface MakeSurface(const RayPart& part)
  {
    Surface surface;
    surface.Sides[0] = MakeSide(part.Surface, part, true, this->Pictures);
    surface.Sides[1] =
      MakeSide(part.HasBack ? part.Back : part.Surface, part, false, this->Pictures);
    const int flags = part.Surface.Where.z;
    surface.Tints = (flags & GI_SURFACE_POINT_COLORS) != 0                ? Surface::OfPoints
      : (flags & (GI_SURFACE_CELL_COLORS | GI_SURFACE_PLACE_COLORS)) != 0 ? Surface::OfFaces
                                                                          : Surface::Untinted;
    return surface;
  }

  void AddAt(const RayPart& part, const RayGeometry& geometry, const RayAttributes& attributes,
    const glm::dmat4& toWorld, const RayPlace* place)
  {
    vtkPolyData* polygons = DrawnPolygons(part);
    const std::vector<Color> albedos = ForTriangles(polygons, "albedo");
    const std::vector<Color> glows = ForTriangles(polygons, "emission");
    const Surface look = this->MakeSurface(part);
    std::uint32_t surface = this->Scene.Mesh.AddSurface(look);
    // A mirroring transformation turns the corners' order round.
    const bool mirrored = glm::determinant(glm::dmat3(toWorld)) < 0.0;
    for (std::size_t i = 0; i < geometry.Triangles.size(); ++i)
    {
      std::array<Vertex, 3> corners;
      for (int k = 0; k < 3; ++k)
      {
        const std::uint32_t index = geometry.Triangles[i][k];
        const shared::RayPoint& from = attributes.Points[index];
        Vertex& corner = corners[mirrored ? (3 - k) % 3 : k];
        corner.At =
          Point(toWorld * glm::dvec4(geometry.Origin + glm::dvec3(geometry.Points[index]), 1.0));
        corner.Tint = look.Tints == Surface::OfPoints ? Unpack(from.Color) : Color(1.0);
        corner.Uv = look.Sides[0].Base || look.Sides[0].Glow
          ? glm::dvec2(from.TextureU, from.TextureV)
          : glm::dvec2(0.0);
      }
      if (i < albedos.size() || i < glows.size())
      {
        surface = this->OwnSurface(
          look, i < albedos.size() ? &albedos[i] : nullptr, i < glows.size() ? &glows[i] : nullptr);
      }
      const std::uint32_t color = place && (part.Surface.Where.z & GI_SURFACE_PLACE_COLORS) != 0
        ? place->Color
        : attributes.Primitives[i].Color;
      this->Left.Triangles += this->Scene.Mesh.Add(corners, surface, Unpack(color)) ? 0 : 1;
    }
  }

  /// The look with what the data says instead; the same values share one.
  std::uint32_t OwnSurface(const Surface& look, const Color* albedo, const Color* emission)
  {
    const Color a = albedo ? *albedo : Color(-1.0);
    const Color e = emission ? *emission : Color(-1.0);
    const auto found = this->Owns.find({ a.x, a.y, a.z, e.x, e.y, e.z });
    if (found != this->Owns.end())
    {
      return found->second;
    }
    Surface own = look;
    own.Tints = albedo ? Surface::Untinted : look.Tints;
    for (SideMaterial& side : own.Sides)
    {
      side.Reflectance = albedo ? a : side.Reflectance;
      side.Emission = emission ? e : side.Emission;
      side.TintsEmission = side.TintsEmission && !emission;
    }
    return this->Owns[{ a.x, a.y, a.z, e.x, e.y, e.z }] = this->Scene.Mesh.AddSurface(own);
  }

  GatheredScene& Scene;
  LeftOut& Left;
  PictureReader Pictures;
  std::map<std::array<double, 6>, std::uint32_t> Owns;
};

void Comment(const LeftOut& left, std::size_t props, std::vector<std::string>& notes)
{
  const auto say = [&notes](std::size_t count, const char* what) {
    if (count > 0)
    {
      notes.push_back(fmt::format("{} {}", count, what));
    }
  };
  say(left.Translucent, "translucent surfaces are left out: radiosity is for opaque ones");
  say(left.Balls, "balls and sticks are left out: they have no triangles to make patches of");
  say(left.Clipped, "surfaces are taken whole, without their clipping planes");
  say(props, "objects are left out: rays do not see what draws them");
  say(left.Triangles, "triangles without area or with points that are not finite are left out");
  if (left.Shiny)
  {
    notes.emplace_back("highlights and mirrors are left out: radiosity is for diffuse reflection");
  }
}
}

GatheredScene GatherScene(vtkRenderer* renderer)
{
  GatheredScene scene;
  GatherCache cache;
  std::vector<vtkProp*> unseen;
  LeftOut left;
  const std::vector<RayPart> parts = GatherRayParts(renderer, unseen, cache);
  PartAdder adder(scene, left);
  for (const RayPart& part : parts)
  {
    adder.Add(part);
  }
  Comment(left, unseen.size(), scene.Notes);
  scene.Light = GatherLights(renderer, scene.Notes);
  return scene;
}
}
