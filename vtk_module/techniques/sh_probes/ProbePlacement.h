// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where baked probes stand, and what they see of the scene and of each other.
 */
#pragma once

#include "techniques/sh_probes/ProbeField.h"

#include <functional>

namespace penumbra
{
class GatherStage;

/// Among so many backs, of all that is met, a place may be within something solid.
constexpr double ManyBacks = 0.25;

/// Called with the part that is done; false ends the work.
using ProbeProgress = std::function<bool(double)>;

/// Move a grid's probes off surfaces that are close. Probes among the backs of surfaces are within something solid, where
/// no light is, or the surfaces are turned inside out: those stay. brightness: what arrives at points, roughly.
/// Returns false where it was ended.
bool PlaceProbes(GatherStage& stage, ProbeField& field, int number,
  const std::function<std::vector<double>(const std::vector<glm::dvec3>&)>& brightness,
  const ProbeProgress& progress);

/// Fill in Distance, Backs and Sight of a grid's probes. Returns false where it was ended.
bool LookAround(GatherStage& stage, ProbeField& field, int number, const ProbeProgress& progress);
}
