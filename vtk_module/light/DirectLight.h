// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Direct light of all lights of the renderer, computed once per pixel from the G-buffer, plus ambient light,
 * environment light and emission. Reproduces the formulas of VTK's shaders, so that the picture is VTK's if every
 * technique is off.
 */
#pragma once

#include "graph/Frame.h"
#include "rays/SurfaceRules.h"

#include <optional>

namespace penumbra
{
class LightTable;
class MaterialTable;

struct DirectLightOptions
{
  bool Extended = false;        ///< the capture wrote the extended set of targets
  bool Radiance = false;        ///< also write resource::Radiance
  bool LitRadiance = false;     ///< also write resource::LitRadiance
  bool LitParts = false;        ///< also write resource::LitShown and LitEncoded
  bool AmbientLight = true;     ///< there is light for ambient occlusion to darken
  double SpreadShare = 0.0;     ///< see LightingPlan::SpreadLight()
  double Interreflection = 0.0; ///< see LightingPlan::SetInterreflection()
  SurfaceRules Rules{};
  std::optional<Arguments> Display{}; ///< see FrameBuilder::DisplayDirectLight()
};

/// Add the pass that makes the picture from the G-buffer: it writes the colour, and the radiance if it is kept.
void ContributeDirectLight(
  Frame& frame, LightTable& lights, MaterialTable& materials, const DirectLightOptions& options);

/// Add the pass that writes resource::Backdrop.
void ContributeBackdrop(Frame& frame);

/// Add the pass that copies the finished picture to a window that is not drawn to directly.
void ContributePresentation(Frame& frame, MaterialTable& materials);
}
