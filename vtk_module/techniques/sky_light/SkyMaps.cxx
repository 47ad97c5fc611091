// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/sky_light/SkyMaps.h"

#include "base/Luminance.h"
#include "capture/SceneCapture.h"
#include "graph/FrameContext.h"

#include "vtkOpenGLRenderer.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// Margin in texels: lookups read the neighbours of the outermost texel.
constexpr double Margin = 2.0;
// Maps are replaced if their weights are so uneven that they are worth less than this share of their number.
constexpr double LeastWorth = 0.4;

int Columns(int maps)
{
  return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(maps))));
}
}

int SkyMaps::AtlasWidth(const Settings& settings)
{
  return Columns(settings.Maps) * settings.MapSize;
}

void SkyMaps::Restart(const SceneCapture& scene, const Settings& settings)
{
  *this = SkyMaps();
  this->Current = settings;
  this->Bounds = BoundsOfCasters(scene);
  const auto& b = this->Bounds.Effective;
  this->Middle = { 0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]) };
}

void SkyMaps::Draw(FrameContext& context, SceneCapture& scene, const History& atlas,
  const SkyDirections& sky, bool skyChanged, const Settings& settings)
{
  const View& view = context.GetView();
  const bool restarts = !atlas.Written || this->Maps.empty() || !(this->Current == settings) ||
    this->Casters != CasterSignature(scene) || (view.StandsAlone && !this->AreFirst);
  if (restarts)
  {
    this->Restart(scene, settings);
  }
  this->Current = settings;
  this->DrawnMaps = 0;
  if (this->Bounds.Empty)
  {
    return;
  }
  if (skyChanged && !restarts)
  {
    this->Weigh(sky);
  }
  const bool still = view.StillFrames > 0;
  const int missing = settings.Maps - this->Count();
  int count = restarts || still ? settings.FirstMaps : settings.MapsPerFrame;
  if (missing > 0)
  {
    count = view.StandsAlone ? missing : std::min(missing, count);
  }
  else
  {
    count = still ? settings.NewMaps : std::min(count, this->Outdated);
  }
  for (int i = 0; i < count; ++i)
  {
    this->DrawNext(context, scene, atlas, sky);
  }
  if (context.Renderer()->GetRenderWindow()->GetAbortRender())
  {
    *this = SkyMaps(); // maps may lack casters
    return;
  }
  if (this->DrawnMaps > 0)
  {
    this->Casters = CasterSignature(scene); // drawing updates pipelines
  }
}

void SkyMaps::DrawNext(
  FrameContext& context, SceneCapture& scene, const History& atlas, const SkyDirections& sky)
{
  const int size = this->Current.MapSize;
  const int columns = Columns(this->Current.Maps);
  const int slot =
    static_cast<int>(this->NextDirection % static_cast<unsigned int>(this->Current.Maps));
  Map map;
  map.Direction = sky.Draw(this->NextDirection++);
  map.Weight = sky.Radiance(map.Direction.Toward) / map.Direction.Density;
  map.Tile = { slot % columns * size, slot / columns * size, size };
  map.View =
    FitDirection(-map.Direction.Toward, this->Bounds.Effective, this->Bounds.All, size, Margin);
  DrawShadowMap(context, scene, atlas.Storage, map.View, map.Tile, { map.Tile.X, map.Tile.Y });
  ++this->DrawnMaps;
  if (slot == this->Count())
  {
    this->Maps.push_back(map);
  }
  else
  {
    this->AreFirst = false;
    this->Maps[static_cast<std::size_t>(slot)] = map;
  }
  this->Outdated = std::max(0, this->Outdated - 1);
}

void SkyMaps::Weigh(const SkyDirections& sky)
{
  this->AreFirst = false;
  double sum = 0.0;
  double squares = 0.0;
  for (Map& map : this->Maps)
  {
    map.Weight = sky.Radiance(map.Direction.Toward) / map.Direction.Density;
    const double weight = Luminance(map.Weight.x, map.Weight.y, map.Weight.z);
    sum += weight;
    squares += weight * weight;
  }
  // Kish's effective number of samples.
  const bool uneven = sum * sum < LeastWorth * squares * this->Count();
  this->Outdated = uneven ? this->Current.Maps : this->Outdated;
}

std::vector<glm::vec4> SkyMaps::Data(int first, int count) const
{
  if (this->Maps.empty())
  {
    return std::vector<glm::vec4>(static_cast<std::size_t>(4) * count, glm::vec4(0.0f));
  }
  double mean = 0.0; // so that half floats hold the sums of any sky
  for (const Map& map : this->Maps)
  {
    mean += Luminance(map.Weight.x, map.Weight.y, map.Weight.z) / this->Count();
  }
  std::vector<glm::vec4> data;
  for (int i = 0; i < count; ++i)
  {
    const Map& map = this->Maps[static_cast<std::size_t>((first + i) % this->Count())];
    const ShadowView& view = map.View;
    const glm::dmat3 rows = glm::transpose(glm::dmat3(view.WorldToView));
    const double toDepth = 1.0 / (view.Far - view.Near);
    const double half = 0.5 * map.Tile.Size;
    data.emplace_back(glm::vec3(rows[0] / view.Texel), map.Tile.X + half);
    data.emplace_back(glm::vec3(rows[1] / view.Texel), map.Tile.Y + half);
    data.emplace_back(glm::vec3(-rows[2] * toDepth), -view.Near * toDepth);
    data.emplace_back(
      glm::vec3(map.Weight / std::max(mean, 1e-30) / toDepth), view.Texel * toDepth);
  }
  return data;
}
}
