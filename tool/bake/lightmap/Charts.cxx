// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/lightmap/Charts.h"

#include "bake/lightmap/Overlap.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

namespace penumbra::lightmap
{
namespace
{
constexpr std::uint32_t None = 0xffffffffu;
constexpr double Shift = 15.0; // degrees by which a chart's mean normal may change while it grows

/// Triangles across each edge.
class Edges
{
public:
  explicit Edges(const Surfaces& surfaces)
  {
    for (std::uint32_t t = 0; t < surfaces.Triangles.size(); ++t)
    {
      const auto& p = surfaces.Triangles[t].Points;
      for (std::uint32_t k = 0; k < 3; ++k)
      {
        const std::uint32_t a = p[k], b = p[(k + 1) % 3];
        this->All.push_back({ std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), 3 * t + k });
      }
    }
    std::sort(this->All.begin(), this->All.end());
  }

  /// Visits all pairs of triangles that share an edge. Arguments are the corners where the edge begins, as 3 * triangle +
  /// corner.
  template <typename Visit>
  void ForPairs(const Visit& visit) const
  {
    for (std::size_t first = 0, last = 0; first < this->All.size(); first = last)
    {
      while (last < this->All.size() && this->All[last].first == this->All[first].first)
      {
        ++last;
      }
      for (std::size_t i = first; i < last; ++i)
      {
        for (std::size_t j = i + 1; j < last; ++j)
        {
          visit(this->All[i].second, this->All[j].second);
        }
      }
    }
  }

private:
  std::vector<std::pair<std::uint64_t, std::uint32_t>> All;
};

/// The cosine of the larger angle between normals at both ends of an edge. turned: whether the triangles have opposite
/// winding, so that the front of one continues as the back of the other.
double SmoothAcross(const Surfaces& surfaces, std::uint32_t a, std::uint32_t b, bool& turned)
{
  const Triangle& one = surfaces.Triangles[a / 3];
  const Triangle& other = surfaces.Triangles[b / 3];
  const int begin = static_cast<int>(a % 3), end = (begin + 1) % 3;
  turned = one.Points[begin] == other.Points[b % 3];
  const int here = static_cast<int>(b % 3), there = (here + 1) % 3;
  const double side = turned ? -1.0 : 1.0;
  return std::min(side * glm::dot(one.Normals[begin], other.Normals[turned ? here : there]),
    side * glm::dot(one.Normals[end], other.Normals[turned ? there : here]));
}

class ChartBuilder
{
public:
  ChartBuilder(const Surfaces& surfaces, const ChartSettings& settings)
    : Input(surfaces)
    , LeanCosine(std::cos(glm::radians(settings.Lean)))
    , LeastCosine(std::cos(glm::radians(settings.Lean + Shift)))
    , Owner(surfaces.Triangles.size(), None)
    , Neighbors(3 * surfaces.Triangles.size())
  {
    const double crease = std::cos(glm::radians(settings.Crease));
    Edges(surfaces).ForPairs([&](std::uint32_t a, std::uint32_t b) {
      bool turned = false;
      const bool smooth = SmoothAcross(surfaces, a, b, turned) > crease;
      if (smooth && !turned && this->SameSides(a / 3, b / 3))
      {
        this->Neighbors[a].push_back(b / 3);
        this->Neighbors[b].push_back(a / 3);
      }
    });
  }

  std::vector<Chart> Grow()
  {
    std::vector<std::uint32_t> order(this->Owner.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
      return this->Input.Triangles[a].Area > this->Input.Triangles[b].Area;
    });
    for (bool again = true; again;)
    {
      again = false;
      for (const std::uint32_t seed : order)
      {
        if (this->Owner[seed] == None)
        {
          this->GrowFrom(seed);
          again = true;
        }
      }
    }
    return std::move(this->Charts);
  }

private:
  bool SameSides(std::uint32_t a, std::uint32_t b) const
  {
    return this->Input.Triangles[a].Visible == this->Input.Triangles[b].Visible;
  }

  void GrowFrom(std::uint32_t seed)
  {
    const auto number = static_cast<std::uint32_t>(this->Charts.size());
    using Candidate = std::pair<double, std::uint32_t>; // cosine to the chart's normal, triangle
    std::priority_queue<Candidate> queue;
    queue.push({ 1.0, seed });
    std::vector<std::uint32_t> members;
    Vec3 sum(0.0);
    const Vec3& seedNormal = this->Input.Triangles[seed].Normal;
    while (!queue.empty())
    {
      const std::uint32_t t = queue.top().second;
      queue.pop();
      const Triangle& triangle = this->Input.Triangles[t];
      if (this->Owner[t] != None ||
        (!members.empty() &&
          (glm::dot(glm::normalize(sum), triangle.Normal) < this->LeanCosine ||
            glm::dot(seedNormal, triangle.Normal) < this->LeastCosine)))
      {
        continue;
      }
      this->Owner[t] = number;
      members.push_back(t);
      sum += triangle.Area * triangle.Normal;
      for (int k = 0; k < 3; ++k)
      {
        for (const std::uint32_t next : this->Neighbors[3 * t + k])
        {
          if (this->Owner[next] == None)
          {
            queue.push({ glm::dot(glm::normalize(sum), this->Input.Triangles[next].Normal), next });
          }
        }
      }
    }
    this->Charts.push_back(this->Flatten(members, glm::normalize(sum)));
  }

