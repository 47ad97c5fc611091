// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace bench
{
struct CostPoint
{
  double Triangles;
  double Milliseconds;
};

/// Plot milliseconds over the logarithm of triangles to a PNG file. Throws std::runtime_error if it cannot be written.
void PlotCost(const std::vector<CostPoint>& points, const std::string& file);
}
