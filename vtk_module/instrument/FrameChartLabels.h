// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Labels next to points, where they hide the least.
#pragma once

#include "instrument/FrameChartSheet.h"

namespace penumbra
{
/// A knob's level in force.
struct ChartPoint
{
  std::string Name;
  std::string Level;
  Approach Payment = Approach::Rest;
  double X = 0.0;
  double Y = 0.0;
};

/// Labels points of a radius. Labels avoid texts and reserved boxes, and lines as far as possible; lines are boxes from one
/// end to the other. An earlier label may take the only place of a later one. So several orders are tried, and the best
/// remains. A label without room is left out.
void LabelInBestOrder(ChartSheet& sheet, std::vector<ChartPoint> points, double radius,
  const ChartBox& plot, const std::vector<ChartBox>& lines);
}
