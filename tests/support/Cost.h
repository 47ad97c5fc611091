// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cost of a function in processor time of all threads. Other programs on the machine affect clock rates and caches, so
 * the functions to be compared run in turns, and each run is compared with those before and after it.
 */
#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

namespace penumbra_test
{
/// Processor seconds of a call.
template <typename Function>
double SecondsOf(const Function& function)
{
  const std::clock_t start = std::clock();
  function();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

inline double MedianOf(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// Median ratio of the seconds that the first function returns to those that the second returns before and after it.
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

/// Minimum of several measurements, which end with the first one within the limit. Other programs make a cost look
/// larger more often than smaller.
template <typename Measure>
double MinimumOf(int tries, double limit, const Measure& measure)
{
  double minimum = measure();
  for (int i = 1; i < tries && minimum > limit; ++i)
  {
    minimum = std::min(minimum, measure());
  }
  return minimum;
}
}
