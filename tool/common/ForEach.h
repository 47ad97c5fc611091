// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A parallel loop with progress.
#pragma once

#include "common/Reporter.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace penumbra::tool
{
/// Calls body(i) for each i below count. advance is called in the calling thread only.
template <typename Body>
void ForEach(std::size_t count, const Body& body, const Progress& advance = {})
{
  constexpr std::size_t part = 64;
  std::atomic<std::size_t> next{ 0 };
  const auto run = [&](bool reports) {
    for (std::size_t first; (first = next.fetch_add(part)) < count;)
    {
      const std::size_t last = std::min(first + part, count);
      for (std::size_t i = first; i < last; ++i)
      {
        body(i);
      }
      if (reports && advance)
      {
        advance(double(last) / double(count));
      }
    }
  };
  std::vector<std::thread> others;
  for (unsigned int i = 1; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
  {
    others.emplace_back(run, false);
  }
  run(true);
  for (std::thread& other : others)
  {
    other.join();
  }
}
}