  /// Leaves triangles that are tilted too far from the mean, or overlap others, for another chart.
  Chart Flatten(const std::vector<std::uint32_t>& members, const Vec3& normal)
  {
    Chart chart;
    chart.Normal = normal;
    const Vec3 helper = std::abs(normal.x) < 0.7 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
    chart.Axes[0] = glm::normalize(glm::cross(helper, normal));
    chart.Axes[1] = glm::cross(normal, chart.Axes[0]);
    const double extent = this->SetBox(chart, members);
    constexpr double cells = 256.0;
    constexpr double rounding = 1e-9;
    FlatSet taken(std::max(this->MeanSize(members), extent / cells), rounding * extent);
    for (const std::uint32_t t : members)
    {
      const Flat flat = this->Project(chart, t);
      const bool first = chart.Triangles.empty();
      if (!first &&
        (glm::dot(this->Input.Triangles[t].Normal, normal) < this->LeastCosine ||
          taken.CountHits(flat) > 0))
      {
        this->Owner[t] = None;
        continue;
      }
      taken.Add(flat);
      chart.Triangles.push_back(t);
    }
    this->Rotate(chart);
    this->SetBox(chart, chart.Triangles);
    return chart;
  }

  Flat Project(const Chart& chart, std::uint32_t t) const
  {
    const auto& p = this->Input.Triangles[t].Points;
    return { chart.Project(this->Input.Points[p[0]]), chart.Project(this->Input.Points[p[1]]),
      chart.Project(this->Input.Points[p[2]]) };
  }

  double MeanSize(const std::vector<std::uint32_t>& members) const
  {
    double sum = 0.0;
    for (const std::uint32_t t : members)
    {
      sum += std::sqrt(this->Input.Triangles[t].Area);
    }
    constexpr double wide = 1.5; // a typical side, relative to the root of the area
    return wide * sum / static_cast<double>(members.size());
  }

  double SetBox(Chart& chart, const std::vector<std::uint32_t>& members) const
  {
    chart.Low = Vec2(0.0);
    Vec2 low(std::numeric_limits<double>::max());
    Vec2 high(-std::numeric_limits<double>::max());
    for (const std::uint32_t t : members)
    {
      for (const glm::dvec2& corner : this->Project(chart, t))
      {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
      }
    }
    chart.Low = low;
    chart.Size = high - low;
    return std::max(chart.Size.x, chart.Size.y);
  }

  /// Rotates the axes to minimize the bounding box. The smallest box around a convex shape has a side along one of its edges
  /// (Freeman and Shapira 1975).
  void Rotate(Chart& chart) const
  {
    std::vector<std::pair<double, Vec3>> sides;
    for (const std::uint32_t t : chart.Triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        const auto& around = this->Neighbors[3 * t + k];
        const bool inner = std::any_of(around.begin(), around.end(),
          [&](std::uint32_t next) { return this->Owner[next] == this->Owner[t]; });
        const auto& p = this->Input.Triangles[t].Points;
        Vec3 side = this->Input.Points[p[(k + 1) % 3]] - this->Input.Points[p[k]];
        side -= glm::dot(side, chart.Normal) * chart.Normal;
        if (!inner && glm::length(side) > 0.0)
        {
          sides.emplace_back(-glm::length(side), glm::normalize(side));
        }
      }
    }
    constexpr std::size_t most = 48; // the longest
    std::stable_sort(
      sides.begin(), sides.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    sides.resize(std::min(sides.size(), most));
    double best = std::numeric_limits<double>::max();
    const Chart before = chart;
    for (const auto& side : sides)
    {
      Chart rotated = before;
      rotated.Axes = { side.second, glm::cross(before.Normal, side.second) };
      this->SetBox(rotated, rotated.Triangles);
      const double area = rotated.Size.x * rotated.Size.y;
      if (area < best * (1.0 - 1e-9))
      {
        best = area;
        chart = rotated;
      }
    }
  }

  const Surfaces& Input;
  double LeanCosine;
  double LeastCosine;
  std::vector<std::uint32_t> Owner; ///< chart of each triangle
  std::vector<std::vector<std::uint32_t>>
    Neighbors; ///< across each edge that does not separate charts
  std::vector<Chart> Charts;
};
}

std::vector<Chart> MakeCharts(const Surfaces& surfaces, const ChartSettings& settings)
{
  return ChartBuilder(surfaces, settings).Grow();
}

std::vector<Seam> FindSeams(
  const Surfaces& surfaces, const std::vector<Chart>& charts, double crease)
{
  std::vector<std::uint32_t> owner(surfaces.Triangles.size(), None);
  for (std::uint32_t c = 0; c < charts.size(); ++c)
  {
    for (const std::uint32_t t : charts[c].Triangles)
    {
      owner[t] = c;
    }
  }
  std::vector<Seam> seams;
  const double least = std::cos(glm::radians(crease));
  Edges(surfaces).ForPairs([&](std::uint32_t a, std::uint32_t b) {
    Seam seam;
    if (owner[a / 3] != owner[b / 3] && SmoothAcross(surfaces, a, b, seam.Turned) > least)
    {
      seam.Triangles = { a / 3, b / 3 };
      seam.Charts = { owner[a / 3], owner[b / 3] };
      seam.Edges = { int(a % 3), int(b % 3) };
      seams.push_back(seam);
    }
  });
  return seams;
}
}
