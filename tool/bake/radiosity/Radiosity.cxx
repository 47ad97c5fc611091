// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/Radiosity.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace penumbra::radiosity
{
namespace
{
/// Whether the rays of the form factors find what shines well enough: where a quarter of them do, and where to aim at each piece of it takes too long.
bool EmissionIsBroad(const std::vector<Element>& elements, const FactorMatrix& factors,
  std::size_t emitters, const Settings& settings)
{
  constexpr double mostShadowRays = 5e8;
  constexpr double broad = 0.25;
  double shining = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    all += elements[i].Area;
    factors.ForEachIn(i, [&](std::size_t j, double share) {
      shining += elements[j].Emission != Color(0.0) ? share * elements[i].Area : 0.0;
    });
  }
  return shining > broad * all ||
    double(elements.size()) * double(emitters) * settings.ShadowPoints > mostShadowRays;
}

void RequireLight(const std::vector<Element>& elements, const Illumination& light)
{
  const bool shines = std::any_of(elements.begin(), elements.end(),
    [](const Element& element) { return element.Emission != Color(0.0); });
  const bool lamps = std::any_of(light.Lamps.begin(), light.Lamps.end(),
    [](const Lamp& lamp) { return lamp.Strength != Color(0.0); });
  if (!shines && !lamps && !light.Surroundings)
  {
    throw std::runtime_error("nothing shines in the scene: add a light, an environment, or a "
                             "material with an emission");
  }
  if (GreatestReflectance(elements) >= 1.0)
  {
    throw std::runtime_error("a surface reflects all light or more, so that light between such "
                             "surfaces would never end: give colours below 1");
  }
}

void Subdivide(PatchMesh& mesh, const Settings& settings, Solution& solution)
{
  if (mesh.Faces().size() > settings.MaximumPatches)
  {
    throw std::runtime_error("the scene has " + std::to_string(mesh.Faces().size()) +
      " triangles, more than the " + std::to_string(settings.MaximumPatches) +
      " patches that are allowed (--max-patches): simplify it, or allow more");
  }
  const bool chosen = settings.PatchSize > 0.0;
  double size = chosen ? settings.PatchSize : DefaultPatchSize(mesh);
  PatchMesh cut = mesh;
  for (cut.LimitAll(size); !cut.Refine(settings.MaximumPatches); cut.LimitAll(size))
  {
    if (chosen)
    {
      throw std::runtime_error("patches of that size would be more than the " +
        std::to_string(settings.MaximumPatches) +
        " that are allowed (--max-patches): give a larger --patch-size, or allow more");
    }
    constexpr double larger = 1.25;
    size *= larger;
    solution.SizeGrown = true;
    cut = mesh;
  }
  mesh = cut;
  solution.PatchSize = size;
}

/// All that arrives before any reflection.
std::vector<Color> Arriving(const PatchMesh& mesh, const Illumination& light,
  const Settings& settings, const PatchRays& rays, const Factors& factors, LightSources& sources,
  Solution& solution, const Watch& watch)
{
  sources = { light.Lamps, MakeEmitters(mesh) };
  solution.EmissionByRays =
    EmissionIsBroad(solution.Elements, factors.Matrix, sources.Emitters.size(), settings);
  if (solution.EmissionByRays)
  {
    sources.Emitters.clear();
  }
  watch.Begin("lighting patches");
  std::vector<Color> arriving =
    DirectIrradiance(solution.Elements, rays, sources, settings.ShadowPoints, watch.Advance);
  for (std::size_t i = 0; i < arriving.size(); ++i)
  {
    arriving[i] += factors.SkyIrradiance[i];
    if (solution.EmissionByRays)
    {
      factors.Matrix.ForEachIn(i,
        [&](std::size_t j, double share) { arriving[i] += share * solution.Elements[j].Emission; });
    }
  }
  return arriving;
}

/// What the points between patches get: direct light as it is there, the rest as the mean around.
void LightPoints(const PatchMesh& mesh, const PatchRays& rays, const LightSources& sources,
  const std::vector<Color>& direct, const Settings& settings, Solution& solution,
  const Watch& watch)
{
  solution.Points = MakeSmoothPoints(mesh, solution.Elements);
  std::vector<Color> rest = solution.Irradiance;
  for (std::size_t i = 0; i < rest.size(); ++i)
  {
    rest[i] -= direct[i];
  }
  solution.Points.Irradiance = MeanAround(solution.Points, solution.Elements, rest);
  watch.Begin("lighting corners of patches");
  const std::vector<Color> light = DirectAround(
    solution.Points, solution.Elements, rays, sources, settings.ShadowPoints, watch.Advance);
  for (std::size_t i = 0; i < light.size(); ++i)
  {
    solution.Points.Irradiance[i] += light[i];
  }
}

void SolveOnce(const PatchMesh& mesh, const Illumination& light, const Settings& settings,
  Solution& solution, const Watch& watch, FactorLog* log)
{
  solution.Elements = MakeElements(mesh);
  const PatchRays rays(solution.Elements);
  watch.Begin("tracing form factors");
  Factors factors =
    TraceFactors(solution.Elements, rays, settings.Rays, light.Surroundings, watch.Advance, log);
  LightSources sources;
  const std::vector<Color> arriving =
    Arriving(mesh, light, settings, rays, factors, sources, solution, watch);
  // What the rays of the form factors found is no direct light of points.
  std::vector<Color> direct = arriving;
  for (std::size_t i = 0; i < direct.size(); ++i)
  {
    direct[i] -= factors.SkyIrradiance[i];
    if (solution.EmissionByRays)
    {
      factors.Matrix.ForEachIn(i,
        [&](std::size_t j, double share) { direct[i] -= share * solution.Elements[j].Emission; });
    }
  }
  watch.Begin("solving");
  if (settings.Reciprocal)
  {
    MakeReciprocal(factors.Matrix, solution.Elements, factors.Escaped);
  }
  const LightBalance balance = { solution.Elements, factors.Matrix, arriving };
  const SolverLimits limits = { settings.Tolerance };
  if (settings.Method == Solver::Gathering || settings.Both)
  {
    solution.Gathered = GatherLight(balance, limits, watch.Advance);
  }
  if (settings.Method == Solver::Shooting || settings.Both)
  {
    solution.Shot = ShootLight(balance, limits, watch.Advance);
  }
  const Reflected& chosen =
    settings.Method == Solver::Gathering ? solution.Gathered : solution.Shot;
  solution.Irradiance = TotalIrradiance(balance, chosen.Light);
  solution.Radiosity.resize(solution.Elements.size());
  for (std::size_t i = 0; i < solution.Elements.size(); ++i)
  {
    solution.Radiosity[i] = solution.Elements[i].Emission + chosen.Light[i];
  }
  solution.Error =
    GatherError(factors.Matrix, solution.EmissionByRays ? solution.Radiosity : chosen.Light);
  LightPoints(mesh, rays, sources, direct, settings, solution, watch);
  for (const auto& entry : factors.Matrix.Entries)
  {
    const double share = std::min(1.0, double(entry.Value));
    solution.FactorError =
      std::max(solution.FactorError, std::sqrt(share * (1.0 - share) / factors.Matrix.Rays));
  }
  solution.Matrix = std::move(factors.Matrix);
  solution.Escaped = std::move(factors.Escaped);
}

/// Faces whose corners differ by more than the steepness, of the scene's mean or of their own where
/// that is greater, by Weber's law.
std::vector<char> FindSteep(const Solution& solution, double steepness)
{
  const auto brightness = [](const Color& c) { return c.x + c.y + c.z; };
  double mean = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < solution.Elements.size(); ++i)
  {
    const double light = brightness(solution.Irradiance[i]);
    mean += light * solution.Elements[i].Area;
    area += light > 0.0 ? solution.Elements[i].Area : 0.0;
  }
  mean /= std::max(area, 1e-300);
  std::vector<char> steep(solution.Elements.size() / 2, 0);
  for (std::size_t i = 0; i < solution.Elements.size(); ++i)
  {
    const auto& corners = solution.Points.OfElement[i];
    double low = brightness(solution.Points.Irradiance[corners[0]]);
    double high = low;
    for (const std::uint32_t corner : corners)
    {
      low = std::min(low, brightness(solution.Points.Irradiance[corner]));
      high = std::max(high, brightness(solution.Points.Irradiance[corner]));
    }
    const bool matters = solution.Elements[i].Reflectance != Color(0.0);
    if (matters && high - low > steepness * std::max(mean, 0.5 * (low + high)))
    {
      steep[i / 2] = 1;
    }
  }
  return steep;
}
}

