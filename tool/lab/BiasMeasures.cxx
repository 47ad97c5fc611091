// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lab/BiasMeasures.h"

#include <vtkMath.h>
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

// A gap that nineteen twentieths of the edges stay below: a single stray pixel is none.
constexpr double Percentile = 0.95;

// Two pixels of one surface, or of two that touch, are no farther apart than each is from its next
// neighbour, together; the rest is for the bend of curved surfaces.
constexpr double Slack = 1.5;

// From one pixel to the next, the spacing of a surface grows by less than this, up to its silhouette.
constexpr double Break = 4;

double Distance(const Vector& a, const Vector& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Vector Middle(const Vector& a, const Vector& b)
{
  return { (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 };
}

/// Tells what is near a set of points.
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

/// Values with weights, and the one below which a share of all weight lies.
class Weighted
{
public:
  void Add(double value, double weight)
  {
    this->Values.emplace_back(value, weight);
    this->Total += weight;
  }
  double AtPercentile(double share)
  {
    std::sort(this->Values.begin(), this->Values.end());
    double below = 0;
    for (const auto& [value, weight] : this->Values)
    {
      below += weight;
      if (below >= share * this->Total)
      {
        return value;
      }
    }
    return 0;
  }

private:
  std::vector<std::pair<double, double>> Values;
  double Total = 0;
};

bool IsTrulyDark(const LitView& view, std::size_t pixel)
{
  return view.Receiver[pixel] && view.Truth[pixel] < 0.5f;
}

/// The neighbour of a pixel by step, or -1 where there is no surface.
std::ptrdiff_t Neighbor(const LitView& view, std::size_t pixel, std::ptrdiff_t step)
{
  const auto x = static_cast<std::ptrdiff_t>(pixel % view.Width) + (std::abs(step) == 1 ? step : 0);
  const std::ptrdiff_t next = static_cast<std::ptrdiff_t>(pixel) + step;
  const bool inside =
    x >= 0 && x < view.Width && next >= 0 && next < static_cast<std::ptrdiff_t>(view.PixelCount());
  return inside && view.Surface[next] ? next : -1;
}

/// From a pixel to that neighbour, in world units; 0 where there is none, or where the neighbour is of
/// another surface: the next step is far shorter.
double Spacing(const LitView& view, std::size_t pixel, std::ptrdiff_t step)
{
  const std::ptrdiff_t next = Neighbor(view, pixel, step);
  if (next < 0)
  {
    return 0;
  }
  const double spacing = Distance(view.Place[pixel], view.Place[next]);
  const std::ptrdiff_t second = Neighbor(view, next, step);
  const bool other =
    second >= 0 && spacing > Break * Distance(view.Place[next], view.Place[second]);
  return other ? 0 : spacing;
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

BiasJudge::BiasJudge(LitView view, const std::vector<float>& unbiased, double band)
  : Seen(std::move(view))
  , Shadow(Seen.PixelCount())
  , Counts(Seen.Receiver)
{
  this->FindShadow(unbiased);
  std::vector<std::size_t> bordering;
  this->FindEdges(bordering);
  this->LeaveOutEdges(bordering, band);
  for (std::size_t i = 0; i < this->Counts.size(); ++i)
  {
    if (this->Counts[i])
    {
      ++(this->IsDark(i) ? this->Dark : this->Lit);
      (this->IsDark(i) ? this->LightOnDark : this->LightOnLit) += this->Seen.Light[i];
    }
  }
}

void BiasJudge::FindShadow(const std::vector<float>& unbiased)
{
  double all = 0, lost = 0;
  for (std::size_t i = 0; i < this->Shadow.size(); ++i)
  {
    const bool dark = IsTrulyDark(this->Seen, i);
    this->Shadow[i] = dark && unbiased[i] < 0.5f;
    this->Counts[i] = this->Counts[i] && dark == this->IsDark(i);
    all += dark;
    lost += dark && !this->IsDark(i);
  }
  this->LostShare = lost / std::max(1.0, all);
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
      if (step == 0 || !seen.Surface[a] || !seen.Surface[b])
      {
        continue;
      }
      if (IsTrulyDark(seen, a) != IsTrulyDark(seen, b))
      {
        bordering.push_back(a);
        bordering.push_back(b);
      }
      if (this->IsDark(a) != this->IsDark(b) && IsContinuous(seen, a, b, step))
      {
        const bool contact = !seen.Receiver[a] || !seen.Receiver[b];
        this->Edges.push_back({ Middle(seen.Place[a], seen.Place[b]),
          Middle(seen.Across[a], seen.Across[b]), this->IsDark(a) ? a : b, contact });
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

/// The patches of truly dark pixels that a mask lights, and where each borders on the dark.
class BiasJudge::Leaks
{
public:
  Leaks(const BiasJudge& judge, const std::vector<float>& mask)
    : Judge(judge)
    , Mask(mask)
    , PatchOf(mask.size(), None)
  {
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      if (this->IsLeak(i) && this->PatchOf[i] == None)
      {
        this->Gather(i);
      }
    }
  }

  /// From an edge to where the shadow begins; where it is gone, across all that it was.
  EdgeGap GapAt(const Edge& edge) const
  {
    const std::size_t index = this->PatchOf[edge.DarkPixel];
    if (index == None)
    {
      return {};
    }
    const Patch& patch = this->Patches[index];
    if (patch.Shore.empty())
    {
      return { patch.Across.Diagonal(), patch.World.Diagonal() };
    }
    const auto& begin = *std::min_element(
      patch.Shore.begin(), patch.Shore.end(), [&edge](const Place& a, const Place& b) {
        return vtkMath::Distance2BetweenPoints(edge.Place.data(), a.World.data()) <
          vtkMath::Distance2BetweenPoints(edge.Place.data(), b.World.data());
      });
    return { Distance(edge.Across, begin.Across), Distance(edge.Place, begin.World) };
  }

private:
  static constexpr std::size_t None = std::size_t(-1);

  struct Box
  {
    Vector Low = { 1e300, 1e300, 1e300 }, High = { -1e300, -1e300, -1e300 };
    void Add(const Vector& point)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->Low[k] = std::min(this->Low[k], point[k]);
        this->High[k] = std::max(this->High[k], point[k]);
      }
    }
    double Diagonal() const { return Distance(this->Low, this->High); }
  };

  struct Place
  {
    Vector World;
    Vector Across;
  };

  struct Patch
  {
    Box World;
    Box Across;
    std::vector<Place> Shore; ///< between its pixels and dark ones
  };

  bool IsLeak(std::size_t pixel) const
  {
    return this->Judge.IsDark(pixel) && this->Mask[pixel] > 0.5f;
  }

  /// The patch of a first pixel: all that hang together with it.
  void Gather(std::size_t first)
  {
    const LitView& seen = this->Judge.Seen;
    const std::size_t index = this->Patches.size();
    Patch patch;
    std::vector<std::size_t> open = { first };
    this->PatchOf[first] = index;
    while (!open.empty())
    {
      const std::size_t pixel = open.back();
      open.pop_back();
      patch.World.Add(seen.Place[pixel]);
      patch.Across.Add(seen.Across[pixel]);
      for (const std::ptrdiff_t step : { -1, 1, -seen.Width, seen.Width })
      {
        const std::ptrdiff_t next = Neighbor(seen, pixel, step);
        if (next < 0 || !this->Judge.IsDark(next) || !IsContinuous(seen, pixel, next, step))
        {
          continue;
        }
        if (!this->IsLeak(next))
        {
          patch.Shore.push_back({ Middle(seen.Place[pixel], seen.Place[next]),
            Middle(seen.Across[pixel], seen.Across[next]) });
        }
        else if (this->PatchOf[next] == None)
        {
          this->PatchOf[next] = index;
          open.push_back(next);
        }
      }
    }
    this->Patches.push_back(std::move(patch));
  }

  const BiasJudge& Judge;
  const std::vector<float>& Mask;
  std::vector<std::size_t> PatchOf; ///< of each pixel
  std::vector<Patch> Patches;
};

double BiasJudge::Error(const std::vector<float>& mask, std::size_t pixel) const
{
  return this->Counts[pixel] ? this->Seen.Truth[pixel] - mask[pixel] : 0.0;
}

BiasErrors BiasJudge::Measure(const std::vector<float>& mask) const
{
  BiasErrors errors;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    const double error = this->Seen.Light[i] * this->Error(mask, i);
    errors.Acne += std::max(error, 0.0);
    errors.Leak += std::max(-error, 0.0);
  }
  errors.Acne /= this->LightOnLit > 0 ? this->LightOnLit : 1;
  errors.Leak /= this->LightOnDark > 0 ? this->LightOnDark : 1;
  const Leaks leaks(*this, mask);
  Weighted texels[2], world[2];
  for (const Edge& edge : this->Edges)
  {
    const EdgeGap gap = leaks.GapAt(edge);
    const double weight = this->Seen.Light[edge.DarkPixel];
    texels[edge.Contact].Add(gap.Texels, weight);
    world[edge.Contact].Add(gap.World, weight);
  }
  errors.Outline = { texels[0].AtPercentile(Percentile), world[0].AtPercentile(Percentile) };
  errors.Contact = { texels[1].AtPercentile(Percentile), world[1].AtPercentile(Percentile) };
  return errors;
}
}
