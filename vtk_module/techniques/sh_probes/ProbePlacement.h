// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Places baked probes, and finds what they see of the scene and of each other.
 */
#pragma once

#include "techniques/sh_probes/ProbeField.h"

#include <functional>

namespace penumbra
{
class GatherStage;

/// Backface ratio above which a position may be inside a solid object.
constexpr double SolidBackfaceRatio = 0.25;

/// Called with the fraction of the work that is done. Returns false to abort.
using ProbeProgress = std::function<bool(double)>;

/// Move a grid's probes away from close surfaces. Probes that see many backfaces are inside a solid object, where it is
/// dark, and leave it; or the surfaces have inverted windings, and the probes stay. brightness: estimates the light at
/// points. Returns false if aborted.
bool PlaceProbes(GatherStage& stage, ProbeField& field, int number,
  const std::function<std::vector<double>(const std::vector<glm::dvec3>&)>& brightness,
  const ProbeProgress& progress);

/// Compute Distance, Backs and Sight of a grid's probes. Returns false if aborted.
bool TraceVisibility(
  GatherStage& stage, ProbeField& field, int number, const ProbeProgress& progress);
}
