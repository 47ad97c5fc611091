// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/sh_probes/AdaptiveGrids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace penumbra
{
namespace
{
// Squared errors are assumed to grow as this power of the cell size, as do those of interpolation across kinks.
// The grids that follow from it are tried before they are used (AdaptivePlacement).
constexpr double Order = 2.0;

// Number of slices along each axis, which bound the boxes. The first search takes this many slices at a time.
constexpr int Slices = 48;
constexpr int Stride = 4;

// Error that is assumed in any case, spread evenly over the points. Smaller errors are noise.
constexpr double BaseError = 0.002;

// A box is worth adding if it leaves less than this fraction of the predicted error.
constexpr double WorthwhileError = 0.9;

// Maximum ratio of a finer grid's cell size to the first grid's.
constexpr double FinerCell = 0.8;

// Minimum share of the probes for the first grid, because props may move to places without errors so far.
constexpr double MinimumShare = 0.35;

// Several grids must leave less than this fraction of a single grid's error.
constexpr double ClearlyLess = 0.9;

/// The slices in [Low, High).
struct Box
{
  glm::ivec3 Low{ 0 };
  glm::ivec3 High{ 0 };
  double Error = 0.0;
  double Weight = 0.0; ///< its volume to the power of Order / 3

  bool Contains(const Box& o) const
  {
    return glm::all(glm::lessThanEqual(this->Low, o.Low)) &&
      glm::all(glm::greaterThanEqual(this->High, o.High));
  }
  bool Overlaps(const Box& o) const
  {
    return glm::all(glm::lessThan(this->Low, o.High)) && glm::all(glm::lessThan(o.Low, this->High));
  }
};

/// Sums of errors over any box of slices (Crow 1984, Summed-Area Tables for Texture Mapping).
class ErrorTable
{
public:
  ErrorTable(const std::array<double, 6>& bounds, const std::vector<PointError>& errors)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Slice(axis, bounds[2 * axis], bounds[2 * axis + 1], errors);
    }
    const glm::ivec3 n = this->Counts() + 1;
    this->Sums.assign(static_cast<std::size_t>(n.x) * n.y * n.z, glm::dvec2(0.0));
    const double base = BaseError / static_cast<double>(std::max<std::size_t>(errors.size(), 1));
    for (const PointError& error : errors)
    {
      glm::ivec3 cell;
      for (int axis = 0; axis < 3; ++axis)
      {
        const std::vector<double>& planes = this->Planes[axis];
        const auto above =
          std::upper_bound(planes.begin() + 1, planes.end() - 1, error.Position[axis]);
        cell[axis] = static_cast<int>(above - planes.begin()) - 1;
      }
      this->At(cell + 1) += glm::dvec2(error.Error + base, error.Error * error.Error);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::ivec3 step(0);
      step[axis] = 1;
      glm::ivec3 at;
      for (at.z = step.z; at.z < n.z; ++at.z)
      {
        for (at.y = step.y; at.y < n.y; ++at.y)
        {
          for (at.x = step.x; at.x < n.x; ++at.x)
          {
            this->At(at) += this->At(at - step);
          }
        }
      }
    }
  }

  glm::ivec3 Counts() const
  {
    return { this->Planes[0].size() - 1, this->Planes[1].size() - 1, this->Planes[2].size() - 1 };
  }
  /// A conservative estimate: one standard deviation below the error found.
  double SureError(const Box& box) const
  {
    const glm::dvec2 sums = this->Sum(box);
    return std::max(sums.x - std::sqrt(std::max(sums.y, 0.0)), 0.0);
  }
  double Error(const Box& box) const { return std::max(this->Sum(box).x, 0.0); }
  glm::dvec3 Low(const Box& box) const { return this->Position(box.Low); }
  glm::dvec3 High(const Box& box) const { return this->Position(box.High); }

private:
  glm::dvec2 Sum(const Box& box) const
  {
    glm::dvec2 sum(0.0);
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::bvec3 high(corner & 1, corner & 2, corner & 4);
      const int sign = (corner & 1) + (corner >> 1 & 1) + (corner >> 2 & 1);
      sum += (sign % 2 ? 1.0 : -1.0) * this->At(glm::mix(box.Low, box.High, high));
    }
    return sum;
  }

  // Places a third of the slices evenly, and the others so that each holds the same share of the errors.
  void Slice(int axis, double low, double high, const std::vector<PointError>& errors)
  {
    std::vector<std::pair<double, double>> points; // position along the axis, weight
    double all = 0.0;
    for (const PointError& error : errors)
    {
      const double weight = std::max(error.Error, 0.0);
      points.emplace_back(error.Position[axis], weight);
      all += weight;
    }
    std::sort(points.begin(), points.end());
    std::vector<double> planes = { low, high };
    constexpr int evenSlices = Slices / 3;
    for (int i = 1; i < evenSlices; ++i)
    {
      planes.push_back(low + (high - low) * i / evenSlices);
    }
    double sum = 0.0;
    int next = 1;
    for (const auto& point : points)
    {
      sum += point.second;
      for (; next < Slices - evenSlices && sum * (Slices - evenSlices) > all * next; ++next)
      {
        planes.push_back(std::clamp(point.first, low, high));
      }
    }
    std::sort(planes.begin(), planes.end());
    const double close = 1e-4 * (high - low);
    const auto same = [close](double a, double b) { return b - a <= close; };
    planes.erase(std::unique(planes.begin(), planes.end() - 1, same), planes.end() - 1);
    this->Planes[axis] = planes;
  }

  glm::dvec3 Position(const glm::ivec3& at) const
  {
    return { this->Planes[0][at.x], this->Planes[1][at.y], this->Planes[2][at.z] };
  }
  std::size_t Index(const glm::ivec3& at) const
  {
    return at.x + this->Planes[0].size() * (at.y + this->Planes[1].size() * at.z);
  }
  glm::dvec2& At(const glm::ivec3& at) { return this->Sums[this->Index(at)]; }
  const glm::dvec2& At(const glm::ivec3& at) const { return this->Sums[this->Index(at)]; }

  std::vector<double> Planes[3];
  /// Sums of errors and of their squares over everything below a corner.
  std::vector<glm::dvec2> Sums;
};

