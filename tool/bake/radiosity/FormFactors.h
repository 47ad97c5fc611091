// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// How much of what leaves an element meets each other: form factors by ray casting.
#pragma once

#include "bake/radiosity/FactorLog.h"
#include "bake/radiosity/Patches.h"
#include "common/ForEach.h"

namespace penumbra::radiosity
{
/// A sparse matrix by rows: F_ij is the share of what leaves i that arrives at j.
struct FactorMatrix
{
  using Entry = TracedRows::Entry;
  std::vector<std::size_t> Begin = { 0 }; ///< of each row, and the end
  std::vector<Entry> Entries;
  int Rays = 0; ///< traced for each row

  std::size_t Size() const { return this->Begin.size() - 1; }
  double RowSum(std::size_t row) const;
  double At(std::size_t row, std::size_t column) const;
  template <typename Visit>
  void ForEachIn(std::size_t row, const Visit& visit) const ///< visit(column, value)
  {
    for (std::size_t i = this->Begin[row]; i < this->Begin[row + 1]; ++i)
    {
      visit(this->Entries[i].Column, static_cast<double>(this->Entries[i].Value));
    }
  }
};

/// Radiance that arrives from far away, by direction.
using Sky = std::function<Color(const Point&)>;

struct Factors
{
  FactorMatrix Matrix;
  std::vector<float> Escaped;       ///< of each row, the share that meets nothing
  std::vector<Color> SkyIrradiance; ///< of each element
};

/// Traces so many rays (rounded up to a square number) from every element: cosine-weighted
/// directions, one in each cell of a grid, from points that are one in each cell of another. The share
/// of the rays of i that meet j estimates F_ij with a standard error of at most sqrt(F (1 - F) / rays)
/// (Malley 1988, A Shading Method for Computer Generated Images). log: takes what it holds of them, and keeps the others.
Factors TraceFactors(const std::vector<Element>& elements, const PatchRays& rays, int count,
  const Sky& sky = {}, const tool::Progress& advance = {}, FactorLog* log = nullptr);

/// Makes A_i F_ij = A_j F_ji: of both estimates the mean, weighted by the rays per area that made them,
/// which is by the inverse of their variances. Rows are brought back to 1 less what escapes by scaling
/// rows and columns alike (Sinkhorn and Knopp 1967, Concerning Nonnegative Matrices and Doubly Stochastic
/// Matrices).
void MakeReciprocal(
  FactorMatrix& matrix, const std::vector<Element>& elements, const std::vector<float>& escaped);

FactorMatrix Transpose(const FactorMatrix& matrix);

/// Of the irradiance that each element gathers from these radiosities, what chance makes of it: the
/// standard error of the mean over the rays of the row, which strata make smaller yet.
std::vector<Color> GatherError(const FactorMatrix& matrix, const std::vector<Color>& radiosity);
}
