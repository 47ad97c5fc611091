// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "probes/ProbeGrids.h"

#include <algorithm>

namespace penumbra
{
ProbeGrids::ProbeGrids(std::vector<ProbeGrid> list)
  : List(std::move(list))
{
}

int ProbeGrids::Begin(int number) const
{
  int begin = 0;
  for (int i = 0; i < number; ++i)
  {
    begin += this->List[i].Size();
  }
  return begin;
}

int ProbeGrids::Of(int probe) const
{
  int number = 0;
  while (number + 1 < this->Count() && probe >= this->Begin(number + 1))
  {
    ++number;
  }
  return number;
}

double ProbeGrids::Detail() const
{
  double detail = this->List.front().Detail();
  for (const ProbeGrid& grid : this->List)
  {
    detail = std::min(detail, grid.Detail());
  }
  return detail;
}
}
