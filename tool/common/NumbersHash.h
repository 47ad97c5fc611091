// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Hash tables with arrays of numbers as keys, such as the coordinates of a vertex.
#pragma once

#include "base/Hasher.h"

#include <array>
#include <unordered_map>

namespace penumbra::tool
{
struct NumbersHash
{
  template <std::size_t N>
  std::size_t operator()(const std::array<double, N>& numbers) const
  {
    Hasher hasher;
    for (const double number : numbers)
    {
      hasher.AddValue(number + 0.0); // -0 and 0 are equal
    }
    return hasher.Get();
  }
};

template <std::size_t N, typename Value>
using NumbersMap = std::unordered_map<std::array<double, N>, Value, NumbersHash>;
}
