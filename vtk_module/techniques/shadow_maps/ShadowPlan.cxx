// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/shadow_maps/ShadowPlan.h"

#include "light/LightTable.h"
#include "technique/FrameBuilder.h"
#include "techniques/shadow_maps/ShadowCascades.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// Width in texels below which a map is useless.
constexpr int MinimumWidth = 64;

int MaximumHalvings(int resolution)
{
  int halvings = 0;
  while (resolution >> (halvings + 1) >= MinimumWidth)
  {
    ++halvings;
  }
  return halvings;
}

// Maximum brightness of the light within the bounds.
double Importance(const Light& light, const Bounds& bounds)
{
  double attenuation = 1.0;
  if (light.Positional)
  {
    const double distance = DistanceRange(light.WorldPosition, bounds).x;
    const glm::dvec3& c = light.Attenuation;
    attenuation = c.x + c.y * distance + c.z * distance * distance;
  }
  return glm::length(light.Color) / std::max(attenuation, 1e-12);
}

// Transform from clip space, [-1, 1], to the tile's part of the atlas and depth [0, 1].
glm::dmat4 ToTile(const AtlasTile& tile, double width, double height)
{
  const glm::dvec3 size(tile.Size / width, tile.Size / height, 1.0);
  const glm::dvec3 low(tile.X / width, tile.Y / height, 0.0);
  return glm::translate(glm::dmat4(1.0), low + 0.5 * size) *
    glm::scale(glm::dmat4(1.0), 0.5 * size);
}

/// The size and shape of a light, for its penumbrae.
void SetShape(const Light& light, const ShadowOptions& options, shared::ShadowLightData& data)
{
  double size = light.Positional ? options.LightRadius : options.LightTangent;
  size = light.Shape == GI_SHAPE_POINT ? 0.0 : size;
  size = light.Shape == GI_SHAPE_ANGLE ? std::tan(light.Size) : size;
  size = light.Shape == GI_SHAPE_SPHERE ? light.Size : size;
  data.Side = glm::vec4(0.0);
  data.Up = glm::vec4(0.0);
  if (light.IsFlat())
  {
    size = std::max(glm::length(light.Side), glm::length(light.Up));
    data.Side = glm::vec4(light.Side / size, 0.0);
    data.Up = glm::vec4(light.Up / size, 0.0);
  }
  data.Size = glm::vec4(size,
    !light.IsFlat()                  ? GI_OUTLINE_ROUND
      : light.Shape == GI_SHAPE_DISC ? GI_OUTLINE_ELLIPSE
                                     : GI_OUTLINE_PARALLELOGRAM,
    0.0, 0.0);
}

shared::ShadowMapData MapData(const ShadowMap& map, const ShadowPlan& plan, const View& view)
{
  const AtlasTile& tile = map.Tile;
  const glm::dvec4 size(plan.Width, plan.Height, plan.Width, plan.Height);
  shared::ShadowMapData data;
  data.ViewToMap = glm::mat4(ToTile(tile, plan.Width, plan.Height) * map.View.ViewToClip *
    map.View.WorldToView * view.ViewToWorld);
  data.Area = glm::vec4(
    glm::dvec4(tile.X + 0.5, tile.Y + 0.5, tile.X + tile.Size - 0.5, tile.Y + tile.Size - 0.5) /
    size);
  data.Scale = glm::vec4(map.View.Texel, map.View.Near, map.View.Far, 0.0);
  return data;
}
}

std::vector<double> ShadowMap::Signature() const
{
  std::vector<double> signature{ static_cast<double>(this->Tile.X),
    static_cast<double>(this->Tile.Y), static_cast<double>(this->Tile.Size) };
  for (const auto* matrix : { &this->View.WorldToView, &this->View.ViewToClip })
  {
    for (int i = 0; i < 16; ++i)
    {
      signature.push_back((*matrix)[i / 4][i % 4]);
    }
  }
  return signature;
}

ShadowPlan PlanShadows(const LightTable& table, const std::vector<std::size_t>& lights,
  const View& view, const ShadowOptions& options)
{
  std::vector<ShadowCascades> cascades;
  std::vector<AtlasRequest> requests;
  for (const std::size_t index : lights)
  {
    const Light& light = table.Lights()[index];
    cascades.push_back(ChooseCascades(
      light, view, { options.Cascades, options.Resolution, options.Margin, options.Logarithmic }));
    const auto count = static_cast<int>(cascades.back().Spheres.size());
    const int maps = count > 0 ? count : CountShadowViews(light, view.Bounds);
    requests.push_back({ maps, maps > 1 ? 1 : 0, Importance(light, view.Bounds) });
  }
  const std::vector<int> halvings =
    DistributeShadowAtlas(requests, options.Squares, MaximumHalvings(options.Resolution));
  std::vector<int> sizes;
  for (std::size_t i = 0; i < halvings.size(); ++i)
  {
    sizes.insert(sizes.end(), requests[i].Maps, halvings[i]);
  }
  const ShadowAtlas atlas = PackShadowAtlas(options.Resolution, sizes);
  ShadowPlan plan;
  plan.Width = atlas.Width;
  plan.Height = atlas.Height;
  for (std::size_t i = 0; i < halvings.size(); ++i)
  {
    const Light& light = table.Lights()[lights[i]];
    const ShadowCascades& parts = cascades[i];
    const int first = static_cast<int>(plan.Maps.size());
    const int resolution = atlas.Tiles[first].Size;
    std::vector<ShadowView> views;
    for (const auto& sphere : parts.Spheres)
    {
      views.push_back(FitShadowSphere(light, view.Bounds, sphere, resolution, options.Margin));
    }
    if (views.empty())
    {
      views = FitShadowViews(light, view.Bounds, resolution, options.Margin);
    }
    shared::ShadowLightData data;
    data.Direction = glm::vec4(light.Direction, 0.0);
    data.Position = glm::vec4(light.Position, light.Positional ? 1.0 : 0.0);
    SetShape(light, options, data);
    data.Maps = glm::ivec4(first, views.size(),
      !parts.Spheres.empty() ? GI_SHADOW_CASCADES
        : views.size() == 6u ? GI_SHADOW_CUBE
                             : GI_SHADOW_SINGLE,
      0);
    data.Ends = glm::vec4(0.0);
    for (std::size_t part = 0; part < parts.Ends.size(); ++part)
    {
      data.Ends[static_cast<int>(part)] = static_cast<float>(parts.Ends[part]);
    }
    plan.LightData.push_back(data);
    for (const auto& shadowView : views)
    {
      plan.Maps.push_back({ shadowView, atlas.Tiles[plan.Maps.size()] });
      plan.MapData.push_back(MapData(plan.Maps.back(), plan, view));
    }
  }
  return plan;
}
}
