// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The radiosity of a mesh: patches, form factors, direct light, solution.
#pragma once

#include "bake/radiosity/DirectLight.h"
#include "bake/radiosity/FormFactors.h"
#include "bake/radiosity/SmoothPoints.h"
#include "bake/radiosity/Solvers.h"

#include <string>

namespace penumbra::radiosity
{
enum class Solver
{
  Gathering, ///< Gauss-Seidel
  Shooting   ///< progressive refinement
};

struct Settings
{
  double PatchSize = 0.0; ///< longest edge, world units; 0: a share of the diagonal
  std::size_t MaximumPatches = 100000;
  int Rays = 256;          ///< from each side of a patch
  int ShadowPoints = 16;   ///< of each side of a patch, for direct light
  int Refinements = 1;     ///< times that patches are cut where light changes steeply
  double Steepness = 0.15; ///< a patch is cut if light changes by more, of the mean
  bool Reciprocal = true;  ///< both estimates of an exchange are combined
  double Tolerance = 1e-5; ///< of the residual
  bool Both = false;       ///< solve the other way too
  Solver Method = Solver::Gathering;
};

struct Illumination
{
  std::vector<Lamp> Lamps;
  Sky Surroundings;
};

struct Solution
{
  std::vector<Element> Elements;
  std::vector<Color> Radiosity; ///< radiant exitance of each element
  std::vector<Color> Irradiance;
  std::vector<Color> Error; ///< standard error of the irradiance by chance
  SmoothPoints Points;      ///< for a view without steps between patches
  Reflected Gathered;       ///< the chosen solver's, or both
  Reflected Shot;
  FactorMatrix Matrix;
  std::vector<float> Escaped;
  double PatchSize = 0.0;
  double FactorError = 0.0;    ///< greatest standard error of a form factor by chance
  bool EmissionByRays = false; ///< not aimed at, as much of the scene shines
  bool RefinementCut = false;  ///< steep places stay coarse, as patches would be too many
  bool SizeGrown = false;      ///< patches are larger than asked for, to be few enough
};

/// Tells what is being done, how far.
struct Watch
{
  std::function<void(const std::string&)> Begin = [](const std::string&) {};
  tool::Progress Advance = [](double) {};
};

/// log: form factors that are traced already are taken from it, others are kept in it. Throws std::runtime_error, with a
/// sentence, where there is nothing to light, no light, or more than is allowed.
Solution Solve(PatchMesh mesh, const Illumination& light, const Settings& settings,
  const Watch& watch = {}, FactorLog* log = nullptr);

/// By how much chance moves the irradiance: the root mean square of its standard error, over the mean of
/// what is lit, by area.
double RelativeError(const Solution& solution);

/// How far the two solvers' radiosities are apart: the greatest difference, over the mean of what is
/// lit. 0 unless both solved.
double SolverDifference(const Solution& solution);

/// The size of patches unless given: a share of the diagonal.
double DefaultPatchSize(const PatchMesh& mesh);
}
