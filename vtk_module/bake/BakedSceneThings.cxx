// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// What of a renderer counts for a bake of its light.
#include "bake/BakedScene.h"

#include "base/Hasher.h"
#include "base/Matrices.h"
#include "rays/RayPart.h"
#include "rays/TexturePixels.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cstring>

namespace penumbra
{
namespace
{
/// As numbers that a double holds.
void Append(std::vector<double>& values, std::uint64_t hash)
{
  values.push_back(static_cast<double>(hash >> 32));
  values.push_back(static_cast<double>(hash & 0xffffffffu));
}

template <typename Make>
std::uint64_t Cached(BakedSceneCache& cache, int kind, std::uint64_t key,
  const std::array<std::uint64_t, 2>& times, const Make& make)
{
  auto& entry = cache.Hashes[{ kind, key }];
  if (entry.Value == 0 || entry.Times != times)
  {
    entry.Times = times;
    entry.Value = make();
  }
  return entry.Value;
}

std::uint64_t ShapeOf(const RayPart& part, BakedSceneCache& cache)
{
  Hasher hash;
  hash.AddValue(Cached(cache, 0, part.MeshKey, { part.CellTime, part.PointTime }, [&part] {
    const RayGeometry geometry = part.MakeGeometry();
    Hasher shape;
    shape.AddValue(geometry.Origin);
    shape.Add(geometry.Points);
    shape.Add(geometry.Triangles);
    shape.Add(geometry.Spheres);
    for (const RayCylinder& cylinder : geometry.Cylinders)
    {
      shape.AddValue(cylinder.End0);
      shape.AddValue(cylinder.End1);
      shape.AddValue(cylinder.Radius);
      shape.AddValue(cylinder.Capped ? 1 : 0);
    }
    return shape.Get();
  }));
  hash.Add(part.Clip);
  if (part.Places)
  {
    for (const RayPlace& place : *part.Places)
    {
      hash.AddValue(place.Turn);
      hash.AddValue(place.Color);
      hash.AddValue(place.At);
    }
  }
  return hash.Get();
}

std::uint64_t PictureHash(vtkTexture* texture, BakedSceneCache& cache)
{
  const auto key = reinterpret_cast<std::uintptr_t>(texture);
  return Cached(cache, 2, key, { TextureTime(texture), 0 }, [texture] {
    Hasher hash;
    for (int face = 0; face < (texture->GetCubeMap() ? 6 : 1); ++face)
    {
      const TexturePixels pixels = ReadTexturePixels(texture, face);
      hash.AddValue(pixels.Width);
      hash.Add(pixels.Bytes);
      hash.Add(pixels.Floats);
    }
    return hash.Get();
  });
}

std::uint64_t LookOf(const RayPart& part, BakedSceneCache& cache)
{
  Hasher hash;
  hash.AddValue(part.Surface);
  if (part.HasBack)
  {
    hash.AddValue(part.Back);
  }
  for (vtkTexture* texture : part.Pictures)
  {
    hash.AddValue(texture ? PictureHash(texture, cache) : 0);
  }
  hash.AddValue(Cached(cache, 1, part.AttributeKey, { part.AttributeTime, 0 }, [&part] {
    const RayAttributes attributes = part.MakeAttributes();
    Hasher look;
    look.Add(attributes.Primitives);
    look.Add(attributes.Points);
    return look.Get();
  }));
  return hash.Get();
}
}

bool BakedScene::AddProps(
  vtkRenderer* renderer, BakedSceneCache& cache, const Namer& name, std::vector<Thing>& things)
{
  std::vector<vtkProp*> left;
  vtkProp* last = nullptr;
  int number = 0;
  bool solid = true;
  for (const RayPart& part : GatherRayParts(renderer, left, cache.Parts))
  {
    if (part.Prop != last)
    {
      last = part.Prop;
      ++number;
      solid = solid && !last->HasTranslucentPolygonalGeometry();
      const std::string given = name ? name(last) : "";
      things.push_back({ Prop, given.empty() ? "object " + std::to_string(number) : given, {} });
    }
    Thing& thing = things.back();
    const double* matrix = &part.ToWorld[0][0];
    auto& where = thing.Values[0];
    constexpr std::size_t size = 16;
    if (where.size() < size || !std::equal(matrix, matrix + size, where.end() - size))
    {
      where.insert(where.end(), matrix, matrix + size);
    }
    Append(thing.Values[1], ShapeOf(part, cache));
    Append(thing.Values[2], LookOf(part, cache));
    solid = solid && part.Clip.empty() && (part.Surface.Where.z & GI_SURFACE_PARTLY) == 0;
  }
  return solid;
}

void BakedScene::AddLamps(vtkRenderer* renderer, std::vector<Thing>& things)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator cookie;
  lights->InitTraversal(cookie);
  int number = 0;
  while (vtkLight* light = lights->GetNextLight(cookie))
  {
    ++number;
    const glm::dvec3 color = ToVec3(light->GetDiffuseColor()) * light->GetIntensity();
    // Those that follow the camera have no place in a bake.
    if (!light->GetSwitch() || color == glm::dvec3(0.0) || !light->LightTypeIsSceneLight())
    {
      continue;
    }
    double position[3];
    double focal[3];
    light->GetTransformedPosition(position);
    light->GetTransformedFocalPoint(focal);
    const glm::dvec3 travel = ToVec3(focal) - ToVec3(position);
    const bool positional = light->GetPositional() != 0;
    const bool cone = positional && light->GetConeAngle() < 90.0;
    Thing lamp{ Lamp, "light " + std::to_string(number), {} };
    auto& where = lamp.Values[0];
    if (positional)
    {
      where.insert(where.end(), position, position + 3);
    }
    if (!positional || cone)
    {
      const glm::dvec3 direction = travel / std::max(glm::length(travel), 1e-300);
      const double scale = positional ? glm::length(ToVec3(position)) : 1.0;
      const glm::dvec3 scaled = direction * std::max(scale, 1e-300);
      where.insert(where.end(), { scaled.x, scaled.y, scaled.z });
    }
    lamp.Values[1] = { color.x, color.y, color.z };
    lamp.Values[2] = { double(positional), cone ? light->GetConeAngle() : 90.0,
      cone ? light->GetExponent() : 1.0 };
    if (positional)
    {
      const double* fall = light->GetAttenuationValues();
      lamp.Values[2].insert(lamp.Values[2].end(), fall, fall + 3);
    }
    things.push_back(lamp);
  }
}

void BakedScene::AddSurroundings(
  vtkRenderer* renderer, BakedSceneCache& cache, std::vector<Thing>& things)
{
  vtkTexture* picture = renderer->GetEnvironmentTexture();
  if (!picture || !renderer->GetUseImageBasedLighting())
  {
    return;
  }
  Thing thing{ Surroundings, "the environment", {} };
  for (const double* axis : { renderer->GetEnvironmentUp(), renderer->GetEnvironmentRight() })
  {
    thing.Values[0].insert(thing.Values[0].end(), axis, axis + 3);
  }
  Append(thing.Values[1], PictureHash(picture, cache));
  things.push_back(thing);
}

BakedScene BakedScene::Of(vtkRenderer* renderer, BakedSceneCache& cache, const Namer& name)
{
  BakedScene scene;
  AddProps(renderer, cache, name, scene.Things);
  AddLamps(renderer, scene.Things);
  AddSurroundings(renderer, cache, scene.Things);
  return scene;
}
}
