// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/SmoothPoints.h"

#include <algorithm>
#include <map>

namespace penumbra::radiosity
{
SmoothPoints MakeSmoothPoints(const PatchMesh& mesh, const std::vector<Element>& elements)
{
  constexpr double crease = 0.866; // cosine of 30 degrees
  SmoothPoints result;
  result.OfElement.resize(elements.size());
  std::vector<Point> normals;
  // A vertex has few points, one for each side and each group of similar normals.
  std::map<std::array<std::uint32_t, 3>, std::vector<std::uint32_t>> known;
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    const Face& face = mesh.Faces()[i / 2];
    const Element& element = elements[i];
    for (int k = 0; k < 3; ++k)
    {
      const std::uint32_t vertex = face.Corners[i % 2 == 0 ? k : (3 - k) % 3];
      auto& group = known[{ vertex, static_cast<std::uint32_t>(i % 2), face.Surface }];
      std::uint32_t point = static_cast<std::uint32_t>(result.Points.size());
      for (const std::uint32_t other : group)
      {
        const Point& normal = normals[other];
        point = glm::dot(normal, element.Normal) > crease * glm::length(normal) ? other : point;
      }
      if (point == result.Points.size())
      {
        result.Points.push_back(mesh.Vertices()[vertex].At);
        normals.emplace_back(0.0);
        group.push_back(point);
      }
      normals[point] += element.Area * element.Normal;
      result.OfElement[i][k] = point;
    }
  }
  return result;
}

namespace
{
/// The mean by area over the elements around each point, of valueAt(element, corner).
template <typename ValueAt>
std::vector<Color> Mean(
  const SmoothPoints& points, const std::vector<Element>& elements, const ValueAt& valueAt)
{
  std::vector<Color> sums(points.Points.size(), Color(0.0));
  std::vector<double> weights(points.Points.size(), 0.0);
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      sums[points.OfElement[i][k]] += elements[i].Area * valueAt(i, k);
      weights[points.OfElement[i][k]] += elements[i].Area;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    sums[i] /= weights[i];
  }
  return sums;
}
}

std::vector<Color> DirectAround(const SmoothPoints& points, const std::vector<Element>& elements,
  const PatchRays& rays, const LightSources& sources, int shadowRays, const tool::Progress& advance)
{
  constexpr double offset = 0.02; // relative to the distance of the patch's centre
  constexpr int typical = 6;      // number of patches around most points
  const int each = std::max(1, shadowRays / typical);
  std::vector<std::array<Color, 3>> light(elements.size());
  const auto sample = [&](std::size_t i) {
    const Element& element = elements[i];
    const auto& at = element.Corners;
    for (std::size_t k = 0; k < 3 && element.Present; ++k)
    {
      light[i][k] = IrradianceAt(sources, rays,
        glm::mix(at[k], (at[0] + at[1] + at[2]) / 3.0, offset), element.Normal, each, 3 * i + k);
    }
  };
  tool::ForEach(elements.size(), sample, advance);
  return Mean(points, elements, [&](std::size_t i, std::size_t k) { return light[i][k]; });
}

std::vector<Color> MeanAround(const SmoothPoints& points, const std::vector<Element>& elements,
  const std::vector<Color>& values)
{
  return Mean(points, elements, [&](std::size_t i, std::size_t) { return values[i]; });
}
}
