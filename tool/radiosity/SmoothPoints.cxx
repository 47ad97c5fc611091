// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmoothPoints.h"

#include <map>

namespace penumbra::radiosity
{
SmoothPoints MakeSmoothPoints(const PatchMesh& mesh, const std::vector<Element>& elements)
{
  constexpr double crease = 0.866; // cosine of 30 degrees
  constexpr double nudge = 0.02;   // of the way to the middle of a patch
  SmoothPoints result;
  result.OfElement.resize(elements.size());
  std::vector<double> weights;
  // A vertex has few points: one for each side and each bundle of normals.
  std::map<std::array<std::uint32_t, 3>, std::vector<std::uint32_t>> known;
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    const Face& face = mesh.Faces()[i / 2];
    const Element& element = elements[i];
    const Point middle = (element.Corners[0] + element.Corners[1] + element.Corners[2]) / 3.0;
    for (int k = 0; k < 3; ++k)
    {
      const std::uint32_t vertex = face.Corners[i % 2 == 0 ? k : (3 - k) % 3];
      auto& bundle = known[{ vertex, static_cast<std::uint32_t>(i % 2), face.Surface }];
      std::uint32_t point = static_cast<std::uint32_t>(result.Points.size());
      for (const std::uint32_t other : bundle)
      {
        const Point& normal = result.Points[other].Normal;
        point = glm::dot(normal, element.Normal) > crease * glm::length(normal) ? other : point;
      }
      if (point == result.Points.size())
      {
        result.Points.push_back({ mesh.Vertices()[vertex].At, Point(0.0), Point(0.0) });
        weights.push_back(0.0);
        bundle.push_back(point);
      }
      result.Points[point].Normal += element.Area * element.Normal;
      result.Points[point].Inside += element.Area * middle;
      weights[point] += element.Area;
      result.OfElement[i][k] = point;
    }
  }
  for (std::size_t i = 0; i < result.Points.size(); ++i)
  {
    auto& point = result.Points[i];
    point.Normal = glm::normalize(point.Normal);
    point.Inside = glm::mix(point.At, point.Inside / weights[i], nudge);
  }
  return result;
}

std::vector<Color> MeanAround(const SmoothPoints& points, const std::vector<Element>& elements,
  const std::vector<Color>& values)
{
  std::vector<Color> sums(points.Points.size(), Color(0.0));
  std::vector<double> weights(points.Points.size(), 0.0);
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    for (const std::uint32_t point : points.OfElement[i])
    {
      sums[point] += elements[i].Area * values[i];
      weights[point] += elements[i].Area;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    sums[i] /= weights[i];
  }
  return sums;
}
}
