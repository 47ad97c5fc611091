// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RayCompare.h"

#include <cmath>
#include <cstdio>
#include <sstream>

using namespace penumbra;

namespace penumbra_test
{
namespace
{
/// Intersection of a ray with a triangle of the world, in doubles.
struct Intersection
{
  glm::dvec3 Corners[3];
  double Distance = 0.0;     ///< to the plane
  double Outline = HUGE_VAL; ///< distance between the ray and the nearest edge
  bool Inside = false;       ///< the ray passes through it
  double Slope = 0.0;        ///< cosine between the ray and the normal
  double Scale = 0.0;        ///< size of the coordinates that floats round
  double Needle = 0.0;       ///< extent of the triangle along the ray, in its heights

  /// A few units in the last place of the largest coordinate as a float.
  double Rounding() const { return 4e-7 * this->Scale; }

  /// Whether rounding moves the distance by more than the relative tolerance. It does if the ray is nearly parallel to
  /// the plane, or if the triangle is so thin that rounding moves the hit along it.
  bool IsUncertain(double tolerance) const
  {
    const double limit = tolerance * this->Distance;
    return this->Slope * limit <= 4.0 * this->Rounding() ||
      limit <= 4.0 * this->Rounding() * this->Needle;
  }
};

/// Distance between the line of a ray and a segment.
double LineToSegment(
  const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& a, const glm::dvec3& b)
{
  // In the plane perpendicular to the ray, its line is a point.
  const auto project = [&](const glm::dvec3& p) {
    return (p - origin) - glm::dot(p - origin, direction) * direction;
  };
  const glm::dvec3 p = project(a);
  const glm::dvec3 q = project(b);
  const double length = glm::dot(q - p, q - p);
  const double t = length > 0.0 ? glm::clamp(-glm::dot(p, q - p) / length, 0.0, 1.0) : 0.0;
  return glm::length(p + t * (q - p));
}

Intersection Intersect(const RayWorld& world, const shared::RayQuery& ray, const glm::ivec2& hit)
{
  Intersection result;
  const RayWorld::Placement& placement = world.Instances[hit.x];
  const RayGeometry& mesh = world.Meshes[placement.Mesh];
  const glm::dvec3 origin(ray.Origin);
  const glm::dvec3 direction = glm::normalize(glm::dvec3(ray.Direction));
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3 point = mesh.Origin + glm::dvec3(mesh.Points[mesh.Triangles[hit.y][i]]);
    result.Corners[i] = glm::dvec3(placement.MeshToWorld * glm::dvec4(point, 1.0)) - world.Center;
    result.Scale = std::max(result.Scale, glm::length(result.Corners[i]));
    result.Scale = std::max(result.Scale, glm::length(result.Corners[i] - origin));
  }
  const glm::dvec3* c = result.Corners;
  const glm::dvec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
  const double facing = glm::dot(normal, direction);
  result.Distance = glm::dot(c[0] - origin, normal) / facing;
  result.Slope = std::abs(facing) / glm::length(normal);
  int sides = 0;
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3 edge = glm::cross(c[i] - origin, c[(i + 1) % 3] - origin);
    sides += glm::dot(edge, direction) >= 0.0 ? 1 : -1;
    result.Outline =
      std::min(result.Outline, LineToSegment(origin, direction, c[i], c[(i + 1) % 3]));
  }
  result.Inside = std::abs(sides) == 3;
  double longest = 0.0;
  double nearest = HUGE_VAL;
  double farthest = -HUGE_VAL;
  for (int i = 0; i < 3; ++i)
  {
    longest = std::max(longest, glm::length(c[(i + 1) % 3] - c[i]));
    nearest = std::min(nearest, glm::dot(c[i] - origin, direction));
    farthest = std::max(farthest, glm::dot(c[i] - origin, direction));
  }
  result.Needle = (farthest - nearest) * longest / glm::length(normal);
  return result;
}

bool ShareVertex(const Intersection& a, const Intersection& b)
{
  for (const glm::dvec3& p : a.Corners)
  {
    for (const glm::dvec3& q : b.Corners)
    {
      if (p == q)
      {
        return true;
      }
    }
  }
  return false;
}
}

bool IsDistanceUncertain(const RayWorld& world, const shared::RayQuery& ray,
  const shared::RayAnswer& answer, double tolerance)
{
  return answer.Hit.x >= 0 && Intersect(world, ray, answer.Hit).IsUncertain(tolerance);
}

Comparison Compare(const RayWorld& world, const Rays& rays, const Answers& reference,
  const Answers& answers, double tolerance)
{
  Comparison result;
  result.Rays = rays.size();
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const shared::RayAnswer& expected = reference[i];
    const shared::RayAnswer& actual = answers[i];
    const bool hits[2] = { expected.Hit.x >= 0, actual.Hit.x >= 0 };
    result.Hits += hits[0];
    const bool sameDistance = hits[0] == hits[1] &&
      (!hits[0] ||
        std::abs(expected.Distance - actual.Distance) <= tolerance * std::abs(expected.Distance));
    if (sameDistance && expected.Hit == actual.Hit)
    {
      ++result.Same;
      continue;
    }
    Intersection intersections[2];
    bool edge = false;
    bool grazing = false;
    for (int side = 0; side < 2; ++side)
    {
      if (hits[side])
      {
        intersections[side] = Intersect(world, rays[i], side == 0 ? expected.Hit : actual.Hit);
        edge |= intersections[side].Outline <= 4.0 * intersections[side].Rounding();
        grazing |= intersections[side].IsUncertain(tolerance);
      }
    }
    if (sameDistance && hits[0] && ShareVertex(intersections[0], intersections[1]) && edge)
    {
      ++result.Shared;
    }
    else if (sameDistance)
    {
      ++result.Coincident;
    }
    else if (edge)
    {
      ++result.Edge;
      // The nearer hit decides which tracer is right.
      const bool ours = hits[1] && (!hits[0] || actual.Distance < expected.Distance);
      result.Right += intersections[ours ? 1 : 0].Inside == ours ? 1 : 0;
    }
    else if (hits[0] && expected.Hit == actual.Hit &&
      std::abs(actual.Distance - intersections[1].Distance) <=
        tolerance * intersections[1].Distance)
    {
      ++result.Reference;
    }
    else if (grazing)
    {
      ++result.Grazing;
    }
    else
    {
      if (result.Unexplained++ == 0)
      {
        std::ostringstream text;
        text.precision(9);
        text << "ray " << i << ": expected instance " << expected.Hit.x << " primitive "
             << expected.Hit.y << " at " << expected.Distance << ", got " << actual.Hit.x << " "
             << actual.Hit.y << " at " << actual.Distance;
        for (int side = 0; side < 2; ++side)
        {
          text << "; in doubles at " << intersections[side].Distance << ", outline "
               << intersections[side].Outline << ", slope " << intersections[side].Slope;
        }
        result.First = text.str();
      }
    }
  }
  return result;
}

std::string Comparison::Line(const std::string& name) const
{
  char text[320];
  std::snprintf(text, sizeof(text),
    "%-24s %9zu rays %9zu hits: same %9zu, shared edge %5zu, coincident %5zu, outline %4zu (right "
    "in %zu), "
    "edge-on %4zu, reference off %zu, unexplained %zu",
    name.c_str(), this->Rays, this->Hits, this->Same, this->Shared, this->Coincident, this->Edge,
    this->Right, this->Grazing, this->Reference, this->Unexplained);
  return text;
}
}
