// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Several grids of probes for one scene, in the order of glsl/probes/field.glsl. The first surrounds the whole scene.
 * Each later one covers a part of it, and takes precedence over earlier ones there.
 */
#pragma once

#include "probes/ProbeGrid.h"

#include "probe_field.h"

#include <vector>

namespace penumbra
{
class ProbeGrids
{
public:
  static constexpr int Most = GI_FIELD_GRIDS;

  ProbeGrids(const ProbeGrid& first = ProbeGrid())
    : List{ first }
  {
  }
  /// list: at least one grid and at most Most, finest last.
  explicit ProbeGrids(std::vector<ProbeGrid> list);

  int Count() const { return static_cast<int>(this->List.size()); }
  const ProbeGrid& Get(int number) const { return this->List[number]; }
  /// Total number of probes. They are numbered grid by grid.
  int Size() const { return this->Begin(this->Count()); }
  /// Number of a grid's first probe.
  int Begin(int number) const;
  /// Number of the grid that a probe belongs to.
  int Of(int probe) const;
  /// ProbeGrid::Detail() of the finest grid.
  double Detail() const;

private:
  std::vector<ProbeGrid> List;
};
}