namespace
{
/// Over the elements that light reaches, by area.
template <typename Value>
double MeanOverLit(const Solution& solution, const Value& value)
{
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < solution.Elements.size(); ++i)
  {
    if (solution.Irradiance[i] != Color(0.0))
    {
      sum += solution.Elements[i].Area * value(i);
      area += solution.Elements[i].Area;
    }
  }
  return area > 0.0 ? sum / area : 0.0;
}

double Sum(const Color& c)
{
  return c.x + c.y + c.z;
}
}

double RelativeError(const Solution& solution)
{
  const double square = MeanOverLit(
    solution, [&](std::size_t i) { return glm::dot(solution.Error[i], solution.Error[i]); });
  const double mean =
    MeanOverLit(solution, [&](std::size_t i) { return Sum(solution.Irradiance[i]); });
  return mean > 0.0 ? std::sqrt(3.0 * square) / mean : 0.0;
}

double SolverDifference(const Solution& solution)
{
  if (solution.Gathered.Light.empty() || solution.Shot.Light.empty())
  {
    return 0.0;
  }
  double most = 0.0;
  for (std::size_t i = 0; i < solution.Elements.size(); ++i)
  {
    const Color apart = glm::abs(solution.Gathered.Light[i] - solution.Shot.Light[i]);
    most = std::max({ most, apart.x, apart.y, apart.z });
  }
  const double mean =
    MeanOverLit(solution, [&](std::size_t i) { return Sum(solution.Radiosity[i]) / 3.0; });
  return mean > 0.0 ? most / mean : 0.0;
}

