// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BiasMeasures.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticPointLocator.h>

#include <algorithm>
#include <cmath>

namespace penumbra::tool
{
namespace
{
using Vector = LitView::Vector;

// A gap that nineteen of twenty points of an edge stay below: a single stray pixel is none.
constexpr double Percentile = 0.95;

// Two pixels of one surface, or of two that touch, are no farther apart than each is from its next
// neighbour, together; the rest is for the bend of curved surfaces.
constexpr double Slack = 1.5;

double Distance(const Vector& a, const Vector& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Vector Middle(const Vector& a, const Vector& b)
{
  return { (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 };
}

/// Finds the nearest of a set of points.
class PointSet
{
public:
  void Add(const Vector& point) { this->Points->InsertNextPoint(point.data()); }
  void Build()
  {
    this->Data->SetPoints(this->Points);
    this->Locator->SetDataSet(this->Data);
    this->Locator->BuildLocator();
  }
  bool IsEmpty() const { return this->Points->GetNumberOfPoints() == 0; }
  vtkIdType FindNearest(const Vector& point) const
  {
    return this->Locator->FindClosestPoint(point.data());
  }
  bool HasWithin(double radius, const Vector& point) const
  {
    double squared = 0;
    return this->Locator->FindClosestPointWithinRadius(radius, point.data(), squared) >= 0;
  }
  PointSet() { this->Points->SetDataTypeToDouble(); }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkPolyData> Data;
  vtkNew<vtkStaticPointLocator> Locator;
};

double AtPercentile(std::vector<double>& values)
{
  if (values.empty())
  {
    return 0;
  }
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(Percentile * (values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// From a pixel to its neighbour by step, in world units; 0 where there is none.
double Spacing(const LitView& view, std::size_t pixel, std::ptrdiff_t step)
{
  const auto x = static_cast<std::ptrdiff_t>(pixel % view.Width) + (std::abs(step) == 1 ? step : 0);
  const std::ptrdiff_t next = static_cast<std::ptrdiff_t>(pixel) + step;
  const bool inside =
    x >= 0 && x < view.Width && next >= 0 && next < static_cast<std::ptrdiff_t>(view.PixelCount());
  return inside && view.Surface[next] ? Distance(view.Place[pixel], view.Place[next]) : 0;
}

/// Whether the surfaces of pixel a and its neighbour b = a + step are one, or touch.
bool IsContinuous(const LitView& view, std::size_t a, std::size_t b, std::ptrdiff_t step)
{
  const double around = Spacing(view, a, -step) + Spacing(view, b, step);
  return Distance(view.Place[a], view.Place[b]) <= Slack * around;
}
}

double MedianPixelWidth(const LitView& view)
{
  std::vector<double> widths;
  for (std::size_t i = 0; i + 1 < view.PixelCount(); ++i)
  {
    const bool pair = (i + 1) % view.Width != 0 && view.Receiver[i] && view.Receiver[i + 1];
    if (pair && IsContinuous(view, i, i + 1, 1))
    {
      widths.push_back(Distance(view.Across[i], view.Across[i + 1]));
    }
  }
  if (widths.empty())
  {
    return 0;
  }
  std::nth_element(widths.begin(), widths.begin() + widths.size() / 2, widths.end());
  return widths[widths.size() / 2];
}

BiasJudge::BiasJudge(LitView view, double band)
  : Seen(std::move(view))
  , Counts(Seen.Receiver)
  , Nearest(Seen.PixelCount(), -1)
{
  std::vector<std::size_t> bordering;
  this->FindEdges(bordering);
  this->LeaveOutEdges(bordering, band);
  this->FindNearestEdges();
  for (std::size_t i = 0; i < this->Counts.size(); ++i)
  {
    this->Dark += this->Counts[i] && this->IsDark(i);
    this->Lit += this->Counts[i] && !this->IsDark(i);
  }
}

bool BiasJudge::IsDark(std::size_t pixel) const
{
  return this->Seen.Receiver[pixel] && this->Seen.Truth[pixel] < 0.5f;
}

/// Between neighbours of which one is truly dark. The other is lit: an outline; or it is turned away
/// from the light: there what casts the shadow stands on what receives it, if the two touch.
void BiasJudge::FindEdges(std::vector<std::size_t>& bordering)
{
  const LitView& seen = this->Seen;
  for (std::size_t a = 0; a < seen.PixelCount(); ++a)
  {
    const bool right = a % seen.Width + 1 < static_cast<std::size_t>(seen.Width);
    const bool below = a + seen.Width < seen.PixelCount();
    for (const std::ptrdiff_t step : { right ? 1 : 0, below ? seen.Width : 0 })
    {
      const std::size_t b = a + step;
      if (step == 0 || !seen.Surface[a] || !seen.Surface[b] || this->IsDark(a) == this->IsDark(b))
      {
        continue;
      }
      bordering.push_back(a);
      bordering.push_back(b);
      if (IsContinuous(seen, a, b, step))
      {
        const bool contact = !seen.Receiver[a] || !seen.Receiver[b];
        this->Edges.push_back({ Middle(seen.Place[a], seen.Place[b]),
          Middle(seen.Across[a], seen.Across[b]), contact });
        this->Contacts += contact;
      }
    }
  }
}

void BiasJudge::LeaveOutEdges(const std::vector<std::size_t>& bordering, double band)
{
  PointSet edges;
  for (const std::size_t pixel : bordering)
  {
    this->Counts[pixel] = 0;
    edges.Add(this->Seen.Across[pixel]);
  }
  if (edges.IsEmpty())
  {
    return;
  }
  edges.Build();
  for (std::size_t i = 0; i < this->Counts.size(); ++i)
  {
    if (this->Counts[i] && edges.HasWithin(band, this->Seen.Across[i]))
    {
      this->Counts[i] = 0;
    }
  }
}

/// Nearest in the world: across the light, other edges may lie above or below.
void BiasJudge::FindNearestEdges()
{
  PointSet places;
  for (const Edge& edge : this->Edges)
  {
    places.Add(edge.Place);
  }
  if (places.IsEmpty())
  {
    return;
  }
  places.Build();
  for (std::size_t i = 0; i < this->Nearest.size(); ++i)
  {
    if (this->IsDark(i))
    {
      this->Nearest[i] = places.FindNearest(this->Seen.Place[i]);
    }
  }
}

double BiasJudge::Error(const std::vector<float>& mask, std::size_t pixel) const
{
  return this->Counts[pixel] ? this->Seen.Truth[pixel] - mask[pixel] : 0.0;
}

BiasErrors BiasJudge::Measure(const std::vector<float>& mask) const
{
  BiasErrors errors;
  std::vector<EdgeGap> gaps(this->Edges.size());
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    const double error = this->Error(mask, i);
    errors.Acne += std::max(error, 0.0);
    errors.Leak += std::max(-error, 0.0);
    if (this->Nearest[i] >= 0 && mask[i] > 0.5f)
    {
      const Edge& edge = this->Edges[this->Nearest[i]];
      EdgeGap& gap = gaps[this->Nearest[i]];
      gap.Texels = std::max(gap.Texels, Distance(edge.Across, this->Seen.Across[i]));
      gap.World = std::max(gap.World, Distance(edge.Place, this->Seen.Place[i]));
    }
  }
  errors.Acne /= std::max<std::size_t>(1, this->Lit);
  errors.Leak /= std::max<std::size_t>(1, this->Dark);
  for (const bool contact : { true, false })
  {
    std::vector<double> texels, world;
    for (std::size_t i = 0; i < gaps.size(); ++i)
    {
      if (this->Edges[i].Contact == contact)
      {
        texels.push_back(gaps[i].Texels);
        world.push_back(gaps[i].World);
      }
    }
    (contact ? errors.Contact : errors.Outline) = { AtPercentile(texels), AtPercentile(world) };
  }
  return errors;
}
}
