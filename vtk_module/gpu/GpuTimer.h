// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * GPU time per pass, by timer queries that are read after the frame. Software OpenGL is timed by the clock, pass by pass.
 */
#pragma once

#include "gpu/GLObjects.h"

#include <chrono>
#include <string>
#include <vector>

namespace penumbra
{
class GpuTimer
{
public:
  GpuTimer();

  void Begin(const std::string& name);
  void End();

  struct Span
  {
    std::string Name;
    double Milliseconds;
  };
  /// Wait for the GPU and read this frame's spans, in order.
  std::vector<Span> Collect();

private:
  bool UsesClock;
  std::chrono::steady_clock::time_point Start;
  std::vector<Span> Measured; ///< by the clock
  std::vector<std::string> Names;
  std::vector<QueryHandle> Queries;
};
}
