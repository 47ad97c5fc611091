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
// Squared errors are taken to grow as this power of a cell's size, as those of interpolation between kinks do. What comes of it is tried.
constexpr double Order = 2.0;

// Along each axis, for the sides of boxes; and how many of them boxes are made of at first.
constexpr int Slices = 48;
constexpr int Stride = 4;

// What is taken to err in any case, spread evenly: smaller errors are found by chance.
constexpr double Everywhere = 0.002;

// Of the error predicted: a box that leaves more is not worth its trouble.
constexpr double LeastGain = 0.9;

// The cell of a finer grid, of the first one's, at most.
constexpr double Finer = 0.8;

// Of the probes, for the first grid: things may move where nothing errs yet.
constexpr double LeastShare = 0.35;

// What several grids must leave at most of one grid's error.
constexpr double ClearlyLess = 0.9;

/// Slices from Low to High, that one not counted.
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
  bool Meets(const Box& o) const
  {
    return glm::all(glm::lessThan(this->Low, o.High)) && glm::all(glm::lessThan(o.Low, this->High));
  }
};

/// Errors by slices of the scene, and their sums over any box (Crow 1984, Summed-Area Tables for Texture Mapping).
class ErrorTable
{
public:
  ErrorTable(const std::array<double, 6>& bounds, const std::vector<ErrorAt>& errors)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Slice(axis, bounds[2 * axis], bounds[2 * axis + 1], errors);
    }
    const glm::ivec3 n = this->Counts() + 1;
    this->Sums.assign(static_cast<std::size_t>(n.x) * n.y * n.z, glm::dvec2(0.0));
    const double even = Everywhere / static_cast<double>(std::max<std::size_t>(errors.size(), 1));
    for (const ErrorAt& error : errors)
    {
      glm::ivec3 cell;
      for (int axis = 0; axis < 3; ++axis)
      {
        const std::vector<double>& planes = this->Planes[axis];
        const auto above =
          std::upper_bound(planes.begin() + 1, planes.end() - 1, error.Place[axis]);
        cell[axis] = static_cast<int>(above - planes.begin()) - 1;
      }
      this->At(cell + 1) += glm::dvec2(error.Error + even, error.Error * error.Error);
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
  /// At least so much, whatever chance did: a standard deviation less than what was found.
  double SureError(const Box& box) const
  {
    const glm::dvec2 sums = this->Sum(box);
    return std::max(sums.x - std::sqrt(std::max(sums.y, 0.0)), 0.0);
  }
  double Error(const Box& box) const { return std::max(this->Sum(box).x, 0.0); }
  glm::dvec3 Low(const Box& box) const { return this->Place(box.Low); }
  glm::dvec3 High(const Box& box) const { return this->Place(box.High); }

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

  // A third of the slices even, the others so that the errors are spread evenly over them.
  void Slice(int axis, double low, double high, const std::vector<ErrorAt>& errors)
  {
    std::vector<std::pair<double, double>> along;
    double all = 0.0;
    for (const ErrorAt& error : errors)
    {
      const double weight = std::max(error.Error, 0.0);
      along.emplace_back(error.Place[axis], weight);
      all += weight;
    }
    std::sort(along.begin(), along.end());
    std::vector<double> planes = { low, high };
    constexpr int even = Slices / 3;
    for (int i = 1; i < even; ++i)
    {
      planes.push_back(low + (high - low) * i / even);
    }
    double sum = 0.0;
    int next = 1;
    for (const auto& place : along)
    {
      sum += place.second;
      for (; next < Slices - even && sum * (Slices - even) > all * next; ++next)
      {
        planes.push_back(std::clamp(place.first, low, high));
      }
    }
    std::sort(planes.begin(), planes.end());
    const double close = 1e-4 * (high - low);
    const auto same = [close](double a, double b) { return b - a <= close; };
    planes.erase(std::unique(planes.begin(), planes.end() - 1, same), planes.end() - 1);
    this->Planes[axis] = planes;
  }

  glm::dvec3 Place(const glm::ivec3& at) const
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
  std::vector<glm::dvec2> Sums; ///< of errors and of their squares, all before a corner
};

/// The choice of boxes, and how the probes are shared among them. A grid of n probes in a volume V is predicted to
/// leave E (V / n)^(Order / 3) of an error E. The least sum is left where n is in proportion to what Need() returns, and
/// is, for one number of probes, the greater the sum of needs.
class Choice
{
public:
  Choice(const ErrorTable& table, const ProbeGrid& around, int probes)
    : Table(table)
    , Probes(probes)
  {
    const glm::dvec3 size = around.Spacing * glm::dvec3(around.Counts - 1);
    this->Boxes.push_back({ glm::ivec3(0), table.Counts() });
    this->Boxes[0].Error = table.Error(this->Boxes[0]);
    this->Boxes[0].Weight = std::pow(size.x * size.y * size.z, Order / 3.0);
  }

  std::vector<Box> Boxes; ///< first the one around all

  /// Add the box that helps most, if any helps.
  bool Add()
  {
    const double before = this->Total();
    this->Boxes.push_back(Box());
    const bool better = this->Best(this->Boxes.back()) && this->Left(before) < LeastGain;
    if (!better)
    {
      this->Boxes.pop_back();
    }
    return better;
  }

