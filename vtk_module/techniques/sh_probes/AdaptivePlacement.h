// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Places probes where light needs them, by measuring the error of candidate grids on the scene's surfaces.
 */
#pragma once

#include "techniques/sh_probes/LightTrial.h"
#include "techniques/sh_probes/ProbePlacement.h"

#include <optional>

namespace penumbra
{
class GatherStage;

/// Result of trying several grids in place of a single one.
struct TriedGrids
{
  int Count = 0;      ///< 0 if none were tried
  double Error = 0.0; ///< their squared error, as a rough fraction of a single grid's
};

/// Places probes, without light yet, in a stage's scene. Results are empty if the work was aborted.
struct AdaptivePlacement
{
  GatherStage& Stage;
  LightTrial::Gather Gather;
  ProbeProgress Progress; ///< progress of the whole work
  bool Relocate;          ///< see PlaceProbes()

  std::optional<ProbeField> Place(const ProbeGrids& grids) const;

  /// Place probes in a single grid around bounds or in several that share as many probes, whichever has the smaller
  /// error.
  std::optional<ProbeField> PlaceBest(
    const std::array<double, 6>& bounds, int probes, TriedGrids& tried) const;
};
}
