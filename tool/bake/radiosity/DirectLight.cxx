// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/DirectLight.h"

#include "bake/radiosity/TriangleSampling.h"

#include <cmath>

namespace penumbra::radiosity
{
namespace
{
struct Polygon
{
  std::array<Point, 4> Corners;
  int Count = 0;
};

/// What of the triangle is above the plane, relative to the point on it.
Polygon ClipToHorizon(const Point& at, const Point& normal, const std::array<Point, 3>& triangle)
{
  Polygon kept;
  for (int i = 0; i < 3; ++i)
  {
    const Point a = triangle[i] - at;
    const Point b = triangle[(i + 1) % 3] - at;
    const double above = glm::dot(a, normal);
    const double next = glm::dot(b, normal);
    if (above > 0.0)
    {
      kept.Corners[kept.Count++] = a;
    }
    if ((above > 0.0) != (next > 0.0))
    {
      kept.Corners[kept.Count++] = a + (above / (above - next)) * (b - a);
    }
  }
  return kept;
}

struct Receiver
{
  const Point& At;
  const Point& Normal;
  double Height; ///< above the emitter's plane
};

/// The share of the emitter's light that nothing blocks.
double ShareSeen(const Receiver& receiver, const Element& emitter, const PatchRays& rays, int count,
  Random& random)
{
  const SeenTriangle seen(receiver.At, emitter.Corners);
  int tried = 0;
  int reached = 0;
  for (const glm::dvec2& u : Strata(GridSide(count), random))
  {
    Point direction;
    if (!LightDirection(seen, receiver.Normal, u, random, direction))
    {
      continue;
    }
    const double distance = receiver.Height / -glm::dot(direction, emitter.Normal);
    ++tried;
    reached +=
      rays.Blocked(receiver.At, receiver.Normal, receiver.At + distance * direction, emitter.Normal)
      ? 0
      : 1;
  }
  return tried > 0 ? double(reached) / tried : 0.0;
}

bool Reaches(const Lamp& lamp, const PatchRays& rays, const Point& at, const Point& normal)
{
  return lamp.Positional ? !rays.Blocked(at, normal, lamp.Position, Point(0.0))
                         : !rays.BlockedTowards(at, normal, -lamp.Travel);
}
}

Color Unblocked(const Lamp& lamp, const Point& at, const Point& normal)
{
  Point travel = lamp.Travel;
  double share = 1.0;
  if (lamp.Positional)
  {
    const Point path = at - lamp.Position;
    const double distance = glm::length(path);
    if (distance == 0.0)
    {
      return Color(0.0);
    }
    travel = path / distance;
    const Point& c = lamp.Attenuation;
    share = 1.0 / (c.x + c.y * distance + c.z * distance * distance);
    if (lamp.ConeCosine >= -1.0)
    {
      const double cosine = glm::dot(travel, lamp.Travel);
      share *= cosine >= lamp.ConeCosine ? std::pow(cosine, lamp.Exponent) : 0.0;
    }
  }
  return lamp.Strength * (share * std::max(0.0, -glm::dot(travel, normal)));
}

double PointFactor(const Point& at, const Point& normal, const std::array<Point, 3>& triangle)
{
  const Polygon polygon = ClipToHorizon(at, normal, triangle);
  double sum = 0.0;
  for (int i = 0; i < polygon.Count; ++i)
  {
    const Point& a = polygon.Corners[i];
    const Point& b = polygon.Corners[(i + 1) % polygon.Count];
    const Point across = glm::cross(a, b);
    const double sine = glm::length(across);
    if (sine > 0.0)
    {
      sum += std::atan2(sine, glm::dot(a, b)) * glm::dot(across, normal) / sine;
    }
  }
  return std::abs(sum) / (2.0 * glm::pi<double>());
}

Color ArrivingAt(const LightSources& sources, const PatchRays& rays, const Point& at,
  const Point& normal, int shadowRays, std::uint64_t stream)
{
  Color sum(0.0);
  for (const Lamp& lamp : sources.Lamps)
  {
    const Color light = Unblocked(lamp, at, normal);
    if (light != Color(0.0) && Reaches(lamp, rays, at, normal))
    {
      sum += light;
    }
  }
  Random random(stream, 2);
  for (const Element& emitter : sources.Emitters)
  {
    const double height = glm::dot(at - emitter.Corners[0], emitter.Normal);
    const double factor = height > 0.0 ? PointFactor(at, normal, emitter.Corners) : 0.0;
    if (factor > 0.0)
    {
      sum += emitter.Emission *
        (factor * ShareSeen({ at, normal, height }, emitter, rays, shadowRays, random));
    }
  }
  return sum;
}

std::vector<Color> DirectIrradiance(const std::vector<Element>& elements, const PatchRays& rays,
  const LightSources& sources, int points, const tool::Progress& advance)
{
  std::vector<Color> irradiance(elements.size(), Color(0.0));
  const int side = GridSide(points);
  const auto light = [&](std::size_t i) {
    const Element& element = elements[i];
    if (!element.Present)
    {
      return;
    }
    Random random(i, 3);
    const auto strata = Strata(side, random);
    for (std::size_t k = 0; k < strata.size(); ++k)
    {
      irradiance[i] += ArrivingAt(sources, rays, element.At(strata[k].x, strata[k].y),
        element.Normal, 1, i * strata.size() + k);
    }
    irradiance[i] /= double(strata.size());
  };
  tool::ForEach(elements.size(), light, advance);
  return irradiance;
}
}
