// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Light that reaches a surface straight from a lamp, resolved once per pixel from the G-buffer for
 * every light of the renderer, with the surroundings' light and emission added. Reproduces the
 * formulas of VTK's own shaders, so that the picture with every technique off is VTK's.
 */
#pragma once

#include "graph/Frame.h"

namespace penumbra
{
class LightTable;
class MaterialTable;

struct DirectLightOptions
{
  bool Extended = false;      ///< the capture wrote the extended set of targets
  bool Radiance = false;      ///< write resource::Radiance, too
  bool LitRadiance = false;   ///< write resource::LitRadiance, too
  double SpreadShare = 0.0;   ///< see LightingPlan::SpreadLight()
  double Interreflection = 0.0; ///< see LightingPlan::SetInterreflection()
};

/// Add the passes that make the picture from the G-buffer: "direct-light" writes the colour (and
/// the radiance, if kept), "present" brings it to a window that could not be drawn to directly.
void ContributeDirectLight(
  Frame& frame, LightTable& lights, MaterialTable& materials, const DirectLightOptions& options);
}