  /// Move each box to where it helps most beside the others.
  void Improve()
  {
    for (std::size_t i = 1; i < this->Boxes.size(); ++i)
    {
      this->Best(this->Boxes[i]);
    }
  }

  /// Leave one out.
  void Remove(std::size_t number)
  {
    this->Boxes.erase(this->Boxes.begin() + static_cast<std::ptrdiff_t>(number));
  }

  /// Of each box, its share of the probes.
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
    // A cell more on every side, where its light fades. As if a third of the probes were there.
    const double longest = std::max({ size.x, size.y, size.z });
    glm::dvec3 sides = glm::max(size, glm::dvec3(0.1 * longest));
    for (int i = 0; i < 4; ++i)
    {
      sides = size + 3.0 * std::cbrt(3.0 * sides.x * sides.y * sides.z / this->Probes);
    }
    return std::pow(sides.x * sides.y * sides.z, Order / 3.0);
  }

  /// Nothing where it overlaps another in part.
  std::optional<double> Need(std::size_t number) const
  {
    const Box& box = this->Boxes[number];
    double error = box.Error;
    for (std::size_t i = 0; i < this->Boxes.size(); ++i)
    {
      const Box& other = this->Boxes[i];
      if (i == number || other.Contains(box) || !other.Meets(box))
      {
        continue;
      }
      if (!box.Contains(other))
      {
        return std::nullopt;
      }
      bool nearest = true; // no other is between them
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

  /// Error that is left, of that with a total before.
  double Left(double before) const
  {
    return std::pow(this->Total() / std::max(before, 1e-300), 1.0 + Order / 3.0);
  }

  /// Finds the box for one of Boxes with which the total is least. Returns whether any fits in.
  bool Best(Box& box)
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
    // First where it is,
    attempt(glm::ivec3(box.Low), glm::ivec3(box.High));
    // all boxes of several slices,
    const glm::ivec3 some = (n + Stride - 1) / Stride;
    for (glm::ivec3 low(0); low.z < some.z; Next(low, some))
    {
      for (glm::ivec3 high = low + 1; high.z <= some.z; Next(high, some + 1, low + 1))
      {
        attempt(low * Stride, glm::min(high * Stride, n));
      }
    }
    // then side by side.
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

  /// With one of Boxes put there; infinite where it cannot be.
  double TotalWith(Box& box, const glm::ivec3& low, const glm::ivec3& high)
  {
    constexpr double notable = 0.02; // of the errors
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

  static void Next(glm::ivec3& at, const glm::ivec3& end, const glm::ivec3& first = glm::ivec3(0))
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

/// The grids of a choice, each around its box but the first; those that are of no use are empty.
std::vector<ProbeGrid> GridsOf(const Choice& choice, const std::vector<double>& shares,
  const ErrorTable& table, const std::array<double, 6>& bounds, int probes)
{
  const double first = std::max(shares[0], LeastShare);
  const ProbeGrid around = ProbeGrid::Around(bounds, static_cast<int>(first * probes));
  const double others = (probes - around.Size()) / std::max(1.0 - shares[0], 1e-9);
  std::vector<ProbeGrid> grids = { around };
  for (std::size_t i = 1; i < shares.size(); ++i)
  {
    const auto some = static_cast<int>(others * shares[i]);
    const ProbeGrid grid = some < ProbeGrid::LeastPart
      ? ProbeGrid()
      : around.Part(table.Low(choice.Boxes[i]), table.High(choice.Boxes[i]), some);
    grids.push_back(grid.Detail() < Finer * around.Detail() ? grid : ProbeGrid());
  }
  return grids;
}
}

ProbeGrids AdaptiveGrids(
  const std::array<double, 6>& bounds, int probes, const std::vector<ErrorAt>& errors)
{
  const ProbeGrid alone = ProbeGrid::Around(bounds, probes);
  const ErrorTable table(bounds, errors);
  Choice choice(table, alone, probes);
  while (static_cast<int>(choice.Boxes.size()) < ProbeGrids::Most && choice.Add())
  {
    choice.Improve();
  }
  std::vector<ProbeGrid> grids;
  for (std::size_t useless = 1; useless > 0;)
  {
    const std::vector<double> shares = choice.Shares();
    grids = GridsOf(choice, shares, table, bounds, probes);
    useless = 0;
    for (std::size_t i = 1; i < grids.size(); ++i)
    {
      const bool worst = useless == 0 || shares[i] < shares[useless];
      useless = grids[i].IsEmpty() && worst ? i : useless;
    }
    // Its probes are for the others.
    if (useless > 0)
    {
      choice.Remove(useless);
    }
  }
  if (grids.size() == 1)
  {
    return ProbeGrids(alone);
  }
  std::stable_sort(grids.begin() + 1, grids.end(),
    [](const ProbeGrid& a, const ProbeGrid& b) { return a.Detail() > b.Detail(); });
  return ProbeGrids(std::move(grids));
}

bool AreClearlyLess(const std::vector<ErrorAt>& others, const std::vector<ErrorAt>& errors)
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
  // Of the sum of so many differences that chance drew.
  const double n = static_cast<double>(count);
  const double variance = count > 1 ? (squares - less * less / n) * n / (n - 1.0) : 0.0;
  return count > 1 && all > 0.0 && less > std::sqrt(std::max(variance, 0.0));
}
}
