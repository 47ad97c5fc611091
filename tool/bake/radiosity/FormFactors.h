// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Form factors between elements, by ray casting.
#pragma once

#include "bake/radiosity/FactorLog.h"
#include "bake/radiosity/Patches.h"
#include "common/ForEach.h"

namespace penumbra::radiosity
{
/// A sparse matrix in rows. F_ij is the share of the light from i that arrives at j.
struct FactorMatrix
{
  using Entry = TracedRows::Entry;
  std::vector<std::size_t> Begin = { 0 }; ///< first entry of each row, and the end
  std::vector<Entry> Entries;
  int Rays = 0; ///< rays per row

  std::size_t Size() const { return this->Begin.size() - 1; }
  void AddRow(const std::vector<Entry>& row);
  double RowSum(std::size_t row) const;
  template <typename Visit>
  void ForEachIn(std::size_t row, const Visit& visit) const ///< visit(column, value)
  {
    for (std::size_t i = this->Begin[row]; i < this->Begin[row + 1]; ++i)
    {
      visit(this->Entries[i].Column, static_cast<double>(this->Entries[i].Value));
    }
  }
};

/// Radiance of the environment by direction.
using Sky = std::function<Color(const Point&)>;

struct Factors
{
  FactorMatrix Matrix;
  std::vector<float> Escaped;       ///< share of each row that hits nothing
  std::vector<Color> SkyIrradiance; ///< irradiance of each element
};

/// Traces a number of rays (rounded up to a square number) from each element, with stratified points and stratified
/// cosine-weighted directions. The share of rays from i that hit j estimates F_ij with a standard error of at most
/// sqrt(F (1 - F) / rays) (Malley 1988, A Shading Method for Computer Generated Images). log: holds rows of an interrupted
/// run, and stores new ones.
Factors TraceFactors(const std::vector<Element>& elements, const PatchRays& rays, int count,
  const Sky& sky = {}, const tool::Progress& advance = {}, FactorLog* log = nullptr);

/// Makes A_i F_ij = A_j F_ji, by averaging both estimates with weights of rays per area, which are the inverse of their
/// variances. Then rows and columns are scaled equally until the sum of each row is 1 minus the escaped share (Sinkhorn and
/// Knopp 1967, Concerning Nonnegative Matrices and Doubly Stochastic Matrices).
void MakeReciprocal(
  FactorMatrix& matrix, const std::vector<Element>& elements, const std::vector<float>& escaped);

FactorMatrix Transpose(const FactorMatrix& matrix);

/// The standard error of the irradiance that each element gathers, as the mean over the rays of its row. Stratification makes
/// the actual error smaller.
std::vector<Color> GatherError(const FactorMatrix& matrix, const std::vector<Color>& radiosity);
}