/// Chooses boxes for finer grids, and distributes the probes among them. A grid of n probes in a volume V is predicted
/// to leave E (V / n)^(Order / 3) of an error E. For a fixed total number of probes, the sum is smallest if each n is
/// proportional to Need(), and it grows with the sum of all needs.
class BoxSearch
{
public:
  BoxSearch(const ErrorTable& table, const ProbeGrid& around, int probes)
    : Table(table)
    , Probes(probes)
  {
    const glm::dvec3 size = around.Spacing * glm::dvec3(around.Counts - 1);
    this->Boxes.push_back({ glm::ivec3(0), table.Counts() });
    this->Boxes[0].Error = table.Error(this->Boxes[0]);
    this->Boxes[0].Weight = std::pow(size.x * size.y * size.z, Order / 3.0);
  }

  std::vector<Box> Boxes; ///< the first contains everything

  /// Add the box that reduces the error most, if any does.
  bool Add()
  {
    const double before = this->Total();
    this->Boxes.push_back(Box());
    const bool better =
      this->FindBest(this->Boxes.back()) && this->ErrorLeft(before) < WorthwhileError;
    if (!better)
    {
      this->Boxes.pop_back();
    }
    return better;
  }

  /// Move each box to where it reduces the error most, given the others.
  void Improve()
  {
    for (std::size_t i = 1; i < this->Boxes.size(); ++i)
    {
      this->FindBest(this->Boxes[i]);
    }
  }

  void Remove(std::size_t number)
  {
    this->Boxes.erase(this->Boxes.begin() + static_cast<std::ptrdiff_t>(number));
  }

