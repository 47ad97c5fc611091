// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/FormFactors.h"

#include "bake/radiosity/Sampling.h"

#include <algorithm>
#include <cmath>

namespace penumbra::radiosity
{
namespace
{
struct Row
{
  std::vector<FactorMatrix::Entry> Entries;
  float Escaped = 1.0f;
  Color Sky{ 0.0 };
};

/// Elements met, in any order and repeated, as shares.
std::vector<FactorMatrix::Entry> Histogram(std::vector<std::uint32_t>& met, int rays)
{
  std::sort(met.begin(), met.end());
  std::vector<FactorMatrix::Entry> entries;
  for (std::size_t i = 0; i < met.size();)
  {
    std::size_t end = i;
    for (; end < met.size() && met[end] == met[i]; ++end)
    {
    }
    entries.push_back({ met[i], static_cast<float>(end - i) / static_cast<float>(rays) });
    i = end;
  }
  return entries;
}

Row TraceRow(
  const Element& element, std::size_t index, const PatchRays& rays, int side, const Sky& sky)
{
  Random random(index, 1);
  const auto points = Strata(side, random);
  const auto directions = Strata(side, random);
  const int count = side * side;
  std::vector<std::uint32_t> met;
  met.reserve(points.size());
  Row row;
  for (int i = 0; i < count; ++i)
  {
    const Point direction = CosineDirection(element.Normal, directions[i]);
    const auto hit = rays.Nearest(element.At(points[i].x, points[i].y), element.Normal, direction);
    if (hit.Element != PatchRays::Nothing)
    {
      met.push_back(hit.Element);
    }
    else if (sky)
    {
      row.Sky += sky(direction);
    }
  }
  row.Escaped = 1.0f - static_cast<float>(met.size()) / static_cast<float>(count);
  row.Sky *= glm::pi<double>() / count;
  row.Entries = Histogram(met, count);
  return row;
}

TracedRows Flatten(const std::vector<Row>& rows)
{
  TracedRows traced;
  for (const Row& row : rows)
  {
    traced.Lengths.push_back(static_cast<std::uint32_t>(row.Entries.size()));
    traced.Entries.insert(traced.Entries.end(), row.Entries.begin(), row.Entries.end());
    traced.Escaped.push_back(row.Escaped);
    traced.Sky.push_back(row.Sky);
  }
  return traced;
}

FactorMatrix Join(const std::vector<std::vector<FactorMatrix::Entry>>& rows, int rays)
{
  FactorMatrix matrix;
  matrix.Rays = rays;
  matrix.Begin.reserve(rows.size() + 1);
  std::size_t total = 0;
  for (const auto& row : rows)
  {
    total += row.size();
    matrix.Begin.push_back(total);
  }
  matrix.Entries.reserve(total);
  for (const auto& row : rows)
  {
    matrix.Entries.insert(matrix.Entries.end(), row.begin(), row.end());
  }
  return matrix;
}

/// Of the same exchange between i and j, the estimates from both ends.
std::vector<FactorMatrix::Entry> Merge(const FactorMatrix& matrix, const FactorMatrix& from,
  const std::vector<Element>& elements, std::size_t row)
{
  // The rays that i sends a unit of its area are the weight of its estimate A_i F_ij.
  std::vector<FactorMatrix::Entry> merged;
  std::size_t a = matrix.Begin[row];
  std::size_t b = from.Begin[row];
  const double own = elements[row].Area;
  while (a < matrix.Begin[row + 1] || b < from.Begin[row + 1])
  {
    constexpr std::uint32_t none = 0xffffffffu;
    const std::uint32_t here = a < matrix.Begin[row + 1] ? matrix.Entries[a].Column : none;
    const std::uint32_t there = b < from.Begin[row + 1] ? from.Entries[b].Column : none;
    const std::uint32_t column = std::min(here, there);
    const double other = elements[column].Area;
    const double hits = (column == here ? matrix.Entries[a++].Value : 0.0) +
      (column == there ? from.Entries[b++].Value : 0.0);
    // (hits_ij + hits_ji) / (1 / A_i + 1 / A_j), over A_i.
    merged.push_back({ column, static_cast<float>(hits * other / (own + other)) });
  }
  return merged;
}

void Balance(FactorMatrix& matrix, const std::vector<float>& escaped)
{
  const std::size_t count = matrix.Size();
  std::vector<double> scale(count, 1.0);
  constexpr int most = 200;
  constexpr double enough = 1e-5;
  for (int round = 0; round < most; ++round)
  {
    double worst = 0.0;
    std::vector<double> next = scale;
    for (std::size_t i = 0; i < count; ++i)
    {
      double sum = 0.0;
      matrix.ForEachIn(i, [&](std::size_t j, double value) { sum += scale[i] * value * scale[j]; });
      const double target = 1.0 - escaped[i];
      if (sum > 0.0 && target > 0.0)
      {
        worst = std::max(worst, std::abs(sum / target - 1.0));
        // The root: both ends of an exchange answer for it.
        next[i] *= std::sqrt(target / sum);
      }
    }
    scale.swap(next);
    if (worst < enough)
    {
      break;
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t k = matrix.Begin[i]; k < matrix.Begin[i + 1]; ++k)
    {
      auto& entry = matrix.Entries[k];
      entry.Value = static_cast<float>(entry.Value * scale[i] * scale[entry.Column]);
    }
  }
}
}

double FactorMatrix::RowSum(std::size_t row) const
{
  double sum = 0.0;
  this->ForEachIn(row, [&](std::size_t, double value) { sum += value; });
  return sum;
}

double FactorMatrix::At(std::size_t row, std::size_t column) const
{
  double found = 0.0;
  this->ForEachIn(row, [&](std::size_t j, double value) { found += j == column ? value : 0.0; });
  return found;
}

Factors TraceFactors(const std::vector<Element>& elements, const PatchRays& rays, int count,
  const Sky& sky, const tool::Progress& advance, FactorLog* log)
{
  constexpr std::size_t block = 2048; // rows between two writings of what was traced
  const int side = GridSide(count);
  const std::string mesh = log ? Fingerprint(elements) : "";
  Factors factors;
  FactorMatrix& matrix = factors.Matrix;
  matrix.Rays = side * side;
  for (std::size_t first = 0; first < elements.size(); first += block)
  {
    const std::size_t number = std::min(block, elements.size() - first);
    TracedRows traced;
    if (!log || !log->Take(mesh, first, traced))
    {
      std::vector<Row> rows(number);
      const auto trace = [&](std::size_t i) {
        if (elements[first + i].Present)
        {
          rows[i] = TraceRow(elements[first + i], first + i, rays, side, sky);
        }
      };
      tool::ForEach(number, trace, [&](double share) {
        if (advance)
        {
          advance((double(first) + share * double(number)) / double(elements.size()));
        }
      });
      traced = Flatten(rows);
      if (log)
      {
        log->Put(mesh, first, traced);
      }
    }
    for (const std::uint32_t length : traced.Lengths)
    {
      matrix.Begin.push_back(matrix.Begin.back() + length);
    }
    matrix.Entries.insert(matrix.Entries.end(), traced.Entries.begin(), traced.Entries.end());
    factors.Escaped.insert(factors.Escaped.end(), traced.Escaped.begin(), traced.Escaped.end());
    factors.SkyIrradiance.insert(factors.SkyIrradiance.end(), traced.Sky.begin(), traced.Sky.end());
  }
  return factors;
}

FactorMatrix Transpose(const FactorMatrix& matrix)
{
  FactorMatrix turned;
  turned.Rays = matrix.Rays;
  turned.Begin.assign(matrix.Size() + 1, 0);
  for (const auto& entry : matrix.Entries)
  {
    ++turned.Begin[entry.Column + 1];
  }
  for (std::size_t i = 0; i < matrix.Size(); ++i)
  {
    turned.Begin[i + 1] += turned.Begin[i];
  }
  turned.Entries.resize(matrix.Entries.size());
  std::vector<std::size_t> next(turned.Begin.begin(), turned.Begin.end() - 1);
  for (std::size_t i = 0; i < matrix.Size(); ++i)
  {
    matrix.ForEachIn(i, [&](std::size_t j, double value) {
      turned.Entries[next[j]++] = { static_cast<std::uint32_t>(i), static_cast<float>(value) };
    });
  }
  return turned;
}

void MakeReciprocal(
  FactorMatrix& matrix, const std::vector<Element>& elements, const std::vector<float>& escaped)
{
  const FactorMatrix from = Transpose(matrix);
  std::vector<std::vector<FactorMatrix::Entry>> rows(matrix.Size());
  tool::ForEach(rows.size(), [&](std::size_t i) { rows[i] = Merge(matrix, from, elements, i); });
  matrix = Join(rows, matrix.Rays);
  Balance(matrix, escaped);
}

std::vector<Color> GatherError(const FactorMatrix& matrix, const std::vector<Color>& radiosity)
{
  std::vector<Color> errors(matrix.Size(), Color(0.0));
  for (std::size_t i = 0; i < matrix.Size(); ++i)
  {
    Color mean(0.0);
    Color square(0.0);
    matrix.ForEachIn(i, [&](std::size_t j, double share) {
      mean += share * radiosity[j];
      square += share * radiosity[j] * radiosity[j];
    });
    errors[i] = glm::sqrt(glm::max(square - mean * mean, 0.0) / std::max(1.0, matrix.Rays - 1.0));
  }
  return errors;
}
}
