// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Case.h"

#include <algorithm>
#include <numeric>

namespace validate
{
namespace
{
double Sum(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double StandardErrorOfMean(const std::vector<double>& values)
{
  const double count = static_cast<double>(values.size());
  const double mean = Sum(values) / count;
  double squares = 0.0;
  for (double value : values)
  {
    squares += (value - mean) * (value - mean);
  }
  return std::sqrt(squares / (count - 1.0) / count);
}
}

Outcome MeanOfEqual(const Film& film, double unit)
{
  Outcome outcome;
  outcome.Measured = Sum(film.Luminance) / static_cast<double>(film.Luminance.size()) / unit;
  outcome.StandardError = StandardErrorOfMean(film.Luminance) / unit;
  return outcome;
}

Outcome MeanOfSurface(const Film& film, double unit)
{
  double variance = 0.0;
  for (std::size_t i = 0; i < film.Luminance.size(); ++i)
  {
    const double mean = film.Luminance[i];
    variance += std::max(0.0, film.SquareMean[i] - mean * mean) / (film.Samples - 1.0);
  }
  const double covered = Sum(film.Coverage);
  Outcome outcome;
  outcome.Measured = Sum(film.Luminance) / covered / unit;
  outcome.StandardError = std::sqrt(variance) / covered / unit;
  return outcome;
}

Outcome MeanComparedTo(const Film& film, const Film& other)
{
  std::vector<double> differences;
  for (std::size_t i = 0; i < film.Luminance.size(); ++i)
  {
    differences.push_back(film.Luminance[i] - other.Luminance[i]);
  }
  const double count = static_cast<double>(differences.size());
  Outcome outcome;
  outcome.Expected = Sum(other.Luminance) / count;
  outcome.Measured = outcome.Expected + Sum(differences) / count;
  outcome.StandardError = StandardErrorOfMean(differences);
  return outcome;
}
}
