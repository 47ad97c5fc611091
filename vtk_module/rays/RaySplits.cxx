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
// Ratio of the surface area of a triangle's bounds to its own projected area, from which on it is split.
constexpr double LongestShape = 8.0;
constexpr int MaxPieces = 64;
// Limit of pieces, which cost memory and build time: this number, or half the number of triangles if that is more.
constexpr std::size_t MinPieceLimit = 262144;

double HalfArea(const RayBounds& bounds)
{
  const glm::dvec3 size = glm::dvec3(bounds.Upper) - glm::dvec3(bounds.Lower);
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// The part of a triangle in a piece. It is convex, so each cut adds at most one corner.
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

/// Split a polygon into pieces of equal length along its longest axis.
void Split(const Polygon& polygon, int pieces, std::vector<RayBounds>& out)
{
  const RayBounds bounds = BoundsOf(polygon);
  const glm::vec3 size = bounds.Upper - bounds.Lower;
  // A polygon of more corners than this would not fit after two more cuts.
  constexpr int maxCorners = 10;
  if (pieces < 2 || polygon.Count > maxCorners)
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

struct LongTriangle
{
  std::uint32_t Triangle;
  double Waste; ///< area of the bounds minus the triangle's own
};

std::vector<LongTriangle> FindLongTriangles(
  const RayGeometry& geometry, const std::vector<RayBounds>& bounds)
{
  RayBounds all;
  for (const RayBounds& item : bounds)
  {
    if (!item.IsEmpty())
    {
      all.Add(item);
    }
  }
  std::vector<LongTriangle> found;
  const std::size_t count = geometry.Triangles.size();
  // Bounds smaller than a triangle's share of the whole space overlap few others.
  const double minimumArea =
    HalfArea(all) / std::pow(static_cast<double>(std::max<std::size_t>(count, 1)), 2.0 / 3.0);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double area = bounds[i].IsEmpty() ? 0.0 : HalfArea(bounds[i]);
    if (area > minimumArea)
    {
      const glm::uvec3& corners = geometry.Triangles[i];
      const glm::dvec3 a(geometry.Points[corners.x]);
      const glm::dvec3 shown = glm::abs(glm::cross(
        glm::dvec3(geometry.Points[corners.y]) - a, glm::dvec3(geometry.Points[corners.z]) - a));
      const double shownArea = 0.5 * (shown.x + shown.y + shown.z);
      if (area > LongestShape * shownArea)
      {
        found.push_back({ static_cast<std::uint32_t>(i), area - shownArea });
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
  const std::vector<LongTriangle> found = FindLongTriangles(geometry, bounds);
  if (found.empty())
  {
    return sources;
  }
  // The waste of a sliver falls with the number of its pieces. The total waste is least if numbers of pieces are
  // proportional to the square roots of the wastes.
  double total = 0.0;
  for (const LongTriangle& triangle : found)
  {
    total += std::sqrt(triangle.Waste);
  }
  const double budget =
    static_cast<double>(std::max(MinPieceLimit, geometry.Triangles.size() / 2) + found.size());
  std::vector<RayBounds> pieces;
  for (const LongTriangle& triangle : found)
  {
    const double share = budget * std::sqrt(triangle.Waste) / total;
    const glm::uvec3& corners = geometry.Triangles[triangle.Triangle];
    Polygon polygon;
    for (int i = 0; i < 3; ++i)
    {
      polygon.Add(glm::dvec3(geometry.Points[corners[i]]));
    }
    pieces.clear();
    Split(polygon, std::min(MaxPieces, static_cast<int>(share)), pieces);
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