  /// The share of the probes for each box.
  std::vector<double> Shares() const
  {
    std::vector<double> needs;
    double sum = 0.0;
    for (std::size_t i = 0; i < this->Boxes.size(); ++i)
    {
      needs.push_back(*this->Need(i));
      sum += needs.back();
    }
    for (double& need : needs)
    {
      need /= std::max(sum, 1e-300);
    }
    return needs;
  }

private:
  double Weight(const Box& box) const
  {
    const glm::dvec3 size = this->Table.High(box) - this->Table.Low(box);
    // Enlarged by the cells over which the grid's light fades, as if a third of the probes were in it.
    const double longest = std::max({ size.x, size.y, size.z });
    glm::dvec3 sides = glm::max(size, glm::dvec3(0.1 * longest));
    for (int i = 0; i < 4; ++i)
    {
      sides = size + 3.0 * std::cbrt(3.0 * sides.x * sides.y * sides.z / this->Probes);
    }
    return std::pow(sides.x * sides.y * sides.z, Order / 3.0);
  }

  /// Number that the box's probes should be proportional to; none if it partly overlaps another box.
  std::optional<double> Need(std::size_t number) const
  {
    const Box& box = this->Boxes[number];
    double error = box.Error;
    for (std::size_t i = 0; i < this->Boxes.size(); ++i)
    {
      const Box& other = this->Boxes[i];
      if (i == number || other.Contains(box) || !other.Overlaps(box))
      {
        continue;
      }
      if (!box.Contains(other))
      {
        return std::nullopt;
      }
      bool nearest = true; // no third box lies between them
      for (std::size_t k = 0; k < this->Boxes.size(); ++k)
      {
        nearest = nearest &&
          (k == i || k == number ||
            !(box.Contains(this->Boxes[k]) && this->Boxes[k].Contains(other)));
      }
      error -= nearest ? other.Error : 0.0;
    }
    constexpr double power = 1.0 / (1.0 + Order / 3.0);
    return std::pow(std::max(error, 0.0) * box.Weight, power);
  }

  double Total() const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < this->Boxes.size(); ++i)
    {
      const std::optional<double> need = this->Need(i);
      if (!need)
      {
        return std::numeric_limits<double>::infinity();
      }
      sum += *need;
    }
    return sum;
  }

  /// Fraction of the error that is left, relative to a previous total.
  double ErrorLeft(double before) const
  {
    return std::pow(this->Total() / std::max(before, 1e-300), 1.0 + Order / 3.0);
  }

  /// Set one of Boxes to the box with the smallest total. Returns whether any box fits.
  bool FindBest(Box& box)
  {
    const glm::ivec3 n = this->Table.Counts();
    double least = std::numeric_limits<double>::infinity();
    Box best;
    const auto attempt = [&](const glm::ivec3& low, const glm::ivec3& high) {
      const double total = this->TotalWith(box, low, high);
      const bool better = total < least;
      best = better ? box : best;
      least = better ? total : least;
      return better;
    };
    // Start from the current box,
    attempt(glm::ivec3(box.Low), glm::ivec3(box.High));
    // try all boxes on a coarser grid of slices,
    const glm::ivec3 count = (n + Stride - 1) / Stride;
    for (glm::ivec3 low(0); low.z < count.z; Advance(low, count))
    {
      for (glm::ivec3 high = low + 1; high.z <= count.z; Advance(high, count + 1, low + 1))
      {
        attempt(low * Stride, glm::min(high * Stride, n));
      }
    }
    // then move single sides.
    for (bool better = std::isfinite(least); better;)
    {
      better = false;
      for (int axis = 0; axis < 3; ++axis)
      {
        for (int at = 0; at <= n[axis]; ++at)
        {
          glm::ivec3 low = best.Low;
          low[axis] = at;
          better = attempt(low, best.High) || better;
          glm::ivec3 high = best.High;
          high[axis] = at;
          better = attempt(best.Low, high) || better;
        }
      }
    }
    box = best;
    return std::isfinite(least);
  }

  /// The total with one of Boxes changed; infinite if that box is not possible.
  double TotalWith(Box& box, const glm::ivec3& low, const glm::ivec3& high)
  {
    constexpr double notable = 0.02; // fraction of all errors
    box = { low, high };
    const bool any = glm::all(glm::lessThan(low, high)) && !box.Contains(this->Boxes[0]);
    box.Error = any ? this->Table.SureError(box) : 0.0;
    if (!any || box.Error < notable * this->Boxes[0].Error)
    {
      return std::numeric_limits<double>::infinity();
    }
    box.Weight = this->Weight(box);
    return this->Total();
  }

  static void Advance(
    glm::ivec3& at, const glm::ivec3& end, const glm::ivec3& first = glm::ivec3(0))
  {
    ++at.x;
    for (int axis = 0; axis < 2 && at[axis] >= end[axis]; ++axis)
    {
      at[axis] = first[axis];
      ++at[axis + 1];
    }
  }

  const ErrorTable& Table;
  double Probes;
};

