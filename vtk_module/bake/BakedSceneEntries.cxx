// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads the entries of a BakedScene from a renderer.
#include "bake/BakedScene.h"

#include "base/Hasher.h"
#include "base/Matrices.h"
#include "rays/RayPart.h"
#include "rays/TexturePixels.h"

#include "vtkGILightShape.h"
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
/// Append a hash as numbers that a double represents exactly.
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

std::uint64_t ShapeHash(const RayPart& part, BakedSceneCache& cache)
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

std::uint64_t AppearanceHash(const RayPart& part, BakedSceneCache& cache)
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
  vtkRenderer* renderer, BakedSceneCache& cache, const Namer& name, std::vector<Entry>& entries)
{
  std::vector<vtkProp*> untraceable;
  vtkProp* last = nullptr;
  int number = 0;
  bool solid = true;
  for (const RayPart& part : GatherRayParts(renderer, untraceable, cache.Parts))
  {
    if (part.Prop != last)
    {
      last = part.Prop;
      ++number;
      solid = solid && !last->HasTranslucentPolygonalGeometry();
      const std::string givenName = name ? name(last) : "";
      entries.push_back(
        { Prop, givenName.empty() ? "object " + std::to_string(number) : givenName, {} });
    }
    Entry& entry = entries.back();
    const double* matrix = &part.ToWorld[0][0];
    auto& position = entry.Values[0];
    constexpr std::size_t size = 16;
    if (position.size() < size || !std::equal(matrix, matrix + size, position.end() - size))
    {
      position.insert(position.end(), matrix, matrix + size);
    }
    Append(entry.Values[1], ShapeHash(part, cache));
    Append(entry.Values[2], AppearanceHash(part, cache));
    solid = solid && part.Clip.empty() && (part.Surface.Where.z & GI_SURFACE_PARTLY) == 0;
  }
  return solid;
}

void BakedScene::AddLights(vtkRenderer* renderer, std::vector<Entry>& entries)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator cookie;
  lights->InitTraversal(cookie);
  int number = 0;
  while (vtkLight* light = lights->GetNextLight(cookie))
  {
    ++number;
    const glm::dvec3 color = ToVec3(light->GetDiffuseColor()) * light->GetIntensity();
    // Lights that follow the camera are not baked.
    if (!light->GetSwitch() || color == glm::dvec3(0.0) || !light->LightTypeIsSceneLight())
    {
      continue;
    }
    double origin[3];
    double focal[3];
    light->GetTransformedPosition(origin);
    light->GetTransformedFocalPoint(focal);
    const glm::dvec3 travel = ToVec3(focal) - ToVec3(origin);
    const bool positional = light->GetPositional() != 0;
    const bool cone = positional && light->GetConeAngle() < 90.0;
    Entry entry{ LightSource, "light " + std::to_string(number), {} };
    auto& position = entry.Values[0];
    if (positional)
    {
      position.insert(position.end(), origin, origin + 3);
    }
    if (!positional || cone)
    {
      const glm::dvec3 direction = travel / std::max(glm::length(travel), 1e-300);
      const double scale = positional ? glm::length(ToVec3(origin)) : 1.0;
      const glm::dvec3 scaled = direction * std::max(scale, 1e-300);
      position.insert(position.end(), { scaled.x, scaled.y, scaled.z });
    }
    entry.Values[1] = { color.x, color.y, color.z };
    entry.Values[2] = { double(positional), cone ? light->GetConeAngle() : 90.0,
      cone ? light->GetExponent() : 1.0 };
    if (positional)
    {
      const double* attenuation = light->GetAttenuationValues();
      entry.Values[2].insert(entry.Values[2].end(), attenuation, attenuation + 3);
    }
    const int shape = vtkGILightShape::GetShape(light);
    if (shape > vtkGILightShape::POINT)
    {
      entry.Values[2].insert(entry.Values[2].end(),
        { double(shape), vtkGILightShape::GetAngle(light), vtkGILightShape::GetRadius(light),
          vtkGILightShape::GetWidth(light), vtkGILightShape::GetHeight(light),
          vtkGILightShape::GetTurn(light) });
    }
    entries.push_back(entry);
  }
}

void BakedScene::AddEnvironment(
  vtkRenderer* renderer, BakedSceneCache& cache, std::vector<Entry>& entries)
{
  vtkTexture* picture = renderer->GetEnvironmentTexture();
  if (!picture || !renderer->GetUseImageBasedLighting())
  {
    return;
  }
  Entry entry{ Environment, "the environment", {} };
  for (const double* axis : { renderer->GetEnvironmentUp(), renderer->GetEnvironmentRight() })
  {
    entry.Values[0].insert(entry.Values[0].end(), axis, axis + 3);
  }
  Append(entry.Values[1], PictureHash(picture, cache));
  entries.push_back(entry);
}

BakedScene BakedScene::Of(vtkRenderer* renderer, BakedSceneCache& cache, const Namer& name)
{
  BakedScene scene;
  AddProps(renderer, cache, name, scene.Entries);
  AddLights(renderer, scene.Entries);
  AddEnvironment(renderer, cache, scene.Entries);
  return scene;
}
}
