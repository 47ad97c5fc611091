// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/Texels.h"

#include "bake/lightmap/Overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace penumbra::lightmap
{
namespace
{
/// Barycentric coordinates of the point of a triangle nearest to p.
Vec3 NearestPoint(const Flat& t, const Vec2& p, double& distance2)
{
  const double area = (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y);
  Vec3 share(0.0);
  for (int k = 0; k < 3 && area != 0.0; ++k)
  {
    const Vec2& a = t[(k + 1) % 3];
    const Vec2& b = t[(k + 2) % 3];
    share[k] = ((a.x - p.x) * (b.y - p.y) - (b.x - p.x) * (a.y - p.y)) / area;
  }
  if (area != 0.0 && share.x >= 0.0 && share.y >= 0.0 && share.z >= 0.0)
  {
    distance2 = 0.0;
    return share;
  }
  distance2 = std::numeric_limits<double>::max();
  for (int k = 0; k < 3; ++k)
  {
    const Vec2 along = t[(k + 1) % 3] - t[k];
    const double length2 = glm::dot(along, along);
    const double u =
      length2 > 0.0 ? std::clamp(glm::dot(p - t[k], along) / length2, 0.0, 1.0) : 0.0;
    const Vec2 off = t[k] + u * along - p;
    if (glm::dot(off, off) < distance2)
    {
      distance2 = glm::dot(off, off);
      share = Vec3(0.0);
      share[k] = 1.0 - u;
      share[(k + 1) % 3] = u;
    }
  }
  return share;
}

/// Moves a point from the edges into the triangle. At an edge between two walls, rays would start in the plane of the other
/// wall. inset: distance in units of the triangle.
Vec3 Inset(const Flat& t, const Vec3& share, double inset)
{
  const double twice =
    std::abs((t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y));
  Vec3 least(0.0);
  constexpr double most = 0.25; // of a barycentric coordinate, for small triangles
  for (int k = 0; k < 3 && twice > 0.0; ++k)
  {
    const double height = twice / std::max(glm::length(t[(k + 2) % 3] - t[(k + 1) % 3]), 1e-300);
    least[k] = std::min(inset / height, most);
  }
  const double rest = 1.0 - least.x - least.y - least.z;
  return least + rest * share;
}

/// The offset from a flat triangle to the curved surface of its normals, as in the ray tracing shaders (Hanika 2021, Hacking
/// the Shadow Terminator).
Vec3 Lift(const Surfaces& surfaces, const Triangle& triangle, const Vec3& share, const Vec3& at,
  double side)
{
  Vec3 lift(0.0);
  for (int k = 0; k < 3; ++k)
  {
    const Vec3 outside = side * triangle.Normals[k];
    const double above = glm::dot(at - surfaces.Points[triangle.Points[k]], outside);
    lift -= share[k] * std::min(above, 0.0) * outside;
  }
  return lift;
}

void PointOn(const Surfaces& surfaces, const Triangle& triangle, const Vec3& share, bool back,
  Vec3& at, Vec3& normal)
{
  at = normal = Vec3(0.0);
  for (int k = 0; k < 3; ++k)
  {
    at += share[k] * surfaces.Points[triangle.Points[k]];
    normal += share[k] * triangle.Normals[k];
  }
  const double side = back ? -1.0 : 1.0;
  normal = side * (glm::length(normal) > 0.0 ? glm::normalize(normal) : triangle.Normal);
  at += Lift(surfaces, triangle, share, at, side);
}

Flat InTexels(
  const Surfaces& surfaces, const Chart& chart, const Tile& tile, const Triangle& triangle)
{
  Flat flat;
  for (int k = 0; k < 3; ++k)
  {
    flat[k] = tile.ToTexels(chart, chart.Project(surfaces.Points[triangle.Points[k]]));
  }
  return flat;
}

struct Candidate
{
  double Distance2 = std::numeric_limits<double>::max();
  std::uint32_t Triangle = 0;
  Vec3 Share{ 0.0 };
};
}

std::vector<Texel> PlaceTexels(
  const Surfaces& surfaces, const std::vector<Chart>& charts, const Atlas& atlas, const Vec2& shift)
{
  constexpr double reach2 = 2.0; // squared distance within which interpolation uses a texel
  constexpr double inset = 0.02; // texels
  std::vector<Texel> texels;
  for (std::uint32_t index = 0; index < atlas.Tiles.size(); ++index)
  {
    const Tile& tile = atlas.Tiles[index];
    const Chart& chart = charts[tile.Chart];
    std::vector<Candidate> found(static_cast<std::size_t>(tile.Texels.x) * tile.Texels.y);
    for (const std::uint32_t t : chart.Triangles)
    {
      const Flat flat = InTexels(surfaces, chart, tile, surfaces.Triangles[t]);
      const Vec2 low = glm::min(glm::min(flat[0], flat[1]), flat[2]) - 1.0;
      const Vec2 high = glm::max(glm::max(flat[0], flat[1]), flat[2]) + 1.0;
      const glm::ivec2 first = glm::max(glm::ivec2(glm::ceil(low)), glm::ivec2(0));
      const glm::ivec2 last = glm::min(glm::ivec2(glm::floor(high)), tile.Texels - 1);
      for (int y = first.y; y <= last.y; ++y)
      {
        for (int x = first.x; x <= last.x; ++x)
        {
          Candidate& best = found[static_cast<std::size_t>(y) * tile.Texels.x + x];
          double distance2 = 0.0;
          Vec3 share = NearestPoint(flat, Vec2(x, y), distance2);
          if (distance2 >= reach2)
          {
            continue;
          }
          if (shift != Vec2(0.0))
          {
            share = NearestPoint(flat, Vec2(x, y) + shift, distance2);
          }
          if (distance2 < best.Distance2)
          {
            best = { distance2, t, Inset(flat, share, inset) };
          }
        }
      }
    }
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      if (found[i].Distance2 < std::numeric_limits<double>::max())
      {
        Texel texel;
        const int x = static_cast<int>(i) % tile.Texels.x;
        const int y = static_cast<int>(i) / tile.Texels.x;
        texel.Index = static_cast<std::uint32_t>((tile.At.y + y) * atlas.Width + tile.At.x + x);
        texel.Tile = index;
        PointOn(surfaces, surfaces.Triangles[found[i].Triangle], found[i].Share, tile.Back,
          texel.At, texel.Normal);
        texels.push_back(texel);
      }
    }
  }
  return texels;
}

