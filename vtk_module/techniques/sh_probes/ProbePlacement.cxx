// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/sh_probes/ProbePlacement.h"

#include "bake/GatherStage.h"

#include "gathering.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace penumbra
{
namespace
{
using Clock = std::chrono::steady_clock;

constexpr int Texels = ProbeField::DistanceTexels;
constexpr int MapTexels = Texels * Texels;

// Rays per texel: a few while probes are being placed, more for the maps that are kept.
constexpr int PlacementRays = 2;
constexpr int MapRays = 16;

// Distance that a probe keeps from surfaces, and maximum offset from its grid point, in cells.
constexpr double Margin = 0.25;
constexpr double MaximumOffset = 0.4;
constexpr int Moves = 3;

// A probe has left a solid object if this many times more light arrives. A smaller ratio may be due to a surface whose
// winding is inverted.
constexpr double MuchBrighter = 4.0;

glm::vec3 TexelDirection(int texel)
{
  const glm::vec2 p =
    (glm::vec2(texel % Texels, texel / Texels) + 0.5f) / static_cast<float>(Texels) * 2.0f - 1.0f;
  glm::vec3 n(p, 1.0f - std::abs(p.x) - std::abs(p.y));
  const float fold = std::max(-n.z, 0.0f);
  n.x += n.x >= 0.0f ? -fold : fold;
  n.y += n.y >= 0.0f ? -fold : fold;
  return glm::normalize(n);
}

/// Trace the maps of points: mean distance, mean square and backface ratio of each texel. Returns false if aborted.
bool TraceMaps(GatherStage& stage, const std::vector<glm::dvec3>& points, int rays, double reach,
  std::vector<glm::vec3>& maps, const ProbeProgress& progress)
{
  maps.resize(points.size() * MapTexels);
  WorkSize work(8);
  for (std::size_t first = 0; first < points.size();)
  {
    const auto start = Clock::now();
    const std::size_t count = std::min(points.size() - first, work.Get());
    std::vector<shared::GatherPoint> data(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      data[i].Position = glm::vec4(glm::vec3(points[first + i] - stage.Origin()), 0.0f);
    }
    stage.Points.Upload(GL_SHADER_STORAGE_BUFFER, data.data(), count * sizeof(data[0]));
    std::vector<float> found(count * MapTexels * 3, 0.0f);
    stage.Results.Upload(GL_SHADER_STORAGE_BUFFER, found.data(), found.size() * sizeof(found[0]));
    stage.Run("gathering/distances.comp", {},
      Arguments()
        .Set("pointCount", static_cast<int>(count))
        .Set("firstPoint", static_cast<int>(first))
        .Set("texels", Texels)
        .Set("samples", rays)
        .Set("farthest", reach),
      count * MapTexels / GI_GATHER_GROUP);
    stage.Read(found);
    for (std::size_t i = 0; i < count * MapTexels; ++i)
    {
      maps[first * MapTexels + i] = { found[3 * i], found[3 * i + 1], found[3 * i + 2] };
    }
    work.Adapt(count, std::chrono::duration<double>(Clock::now() - start).count());
    first += count;
    if (!progress(static_cast<double>(first) / static_cast<double>(points.size())))
    {
      return false;
    }
  }
  return true;
}

/// Summary of a probe's map.
struct MapSummary
{
  int Nearest = 0; ///< texel
  double Backs = 0.0;
};

MapSummary Summarize(const glm::vec3* map)
{
  MapSummary summary;
  for (int texel = 0; texel < MapTexels; ++texel)
  {
    summary.Backs += map[texel].z / MapTexels;
    summary.Nearest = map[texel].x < map[summary.Nearest].x ? texel : summary.Nearest;
  }
  return summary;
}

/// Visibility between the points of each pair: 1 or 0.
std::vector<float> PairVisibility(GatherStage& stage, const std::vector<shared::GatherPoint>& pairs)
{
  constexpr std::size_t most = 1 << 20; // per dispatch, as buffers may be limited to 128 MB
  std::vector<float> visible;
  for (std::size_t first = 0; first < pairs.size(); first += most)
  {
    const std::size_t count = std::min(pairs.size() - first, most);
    std::vector<float> found(count, 0.0f);
    stage.Points.Upload(GL_SHADER_STORAGE_BUFFER, &pairs[first], count * sizeof(pairs[0]));
    stage.Results.Upload(GL_SHADER_STORAGE_BUFFER, found.data(), count * sizeof(found[0]));
    stage.Run("gathering/sight.comp", {}, Arguments().Set("pointCount", static_cast<int>(count)),
      (count + GI_GATHER_GROUP - 1) / GI_GATHER_GROUP);
    stage.Read(found);
    visible.insert(visible.end(), found.begin(), found.end());
  }
  return visible;
}

/// Limit an offset in cells to the allowed range.
glm::vec3 ClampOffset(const glm::dvec3& offset)
{
  return glm::vec3(glm::clamp(offset, -MaximumOffset, MaximumOffset));
}
}

bool PlaceProbes(GatherStage& stage, ProbeField& field, int number,
  const std::function<std::vector<double>(const std::vector<glm::dvec3>&)>& brightness,
  const ProbeProgress& progress)
{
  const glm::dvec3 spacing = field.Grids.Get(number).Spacing;
  const double reach = field.Reach(number);
  const int first = field.Grids.Begin(number);
  const int last = field.Grids.Begin(number + 1);
  const double cell = std::min({ spacing.x, spacing.y, spacing.z });
  std::vector<glm::vec3> maps;
  for (int move = 0; move < Moves; ++move)
  {
    const auto part = [&](double done) { return progress((move + done) / Moves); };
    if (!TraceMaps(stage, field.Positions(first, last), PlacementRays, reach, maps, part))
    {
      return false;
    }
    std::vector<int> leaving; // probes that may be inside a solid object
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> before = field.Offsets;
    for (int probe = first; probe < last; ++probe)
    {
      const glm::vec3* map = &maps[static_cast<std::size_t>(probe - first) * MapTexels];
      const MapSummary summary = Summarize(map);
      const glm::dvec3 toward(TexelDirection(summary.Nearest));
      const double distance = map[summary.Nearest].x;
      const bool inside = summary.Backs > SolidBackfaceRatio && map[summary.Nearest].z > 0.5f;
      glm::dvec3 step(0.0);
      if (inside)
      {
        step = toward * (distance + Margin * cell);
      }
      else if (distance < Margin * cell)
      {
        // At most half of the way to the surface behind.
        double behind = reach;
        for (int texel = 0; texel < MapTexels; ++texel)
        {
          const bool opposite = glm::dot(glm::dvec3(TexelDirection(texel)), toward) < -0.7;
          behind = opposite ? std::min(behind, static_cast<double>(map[texel].x)) : behind;
        }
        step =
          -toward * std::min(Margin * cell - distance, std::max(0.5 * (behind - distance), 0.0));
      }
      const glm::dvec3 moved = glm::dvec3(field.Offsets[probe]) + step / spacing;
      if (inside)
      {
        // Leave only if the new position is within the allowed offset.
        if (glm::all(glm::lessThanEqual(glm::abs(moved), glm::dvec3(MaximumOffset))))
        {
          leaving.push_back(probe);
          positions.push_back(field.Position(probe));
          field.Offsets[probe] = ClampOffset(moved);
          positions.push_back(field.Position(probe));
        }
      }
      else
      {
        field.Offsets[probe] = ClampOffset(moved);
      }
    }
    const std::vector<double> light =
      positions.empty() ? std::vector<double>() : brightness(positions);
    for (std::size_t i = 0; i < leaving.size() && light.size() == positions.size(); ++i)
    {
      const bool escaped = light[2 * i + 1] > MuchBrighter * light[2 * i];
      field.Offsets[leaving[i]] = escaped ? field.Offsets[leaving[i]] : before[leaving[i]];
    }
  }
  return true;
}

bool TraceVisibility(
  GatherStage& stage, ProbeField& field, int number, const ProbeProgress& progress)
{
  const ProbeGrid& grid = field.Grids.Get(number);
  const double reach = field.Reach(number);
  const int first = field.Grids.Begin(number);
  const int count = grid.Size();
  std::vector<glm::vec3> maps;
  const std::vector<glm::dvec3> points = field.Positions(first, first + count);
  if (!TraceMaps(stage, points, MapRays, reach, maps, progress))
  {
    return false;
  }
  float* distances = &field.Distance[static_cast<std::size_t>(first) * ProbeField::Distances];
  for (std::size_t i = 0; i < maps.size(); ++i)
  {
    const double mean = maps[i].x / reach;
    const double square = maps[i].y / (reach * reach);
    distances[2 * i] = static_cast<float>(mean);
    distances[2 * i + 1] = static_cast<float>(std::sqrt(std::max(square - mean * mean, 0.0)));
  }
  std::vector<shared::GatherPoint> pairs;
  std::vector<std::pair<int, int>> bits;
  const auto neighbours = ProbeNeighbours();
  for (int probe = 0; probe < count; ++probe)
  {
    field.Backs[first + probe] =
      static_cast<float>(Summarize(&maps[static_cast<std::size_t>(probe) * MapTexels]).Backs);
    for (int bit = 0; bit < 13; ++bit)
    {
      const glm::ivec3 other = grid.Cell(probe) + neighbours[bit];
      if (glm::all(glm::greaterThanEqual(other, glm::ivec3(0))) &&
        glm::all(glm::lessThan(other, grid.Counts)))
      {
        pairs.push_back({ glm::vec4(glm::vec3(points[probe] - stage.Origin()), 0.0f),
          glm::vec4(glm::vec3(points[grid.Probe(other)] - stage.Origin()), 0.0f) });
        bits.emplace_back(first + probe, bit);
      }
    }
  }
  std::fill_n(field.Sight.begin() + first, count, 0);
  const std::vector<float> visible = PairVisibility(stage, pairs);
  for (std::size_t i = 0; i < bits.size(); ++i)
  {
    field.Sight[bits[i].first] |= visible[i] > 0.5f ? 1 << bits[i].second : 0;
  }
  return true;
}
}
