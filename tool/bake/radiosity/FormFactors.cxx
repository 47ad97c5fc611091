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

/// Shares of the elements in a list of hits.
std::vector<FactorMatrix::Entry> Histogram(std::vector<std::uint32_t>& hits, int rays)
{
  std::sort(hits.begin(), hits.end());
  std::vector<FactorMatrix::Entry> entries;
  for (std::size_t i = 0; i < hits.size();)
  {
    std::size_t end = i;
    for (; end < hits.size() && hits[end] == hits[i]; ++end)
    {
    }
    entries.push_back({ hits[i], static_cast<float>(end - i) / static_cast<float>(rays) });
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
  std::vector<std::uint32_t> hits;
  hits.reserve(points.size());
  Row row;
  for (int i = 0; i < count; ++i)
  {
    const Point direction = CosineDirection(element.Normal, directions[i]);
    const auto hit = rays.Nearest(element.At(points[i].x, points[i].y), element.Normal, direction);
    if (hit.Element != PatchRays::Nothing)
    {
      hits.push_back(hit.Element);
    }
    else if (sky)
    {
      row.Sky += sky(direction);
    }
  }
  row.Escaped = 1.0f - static_cast<float>(hits.size()) / static_cast<float>(count);
  row.Sky *= glm::pi<double>() / count;
  row.Entries = Histogram(hits, count);
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

/// A row with both estimates of each exchange combined.
std::vector<FactorMatrix::Entry> Merge(const FactorMatrix& matrix, const FactorMatrix& from,
  const std::vector<Element>& elements, std::size_t row)
{
  // The weight of the estimate A_i F_ij is the number of rays per area of i.
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
        // The root, because an exchange is scaled at both ends.
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

void FactorMatrix::AddRow(const std::vector<Entry>& row)
{
  this->Entries.insert(this->Entries.end(), row.begin(), row.end());
  this->Begin.push_back(this->Entries.size());
}

Factors TraceFactors(const std::vector<Element>& elements, const PatchRays& rays, int count,
  const Sky& sky, const tool::Progress& advance, FactorLog* log)
{
  constexpr std::size_t block = 2048; // rows written to the log at a time
  const int side = GridSide(count);
  const std::string mesh = log ? Fingerprint(elements) : "";
  Factors factors;
  FactorMatrix& matrix = factors.Matrix;
  matrix.Rays = side * side;
  for (std::size_t first = 0; first < elements.size(); first += block)
  {
    const std::size_t number = std::min(block, elements.size() - first);
    TracedRows traced;
    if (!log || !log->Read(mesh, first, traced))
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
        log->Append(mesh, first, traced);
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
  FactorMatrix transposed;
  transposed.Rays = matrix.Rays;
  transposed.Begin.assign(matrix.Size() + 1, 0);
  for (const auto& entry : matrix.Entries)
  {
    ++transposed.Begin[entry.Column + 1];
  }
  for (std::size_t i = 0; i < matrix.Size(); ++i)
  {
    transposed.Begin[i + 1] += transposed.Begin[i];
  }
  transposed.Entries.resize(matrix.Entries.size());
  std::vector<std::size_t> next(transposed.Begin.begin(), transposed.Begin.end() - 1);
  for (std::size_t i = 0; i < matrix.Size(); ++i)
  {
    matrix.ForEachIn(i, [&](std::size_t j, double value) {
      transposed.Entries[next[j]++] = { static_cast<std::uint32_t>(i), static_cast<float>(value) };
    });
  }
  return transposed;
}

void MakeReciprocal(
  FactorMatrix& matrix, const std::vector<Element>& elements, const std::vector<float>& escaped)
{
  const FactorMatrix from = Transpose(matrix);
  std::vector<std::vector<FactorMatrix::Entry>> rows(matrix.Size());
  tool::ForEach(rows.size(), [&](std::size_t i) { rows[i] = Merge(matrix, from, elements, i); });
  FactorMatrix combined;
  combined.Rays = matrix.Rays;
  for (const auto& row : rows)
  {
    combined.AddRow(row);
  }
  matrix = std::move(combined);
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
