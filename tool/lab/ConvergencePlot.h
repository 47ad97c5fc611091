// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// How a solver's residual falls with its work.
#ifndef penumbra_tool_ConvergencePlot_h
#define penumbra_tool_ConvergencePlot_h

#include "image/Picture.h"

#include <array>
#include <string>
#include <vector>

namespace penumbra::tool
{
struct ConvergenceCurve
{
  std::string Name;
  std::vector<std::array<double, 2>> Steps; ///< work and residual
};

/// A chart with the residual's decades, drawn in a window of the backend. Throws a Failure where there
/// is none.
Picture DrawConvergence(const std::vector<ConvergenceCurve>& curves, const std::string& workTitle,
  const std::string& backend);
}

#endif
