// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Time of each pass of a frame, on the isosurface of FrameScenes.h.
 */
#pragma once

#include <string>
#include <vector>

class vtkPolyData;

namespace bench
{
struct PassCostOptions
{
  std::string Preset = "high";
  std::vector<std::string> Techniques; ///< to be switched on, or with a leading minus off
  bool Still = false;                  ///< the camera stands instead of turning
};

/// Print the median milliseconds of each pass, of all passes, and of the frame by the clock. Throws std::runtime_error
/// if there is no such preset or technique.
void ReportPassCost(
  const PassCostOptions& options, vtkPolyData& surface, int width, int height, int frames);
}
