// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Statistics of a view's last frames, for vtkGIPass::GetStatistics().
 */
#pragma once

#include "gpu/GpuTimer.h"

#include "vtkSmartPointer.h"

#include <nlohmann/json_fwd.hpp>

#include <deque>
#include <map>
#include <string>
#include <vector>

class vtkGITechnique;

namespace penumbra
{
class FrameStatistics
{
public:
  using Techniques = std::vector<vtkSmartPointer<vtkGITechnique>>;

  int Textures = 0; ///< in the pool
  std::size_t Bytes = 0;
  std::size_t Lights = 0;
  int Frames = 0; ///< that the picture is the mean of

  /// Add the times of a frame. techniques: for their approaches.
  void Add(TimedFrame frame, const Techniques& techniques);

  /// As JSON. budget: FrameBudget::Describe(), or null.
  std::string ToText(const Techniques& techniques, nlohmann::ordered_json budget) const;

private:
  /// Milliseconds by approach, and of the whole frame under "frame".
  using Sums = std::map<std::string, double>;

  TimedFrame Last;
  std::deque<Sums> History; ///< of the last frames, the oldest first
};
}
