// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The radiosity of a mesh: subdivision, form factors, direct light, solution.
#pragma once

#include "bake/radiosity/DirectLight.h"
#include "bake/radiosity/FormFactors.h"
#include "bake/radiosity/SmoothPoints.h"
#include "bake/radiosity/Solvers.h"

namespace penumbra::radiosity
{
enum class Solver
{
  Gathering, ///< Gauss-Seidel
  Shooting   ///< progressive refinement
};

struct Settings
{
  double PatchSize = 0.0; ///< maximum edge length, world units; 0: a share of the diagonal
  std::size_t MaximumPatches = 100000;
  int Rays = 256;          ///< rays per side of a patch
  int ShadowPoints = 16;   ///< points per side of a patch, for direct light
  int Refinements = 1;     ///< number of subdivisions where light changes steeply
  double Steepness = 0.15; ///< relative change of light above which a patch is subdivided
  bool Reciprocal = true;  ///< combine both estimates of an exchange
  double Tolerance = 1e-5; ///< final residual
  bool Both = false;       ///< use both solvers
  Solver Method = Solver::Gathering;
};

struct Illumination
{
  std::vector<Light> Lights;
  Sky Surroundings;
};

struct Solution
{
  std::vector<Element> Elements;
  std::vector<Color> Radiosity; ///< radiant exitance of each element
  std::vector<Color> Irradiance;
  std::vector<Color> Error; ///< standard error of the irradiance
  SmoothPoints Points;      ///< for smooth display
  Reflected Gathered;       ///< results of one or both solvers
  Reflected Shot;
  FactorMatrix Matrix;
  std::vector<float> Escaped;
  double PatchSize = 0.0;
  double FactorError = 0.0;    ///< greatest standard error of a form factor
  bool EmissionByRays = false; ///< emission is found by the rays of form factors
  bool RefinementCut = false;  ///< refinement would exceed the maximum number of patches
  bool SizeGrown = false;      ///< patches were enlarged, to limit their number
};

/// Solves for the light of a mesh. log: holds form factors of an interrupted run, and stores new ones. Throws a Failure if
/// there is nothing to light, no light, or more than the settings allow.
Solution Solve(PatchMesh mesh, const Illumination& light, const Settings& settings,
  tool::Reporter& reporter = tool::Reporter::None(), FactorLog* log = nullptr);

/// The root mean square of the irradiance's standard error, relative to the mean irradiance of lit elements, by area.
double RelativeError(const Solution& solution);

/// The greatest difference between the two solvers' radiosities, relative to the mean of lit elements. 0 unless both were
/// used.
double SolverDifference(const Solution& solution);
}
