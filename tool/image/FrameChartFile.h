// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Files with a chart of a frame's cost.
#pragma once

#include <string>

namespace penumbra::tool
{
/// Throws a Failure if the chart's name does not end with .svg or .png, or its folder does not exist.
void RequireChartName(const std::string& path);

/// Writes the chart of vtkGIPass::GetStatistics() as .svg or .png, depending on the path, in pixels. Throws a Failure if
/// that is impossible. backend: of the window that draws a .png.
void WriteFrameChart(
  const std::string& path, const char* json, int width, int height, const std::string& backend);
}
