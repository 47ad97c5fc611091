// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * GPU time per pass, by timer queries that are read after the frame.
 */
#pragma once

#include "gpu/GLObjects.h"

#include <string>
#include <vector>

namespace penumbra
{
class GpuTimer
{
public:
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
  std::vector<std::string> Names;
  std::vector<QueryHandle> Queries;
};
}
