// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Probes where light needs them: placed, tried and judged on the scene's surfaces.
 */
#pragma once

#include "techniques/sh_probes/LightTrial.h"
#include "techniques/sh_probes/ProbePlacement.h"

#include <optional>

namespace penumbra
{
class GatherStage;

/// Several grids that were tried in place of one.
struct TriedGrids
{
  int Count = 0;      ///< 0 where none were
  double Error = 0.0; ///< what they left of one grid's squared error, roughly
};

/// Puts fields of probes without light into a stage's scene. Results are empty where the work was ended.
struct AdaptivePlacement
{
  GatherStage& Stage;
  LightTrial::Gather Gather;
  ProbeProgress Progress; ///< of all the work
  bool Relocate;          ///< see PlaceProbes()

  std::optional<ProbeField> Place(const ProbeGrids& grids) const;

  /// In one grid around bounds, and in several that share as many probes: the one whose light errs less.
  std::optional<ProbeField> PlaceBest(
    const std::array<double, 6>& bounds, int probes, TriedGrids& tried) const;
};
}