void ScatterPoints(const Surfaces& surfaces, const Chart& chart, bool back, int count,
  std::vector<Vec3>& points, std::vector<Vec3>& normals)
{
  double total = 0.0;
  for (const std::uint32_t t : chart.Triangles)
  {
    total += surfaces.Triangles[t].Area;
  }
  double passed = 0.0;
  int made = 0;
  for (const std::uint32_t t : chart.Triangles)
  {
    passed += surfaces.Triangles[t].Area;
    for (; made < count && (made + 0.5) * total <= passed * count; ++made)
    {
      // The sequence of the plastic number (Roberts 2018), folded into the triangle.
      Vec2 u(std::fmod(0.5 + 0.7548776662466927 * (made + 1), 1.0),
        std::fmod(0.5 + 0.5698402909980532 * (made + 1), 1.0));
      u = u.x + u.y > 1.0 ? 1.0 - u : u;
      Vec3 at, normal;
      PointOn(surfaces, surfaces.Triangles[t], { 1.0 - u.x - u.y, u.x, u.y }, back, at, normal);
      points.push_back(at);
      normals.push_back(normal);
    }
  }
}

std::vector<SeamLine> PlaceSeams(const Surfaces& surfaces, const std::vector<Chart>& charts,
  const Atlas& atlas, const std::vector<Seam>& seams)
{
  std::map<std::pair<std::uint32_t, bool>, std::uint32_t> tiles;
  for (std::uint32_t i = 0; i < atlas.Tiles.size(); ++i)
  {
    tiles[{ atlas.Tiles[i].Chart, atlas.Tiles[i].Back }] = i;
  }
  std::vector<SeamLine> lines;
  for (const Seam& seam : seams)
  {
    for (const bool back : { false, true })
    {
      SeamLine line;
      bool both = true;
      for (int s = 0; s < 2 && both; ++s)
      {
        const std::uint32_t t = seam.Triangles[s];
        const auto found = tiles.find({ seam.Charts[s], s == 1 && seam.Turned ? !back : back });
        both = found != tiles.end();
        if (!both)
        {
          break;
        }
        line.Tiles[s] = found->second;
        const Tile& tile = atlas.Tiles[found->second];
        const Flat flat = InTexels(surfaces, charts[seam.Charts[s]], tile, surfaces.Triangles[t]);
        // The edge is reversed in the other triangle, unless that has opposite winding.
        const bool reversed = s == 1 && !seam.Turned;
        for (int end = 0; end < 2; ++end)
        {
          const int corner = (seam.Edges[s] + (reversed ? 1 - end : end)) % 3;
          line.Ends[s][end] = flat[corner] + Vec2(tile.At);
        }
      }
      if (both)
      {
        lines.push_back(line);
      }
    }
  }
  return lines;
}
}
