// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A parallel loop for passes over millions of elements. It uses plain threads, as vtkSMPTools is
 * sequential in the distributions' builds of VTK.
 */
#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace penumbra
{
/// Call body(begin, end) on parts of [0, count), in several threads if that pays off. grain: number of elements that are
/// worth a thread; starting one costs as much as some ten thousand simple steps.
template <typename Body>
void ParallelFor(std::size_t count, const Body& body, std::size_t grain = 65536)
{
  // Asking the system for the number of processors takes longer than a loop of a small count.
  static const std::size_t processors = std::max(1u, std::thread::hardware_concurrency());
  const std::size_t threads = std::min(processors, (count + grain - 1) / grain);
  if (threads <= 1)
  {
    body(std::size_t(0), count);
    return;
  }
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < threads; ++i)
  {
    others.emplace_back(
      [&body, count, threads, i] { body(count * i / threads, count * (i + 1) / threads); });
  }
  body(std::size_t(0), count / threads);
  for (std::thread& other : others)
  {
    other.join();
  }
}
}
