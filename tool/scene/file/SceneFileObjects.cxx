// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Objects of a scene file: geometry, materials, colouring.
#include "common/Failure.h"
#include "common/Names.h"
#include "scene/build/Shapes.h"
#include "scene/file/JsonObject.h"
#include "scene/file/SceneFile.h"

namespace penumbra::tool
{
namespace
{
using nlohmann::json;

Material ReadMaterial(const json& value, const std::string& where)
{
  Material material;
  JsonObject object(value, where);
  object.ReadChoice<int>("shading", material.Shading,
    { { "flat", VTK_FLAT }, { "gouraud", VTK_GOURAUD }, { "phong", VTK_PHONG },
      { "pbr", VTK_PBR } });
  object.ReadColor("color", material.Color);
  object.Read("ambient", material.Ambient, UnitInterval);
  object.Read("diffuse", material.Diffuse, UnitInterval);
  object.Read("specular", material.Specular, UnitInterval);
  object.Read("specular-power", material.SpecularPower, Bounds{ 0, 128 });
  object.ReadColor("specular-color", material.SpecularColor);
  object.Read("metallic", material.Metallic, UnitInterval);
  object.Read("ior", material.RefractiveIndex, Bounds{ 1, 10 });
  object.Read("roughness", material.Roughness, UnitInterval);
  object.ReadColor("emission", material.Emission);
  object.Read("opacity", material.Opacity, UnitInterval);
  object.Read("lighting", material.Lighting);
  object.ReadChoice<int>("representation", material.Representation,
    { { "surface", VTK_SURFACE }, { "wireframe", VTK_WIREFRAME }, { "points", VTK_POINTS } });
  object.ReadChoice<Culling>("cull", material.Cull,
    { { "none", Culling::None }, { "back", Culling::Back }, { "front", Culling::Front } });
  object.ReadColor("edges", material.EdgeColor);
  object.Read("line-width", material.LineWidth, Positive);
  object.Read("point-size", material.PointSize, Positive);
  object.Read("texture", material.Texture);
  object.Read("normal-texture", material.NormalTexture);
  object.Read("orm-texture", material.OrmTexture);
  object.Read("emission-texture", material.EmissionTexture);
  object.ReadColor("back-color", material.BackColor);
  object.Finish();
  const bool onlyPbr = !material.NormalTexture.empty() || !material.OrmTexture.empty() ||
    !material.EmissionTexture.empty();
  if (onlyPbr && material.Shading != VTK_PBR)
  {
    FailUsage("{} has a normal, orm or emission texture: these need \"shading\": \"pbr\"", where);
  }
  return material;
}

Primitive ReadPrimitive(const std::string& kind, const json& value, const std::string& where)
{
  Primitive shape;
  shape.Kind = kind;
  JsonObject object(value, where);
  const auto uses = [&](std::initializer_list<const char*> kinds) {
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
  };
  object.Read("center", shape.Center);
  if (uses({ "box" }))
  {
    object.Read("size", shape.Size);
  }
  if (uses({ "plane" }))
  {
    std::vector<double> sides = { shape.Size[0], shape.Size[1] };
    object.Read("size", sides);
    if (sides.size() != 2)
    {
      FailUsage("'size' of {} must be a list of two numbers", where);
    }
    std::copy(sides.begin(), sides.end(), shape.Size.begin());
  }
  if (!uses({ "box", "sphere" }))
  {
    object.Read("normal", shape.Normal);
  }
  if (!uses({ "box", "plane" }))
  {
    object.Read("radius", shape.Radius, Positive);
    object.Read("resolution", shape.Resolution, Bounds{ 3, 2048 });
  }
  if (uses({ "disk", "torus" }))
  {
    object.Read("inner-radius", shape.InnerRadius, NotNegative);
  }
  if (uses({ "cylinder", "cone" }))
  {
    object.Read("height", shape.Height, Positive);
  }
  object.Finish();
  for (const double side : shape.Size)
  {
    if (side <= 0)
    {
      FailUsage("'size' of {} must be above 0", where);
    }
  }
  if (shape.Normal == Vec3{ 0, 0, 0 })
  {
    FailUsage("'normal' of {} must not be zero", where);
  }
  return shape;
}

template <typename T>
void ReadLists(
  JsonObject& object, const std::string& key, std::vector<T>& target, std::size_t size = 0)
{
  object.ForEach(key, [&](const json& value, const std::string& where) {
    const json wrapped = { { "values", value } };
    std::vector<double> numbers;
    JsonObject(wrapped, where).Read("values", numbers);
    if (size > 0 && numbers.size() != size)
    {
      FailUsage("{} must be a list of {} numbers", where, size);
    }
    T item{};
    if constexpr (std::is_same_v<T, std::vector<long long>>)
    {
      item.resize(numbers.size());
    }
    std::copy(numbers.begin(), numbers.end(), item.begin());
    target.push_back(item);
  });
}

void ReadArrays(
  JsonObject& object, const std::string& key, std::map<std::string, std::vector<double>>& target)
{
  if (const json* arrays = object.Find(key))
  {
    JsonObject inner(*arrays, fmt::format("'{}' of {}", key, object.Where()));
    for (const auto& array : arrays->items())
    {
      inner.Read(array.key(), target[array.key()]);
    }
  }
}

Mesh ReadMesh(const json& value, const std::string& where)
{
  Mesh mesh;
  JsonObject object(value, where);
  ReadLists(object, "points", mesh.Points, 3);
  ReadLists(object, "polygons", mesh.Polygons);
  ReadLists(object, "lines", mesh.Lines);
  ReadLists(object, "normals", mesh.Normals, 3);
  ReadLists(object, "texture-coordinates", mesh.TextureCoordinates, 2);
  ReadArrays(object, "point-data", mesh.PointArrays);
  ReadArrays(object, "cell-data", mesh.CellArrays);
  object.Finish();
  return mesh;
}

ColorBy ReadColorBy(const json& value, const std::string& where)
{
  ColorBy color;
  if (value.is_string())
  {
    color.Array = value.get<std::string>();
    return color;
  }
  JsonObject object(value, where);
  object.Read("array", color.Array);
  object.Read("component", color.Component);
  object.Read("map", color.Map);
  object.Read("scalar-bar", color.ScalarBar);
  std::vector<double> range;
  object.Read("range", range);
  object.Finish();
  if (color.Array.empty() || (!range.empty() && (range.size() != 2 || range[0] >= range[1])))
  {
    FailUsage("{} needs an 'array', and a 'range', if any, of two increasing numbers", where);
  }
  if (!range.empty())
  {
    color.Range = { range[0], range[1] };
  }
  return color;
}

Placement ReadPlacement(const json& value, const std::string& where)
{
  Placement place;
  JsonObject object(value, where);
  object.Read("translate", place.Translate);
  object.Read("rotate", place.Rotate);
  const json* scale = object.Find("scale");
  if (scale && scale->is_number())
  {
    place.Scale.fill(scale->get<double>());
  }
  else
  {
    object.Read("scale", place.Scale);
  }
  object.Finish();
  if (place.Scale[0] * place.Scale[1] * place.Scale[2] == 0)
  {
    FailUsage("'scale' of {} must not be zero", where);
  }
  return place;
}

Terrain ReadTerrain(const json& value, const std::string& where)
{
  Terrain terrain;
  if (value.is_boolean() && value.get<bool>())
  {
    return terrain;
  }
  JsonObject object(value, where);
  object.Read("exaggeration", terrain.Exaggeration);
  object.Read("spacing", terrain.Spacing, Positive);
  object.Read("stride", terrain.Stride, Bounds{ 1, 10000 });
  object.Finish();
  return terrain;
}

/// Reads exactly one of "file", "mesh" and the primitives.
void ReadSource(JsonObject& object, Object& target)
{
  int sources = 0;
  object.Read("file", target.Path);
  sources += target.Path.empty() ? 0 : 1;
  if (const json* mesh = object.Find("mesh"))
  {
    target.Geometry = ReadMesh(*mesh, "the mesh of " + object.Where());
    ++sources;
  }
  for (const std::string& kind : PrimitiveKinds())
  {
    if (const json* shape = object.Find(kind))
    {
      target.Shape = ReadPrimitive(kind, *shape, fmt::format("the {} of {}", kind, object.Where()));
      ++sources;
    }
  }
  if (sources != 1)
  {
    object.Finish();
    FailUsage(
      "{} needs exactly one of the keys file, mesh, {}", object.Where(), Join(PrimitiveKinds()));
  }
}
}

Object ReadObject(const json& value, const std::string& where)
{
  Object target;
  JsonObject object(value, where);
  object.Read("name", target.Name);
  ReadSource(object, target);
  object.Read("isovalues", target.IsoValues);
  object.Read("isosurface-of", target.IsoArray);
  object.Read("opacities", target.Opacities);
  object.Read("smoothing", target.Smoothing, Bounds{ 0, 20 });
  object.ReadChoice<MoleculeStyle>("molecule", target.Molecule,
    { { "balls", MoleculeStyle::Balls }, { "ball-and-stick", MoleculeStyle::BallAndStick },
      { "sticks", MoleculeStyle::Sticks } });
  object.Read("feature-angle", target.FeatureAngle, Bounds{ 0, 180 });
  object.Read("points-as-balls", target.PointsAsBalls);
  object.Read("radius", target.Radius, NotNegative);
  if (const json* color = object.Find("color-by"))
  {
    target.Color = ReadColorBy(*color, "'color-by' of " + where);
  }
  if (const json* terrain = object.Find("terrain"))
  {
    target.Heights = ReadTerrain(*terrain, "the terrain of " + where);
  }
  if (const json* material = object.Find("material"))
  {
    target.Appearance = ReadMaterial(*material, "the material of " + where);
  }
  if (const json* place = object.Find("transform"))
  {
    target.Place = ReadPlacement(*place, "the transform of " + where);
  }
  object.Finish();
  for (const double opacity : target.Opacities)
  {
    if (opacity < 0 || opacity > 1)
    {
      FailUsage("'opacities' of {} must be numbers from 0 to 1", where);
    }
  }
  return target;
}
}
