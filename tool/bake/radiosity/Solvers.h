// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The radiosity equation B = E + rho (D + F (B - E)) for diffuse surfaces, solved two ways.
#pragma once

#include "bake/radiosity/FormFactors.h"

namespace penumbra::radiosity
{
/// What is known of every element. The unknown is R, what it reflects.
struct LightBalance
{
  const std::vector<Element>& Elements;
  const FactorMatrix& Factors;
  /// Irradiance before any reflection: of lights, of the sky, of what shines.
  const std::vector<Color>& Arriving;
};

struct SolverStep
{
  double Work = 0.0;     ///< exchanges between two elements so far, in matrices' worth
  double Residual = 0.0; ///< power that is not yet accounted for, over the power first reflected
};

struct Reflected
{
  std::vector<Color> Light; ///< R: radiant exitance that each element reflects
  std::vector<SolverStep> History;
  bool Converged = false;
};

struct SolverLimits
{
  double Tolerance = 1e-4; ///< of the residual
  int Sweeps = 1000;
};

/// Each element in turn takes in what the others reflect now; the residual is what a sweep would still
/// change: the Gauss-Seidel method (Cohen and Greenberg 1985, The Hemi-Cube).
Reflected GatherLight(
  const LightBalance& balance, const SolverLimits& limits, const tool::Progress& advance = {});

/// The element with the most unshot power sends it to all others: progressive refinement (Cohen, Chen,
/// Wallace and Greenberg 1988, A Progressive Refinement Approach to Fast Radiosity Image Generation). To
/// find it costs a look at all; so those with at least half of the greatest power shoot before the next
/// look. A history's step is a look.
Reflected ShootLight(
  const LightBalance& balance, const SolverLimits& limits, const tool::Progress& advance = {});

/// The irradiance of every element, with what arrives from the reflections.
std::vector<Color> TotalIrradiance(
  const LightBalance& balance, const std::vector<Color>& reflected);

/// The greatest reflectance; from 1 on light would be made.
double GreatestReflectance(const std::vector<Element>& elements);
}
