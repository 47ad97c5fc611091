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

/// The part of a triangle above the horizon of a point, relative to the point.
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

/// The share of an emitter's light that is not occluded.
double Visibility(const Receiver& receiver, const Element& emitter, const PatchRays& rays,
  int samples, Random& random)
{
  const SphericalTriangle seen(receiver.At, emitter.Corners);
  int count = 0;
  int visible = 0;
  for (const glm::dvec2& u : Strata(GridSide(samples), random))
  {
    Point direction;
    if (!LightDirection(seen, receiver.Normal, u, random, direction))
    {
      continue;
    }
    const double distance = receiver.Height / -glm::dot(direction, emitter.Normal);
    ++count;
    visible += rays.Occluded(
                 receiver.At, receiver.Normal, receiver.At + distance * direction, emitter.Normal)
      ? 0
      : 1;
  }
  return count > 0 ? double(visible) / count : 0.0;
}

bool IsVisible(const Light& light, const PatchRays& rays, const Point& at, const Point& normal)
{
  return light.Positional ? !rays.Occluded(at, normal, light.WorldPosition, Point(0.0))
                          : !rays.OccludedTowards(at, normal, -light.WorldDirection);
}
}

Color UnoccludedIrradiance(const Light& light, const Point& at, const Point& normal)
{
  Point travel = light.WorldDirection;
  double share = 1.0;
  if (light.Positional)
  {
    const Point path = at - light.WorldPosition;
    const double distance = glm::length(path);
    if (distance == 0.0)
    {
      return Color(0.0);
    }
    travel = path / distance;
    const Point& c = light.Attenuation;
    share = 1.0 / (c.x + c.y * distance + c.z * distance * distance);
    if (light.IsCone())
    {
      const double cosine = glm::dot(travel, light.WorldDirection);
      share *=
        cosine >= std::cos(glm::radians(light.ConeAngle)) ? std::pow(cosine, light.Exponent) : 0.0;
    }
  }
  return light.Color * glm::pi<double>() * (share * std::max(0.0, -glm::dot(travel, normal)));
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

Color IrradianceAt(const LightSources& sources, const PatchRays& rays, const Point& at,
  const Point& normal, int shadowRays, std::uint64_t stream)
{
  Color sum(0.0);
  for (const Light& light : sources.Lights)
  {
    const Color irradiance = UnoccludedIrradiance(light, at, normal);
    if (irradiance != Color(0.0) && IsVisible(light, rays, at, normal))
    {
      sum += irradiance;
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
        (factor * Visibility({ at, normal, height }, emitter, rays, shadowRays, random));
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
      irradiance[i] += IrradianceAt(sources, rays, element.At(strata[k].x, strata[k].y),
        element.Normal, 1, i * strata.size() + k);
    }
    irradiance[i] /= double(strata.size());
  };
  tool::ForEach(elements.size(), light, advance);
  return irradiance;
}
}
