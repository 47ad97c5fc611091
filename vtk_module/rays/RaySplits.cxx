// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/RaySplits.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace penumbra
{
namespace
{
// How many times the area that a triangle shows along the axes its bounds have to show.
constexpr double LongestShape = 8.0;
constexpr int MostPieces = 64;
// Pieces cost memory and building: at most so many, or half as many as there are triangles.
constexpr std::size_t FewPieces = 262144;

double HalfArea(const RayBounds& bounds)
{
  const glm::dvec3 size = glm::dvec3(bounds.Upper) - glm::dvec3(bounds.Lower);
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// What of a triangle lies in a piece: convex, each cut adds a corner at most.
struct Polygon
{
  std::array<glm::dvec3, 12> Corners;
  int Count = 0;
  void Add(const glm::dvec3& corner)
  {
    if (this->Count < static_cast<int>(this->Corners.size()))
    {
      this->Corners[this->Count++] = corner;
    }
  }
};

RayBounds BoundsOf(const Polygon& polygon)
{
  RayBounds bounds;
  for (int i = 0; i < polygon.Count; ++i)
  {
    bounds.Add(glm::vec3(polygon.Corners[i]));
  }
  // Cuts are rounded to floats.
  return bounds.Grown(std::ldexp(bounds.LargestCoordinate(), -23));
}

/// The part of a polygon on one side of a plane across an axis (Sutherland and Hodgman 1974).
Polygon Cut(const Polygon& whole, int axis, double at, double side)
{
  Polygon part;
  for (int i = 0; i < whole.Count; ++i)
  {
    const glm::dvec3& a = whole.Corners[i];
    const glm::dvec3& b = whole.Corners[(i + 1) % whole.Count];
    const double from = (a[axis] - at) * side;
    const double to = (b[axis] - at) * side;
    if (from >= 0.0)
    {
      part.Add(a);
    }
    if ((from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0))
    {
      glm::dvec3 crossing = a + (b - a) * (from / (from - to));
      crossing[axis] = at;
      part.Add(crossing);
    }
  }
  return part;
}

/// pieces: how many to make, of equal length.
void Split(const Polygon& polygon, int pieces, std::vector<RayBounds>& out)
{
  const RayBounds bounds = BoundsOf(polygon);
  const glm::vec3 size = bounds.Upper - bounds.Lower;
  // A polygon of more corners than this would not fit after two more cuts.
  constexpr int roundest = 10;
  if (pieces < 2 || polygon.Count > roundest)
  {
    out.push_back(bounds);
    return;
  }
  const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const int first = pieces / 2;
  const double at = bounds.Lower[axis] + static_cast<double>(size[axis]) * first / pieces;
  const Polygon low = Cut(polygon, axis, at, -1.0);
  const Polygon high = Cut(polygon, axis, at, 1.0);
  if (low.Count < 2 || high.Count < 2)
  {
    out.push_back(bounds);
    return;
  }
  Split(low, first, out);
  Split(high, pieces - first, out);
}

struct Long
{
  std::uint32_t Triangle;
  double Waste; ///< the area that its bounds show in vain
};

std::vector<Long> FindLong(const RayGeometry& geometry, const std::vector<RayBounds>& bounds)
{
  RayBounds all;
  for (const RayBounds& item : bounds)
  {
    if (!item.IsEmpty())
    {
      all.Add(item);
    }
  }
  std::vector<Long> found;
  const std::size_t count = geometry.Triangles.size();
  // As large as a triangle's share of the space they lie in: smaller ones overlap few others.
  const double least =
    HalfArea(all) / std::pow(static_cast<double>(std::max<std::size_t>(count, 1)), 2.0 / 3.0);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double area = bounds[i].IsEmpty() ? 0.0 : HalfArea(bounds[i]);
    if (area > least)
    {
      const glm::uvec3& corners = geometry.Triangles[i];
      const glm::dvec3 a(geometry.Points[corners.x]);
      const glm::dvec3 shown = glm::abs(glm::cross(
        glm::dvec3(geometry.Points[corners.y]) - a, glm::dvec3(geometry.Points[corners.z]) - a));
      const double own = 0.5 * (shown.x + shown.y + shown.z);
      if (area > LongestShape * own)
      {
        found.push_back({ static_cast<std::uint32_t>(i), area - own });
      }
    }
  }
  return found;
}
}

std::vector<std::uint32_t> SplitLongTriangles(
  const RayGeometry& geometry, std::vector<RayBounds>& bounds)
{
  std::vector<std::uint32_t> sources;
  const std::vector<Long> found = FindLong(geometry, bounds);
  if (found.empty())
  {
    return sources;
  }
  // In pieces of a sliver's bounds the waste falls as their number grows: a triangle gets as many as
  // the square root of what it wastes is of all of these.
  double total = 0.0;
  for (const Long& triangle : found)
  {
    total += std::sqrt(triangle.Waste);
  }
  const double budget =
    static_cast<double>(std::max(FewPieces, geometry.Triangles.size() / 2) + found.size());
  std::vector<RayBounds> pieces;
  for (const Long& triangle : found)
  {
    const double share = budget * std::sqrt(triangle.Waste) / total;
    const glm::uvec3& corners = geometry.Triangles[triangle.Triangle];
    Polygon polygon;
    for (int i = 0; i < 3; ++i)
    {
      polygon.Add(glm::dvec3(geometry.Points[corners[i]]));
    }
    pieces.clear();
    Split(polygon, std::min(MostPieces, static_cast<int>(share)), pieces);
    bounds[triangle.Triangle] = pieces.front();
    for (std::size_t i = 1; i < pieces.size(); ++i)
    {
      bounds.push_back(pieces[i]);
      sources.push_back(triangle.Triangle);
    }
  }
  return sources;
}
}
