// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Several grids of probes for one scene, as glsl/probes/field.glsl walks through them: the first is around all of it, each
 * later one is a part of it, and tells of a point before those that come earlier.
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
  /// At most Most, the finest last; not empty.
  explicit ProbeGrids(std::vector<ProbeGrid> list);

  int Count() const { return static_cast<int>(this->List.size()); }
  const ProbeGrid& Get(int number) const { return this->List[number]; }
  /// Probes in all. They lie in a row, grid by grid.
  int Size() const { return this->Begin(this->Count()); }
  /// Number of a grid's first probe.
  int Begin(int number) const;
  /// Number of the grid that a probe is of.
  int Of(int probe) const;
  /// The finest grid's ProbeGrid::Detail().
  double Detail() const;

private:
  std::vector<ProbeGrid> List;
};
}