/// The grids for the chosen boxes. The first contains everything; others that would be of no use are empty.
std::vector<ProbeGrid> GridsOf(const BoxSearch& search, const std::vector<double>& shares,
  const ErrorTable& table, const std::array<double, 6>& bounds, int probes)
{
  const double first = std::max(shares[0], MinimumShare);
  const ProbeGrid around = ProbeGrid::Around(bounds, static_cast<int>(first * probes));
  const double remaining = (probes - around.Size()) / std::max(1.0 - shares[0], 1e-9);
  std::vector<ProbeGrid> grids = { around };
  for (std::size_t i = 1; i < shares.size(); ++i)
  {
    const auto count = static_cast<int>(remaining * shares[i]);
    const ProbeGrid grid = count < ProbeGrid::MinimumPart
      ? ProbeGrid()
      : around.Part(table.Low(search.Boxes[i]), table.High(search.Boxes[i]), count);
    grids.push_back(grid.Detail() < FinerCell * around.Detail() ? grid : ProbeGrid());
  }
  return grids;
}
}

ProbeGrids AdaptiveGrids(
  const std::array<double, 6>& bounds, int probes, const std::vector<PointError>& errors)
{
  const ProbeGrid single = ProbeGrid::Around(bounds, probes);
  const ErrorTable table(bounds, errors);
  BoxSearch search(table, single, probes);
  while (static_cast<int>(search.Boxes.size()) < ProbeGrids::Most && search.Add())
  {
    search.Improve();
  }
  std::vector<ProbeGrid> grids;
  for (std::size_t unused = 1; unused > 0;)
  {
    const std::vector<double> shares = search.Shares();
    grids = GridsOf(search, shares, table, bounds, probes);
    unused = 0;
    for (std::size_t i = 1; i < grids.size(); ++i)
    {
      const bool worst = unused == 0 || shares[i] < shares[unused];
      unused = grids[i].IsEmpty() && worst ? i : unused;
    }
    // The others get its probes.
    if (unused > 0)
    {
      search.Remove(unused);
    }
  }
  if (grids.size() == 1)
  {
    return ProbeGrids(single);
  }
  std::stable_sort(grids.begin() + 1, grids.end(),
    [](const ProbeGrid& a, const ProbeGrid& b) { return a.Detail() > b.Detail(); });
  return ProbeGrids(std::move(grids));
}

bool AreClearlyLess(const std::vector<PointError>& others, const std::vector<PointError>& errors)
{
  double all = 0.0;
  double less = 0.0;
  double squares = 0.0;
  const std::size_t count = std::min(others.size(), errors.size());
  for (std::size_t i = 0; i < count; ++i)
  {
    const double difference = ClearlyLess * errors[i].Error - others[i].Error;
    all += errors[i].Error;
    less += difference;
    squares += difference * difference;
  }
  // Variance of the sum of these random differences.
  const double n = static_cast<double>(count);
  const double variance = count > 1 ? (squares - less * less / n) * n / (n - 1.0) : 0.0;
  return count > 1 && all > 0.0 && less > std::sqrt(std::max(variance, 0.0));
}
}
