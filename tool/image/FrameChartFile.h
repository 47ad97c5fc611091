// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Files with a chart of a frame's cost.
#pragma once

#include <string>

namespace penumbra::tool
{
/// Throws a Failure if the chart's name does not end with .svg or .png, or its folder does not exist.
void RequireChartName(const std::string& path);

/// Writes the chart of vtkGIPass::GetStatistics() as .svg or .png, depending on the path. Returns false with a sentence in
/// error if that is impossible. Only .png needs an OpenGL context.
bool WriteFrameChart(
  const std::string& path, const char* json, int width, int height, std::string& error);
}