double DefaultPatchSize(const PatchMesh& mesh)
{
  constexpr double share = 0.025;
  return share * mesh.Diagonal();
}

Solution Solve(PatchMesh mesh, const Illumination& light, const Settings& settings,
  const Watch& watch, FactorLog* log)
{
  if (mesh.Faces().empty())
  {
    throw std::runtime_error("the scene has no surface of any area that could be lit");
  }
  Solution solution;
  RequireLight(MakeElements(mesh), light);
  watch.Begin("cutting patches");
  Subdivide(mesh, settings, solution);
  SolveOnce(mesh, light, settings, solution, watch, log);
  double size = solution.PatchSize;
  for (int pass = 0; pass < settings.Refinements; ++pass)
  {
    size *= 0.5;
    PatchMesh finer = mesh;
    const std::vector<char> steep = FindSteep(solution, settings.Steepness);
    for (std::size_t i = 0; i < steep.size(); ++i)
    {
      finer.Limit(i, steep[i] ? size : std::numeric_limits<double>::infinity());
    }
    if (!finer.Refine(settings.MaximumPatches))
    {
      solution.RefinementCut = true;
      break;
    }
    if (finer.Faces().size() == mesh.Faces().size())
    {
      break; // nowhere steep
    }
    mesh = std::move(finer);
    SolveOnce(mesh, light, settings, solution, watch, log);
  }
  return solution;
}
}
