// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What something costs, by processor time of all threads. Other programs on the machine change the clock of its cores and
 * its caches meanwhile, and so what is compared takes turns, each measured beside its neighbours.
 */
#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

namespace penumbra_test
{
/// Processor seconds of a piece of work.
template <typename Work>
double SecondsOf(const Work& work)
{
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

inline double MedianOf(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// The median of what one takes, of what the other takes before and after it. Both return seconds.
template <typename With, typename Without>
double CostRatio(int turns, const With& with, const Without& without)
{
  std::vector<double> ratios;
  double before = without();
  for (int i = 0; i < turns; ++i)
  {
    const double seconds = with();
    const double after = without();
    ratios.push_back(2.0 * seconds / (before + after));
    before = after;
  }
  return MedianOf(ratios);
}

/// The least of what several runs measure, until one is within the limit: what other programs do makes a cost look larger
/// more often than smaller.
template <typename Measure>
double LeastOf(int tries, double limit, const Measure& measure)
{
  double least = measure();
  for (int i = 1; i < tries && least > limit; ++i)
  {
    least = std::min(least, measure());
  }
  return least;
}
}
