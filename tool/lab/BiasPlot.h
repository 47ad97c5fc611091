// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A chart for each kind of bias: acne and gap over the bias, the safe window between them.
#ifndef penumbra_tool_BiasPlot_h
#define penumbra_tool_BiasPlot_h

#include "lab/BiasStudy.h"

#include <string>

namespace penumbra::tool
{
/// Draws the charts side by side, by VTK's charts in a window of the backend, writes them as SVG to the
/// file (no file for "") and returns them as a picture. Throws a Failure where either cannot be done.
Picture DrawBiasPlot(
  const BiasStudy& study, const std::string& backend, const std::string& svgFile);
}

#endif
