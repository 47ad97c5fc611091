// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A chart of a frame's cost as SVG text.
#pragma once

#include "instrument/FrameChartLayout.h"

namespace penumbra
{
/// The shapes as an SVG document. Its text stays text, and bars tell their pass as a tool tip. It needs no window, and is a
/// fraction of the size of what vtkSVGExporter writes.
std::string FrameChartSvg(const std::vector<ChartShape>& shapes, int width, int height);
}
