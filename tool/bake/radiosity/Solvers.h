// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Two solvers of the radiosity equation B = E + rho (D + F (B - E)) for diffuse surfaces.
#pragma once

#include "bake/radiosity/FormFactors.h"

namespace penumbra::radiosity
{
/// Known values of the elements. The unknown is R, the reflected light.
struct LightBalance
{
  const std::vector<Element>& Elements;
  const FactorMatrix& Factors;
  /// Irradiance before any reflection: from lights, the environment and emissive surfaces.
  const std::vector<Color>& Arriving;
};

struct SolverStep
{
  double Work = 0.0;     ///< exchanges between elements so far, relative to the size of the matrix
  double Residual = 0.0; ///< remaining power, relative to the power first reflected
};

struct Reflected
{
  std::vector<Color> Light; ///< R: radiant exitance that each element reflects
  std::vector<SolverStep> History;
  bool Converged = false;
};

/// The Gauss-Seidel method: each element in turn gathers the light of the others (Cohen and Greenberg 1985, The Hemi-Cube).
/// The residual is the change of a sweep. tolerance: final residual.
Reflected GatherLight(
  const LightBalance& balance, double tolerance, const tool::Progress& advance = {});

/// Progressive refinement: the element with the greatest unshot power distributes it to all others (Cohen, Chen, Wallace and
/// Greenberg 1988, A Progressive Refinement Approach to Fast Radiosity Image Generation). Because a search is costly, each
/// one, a step of the history, is followed by all elements with at least half of the greatest power.
Reflected ShootLight(
  const LightBalance& balance, double tolerance, const tool::Progress& advance = {});

/// The total irradiance of each element, with reflected light.
std::vector<Color> TotalIrradiance(
  const LightBalance& balance, const std::vector<Color>& reflected);

/// The greatest reflectance. From 1 on, light would increase without limit.
double GreatestReflectance(const std::vector<Element>& elements);
}
