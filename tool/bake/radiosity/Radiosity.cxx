// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/radiosity/Radiosity.h"

#include "common/Failure.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace penumbra::radiosity
{
namespace
{
/// Whether the rays of form factors sample emission well: if a quarter of them hit it, or if shadow rays to all emitters would
/// take too long.
bool EmissionIsBroad(const std::vector<Element>& elements, const FactorMatrix& factors,
  std::size_t emitters, const Settings& settings)
{
  constexpr double mostShadowRays = 5e8;
  constexpr double broad = 0.25;
  double emissive = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    all += elements[i].Area;
    factors.ForEachIn(i, [&](std::size_t j, double share) {
      emissive += elements[j].Emission != Color(0.0) ? share * elements[i].Area : 0.0;
    });
  }
  return emissive > broad * all ||
    double(elements.size()) * double(emitters) * settings.ShadowPoints > mostShadowRays;
}

void RequireLight(const std::vector<Element>& elements, const Illumination& light)
{
  const bool emits = std::any_of(elements.begin(), elements.end(),
    [](const Element& element) { return element.Emission != Color(0.0); });
  const bool lit = std::any_of(light.Lights.begin(), light.Lights.end(),
    [](const Light& source) { return source.Color != Color(0.0); });
  if (!emits && !lit && !light.Surroundings)
  {
    tool::Fail("the scene has no light: add a light, an environment, or a material with emission");
  }
  if (GreatestReflectance(elements) >= 1.0)
  {
    tool::Fail("a surface reflects all light or more, so light between such surfaces would never "
               "end: give colours below 1");
  }
}

void Subdivide(PatchMesh& mesh, const Settings& settings, Solution& solution)
{
  if (mesh.Faces().size() > settings.MaximumPatches)
  {
    tool::Fail("the scene has {} triangles, more than the {} patches that --max-patches allows: "
               "simplify it, or allow more",
      mesh.Faces().size(), settings.MaximumPatches);
  }
  const bool chosen = settings.PatchSize > 0.0;
  constexpr double share = 0.025; // of the diagonal
  double size = chosen ? settings.PatchSize : share * mesh.Diagonal();
  PatchMesh cut = mesh;
  for (cut.LimitAll(size); !cut.Refine(settings.MaximumPatches); cut.LimitAll(size))
  {
    if (chosen)
    {
      tool::Fail("patches of that size would be more than the {} that --max-patches allows: give "
                 "a larger --patch-size, or allow more",
        settings.MaximumPatches);
    }
    constexpr double larger = 1.25;
    size *= larger;
    solution.SizeGrown = true;
    cut = mesh;
  }
  mesh = cut;
  solution.PatchSize = size;
}

/// Computes the irradiance at points between patches: exact direct light, and the mean of other light around them.
void LightPoints(const PatchMesh& mesh, const PatchRays& rays, const LightSources& sources,
  const std::vector<Color>& direct, const Settings& settings, Solution& solution,
  tool::Reporter& reporter)
{
  tool::Step step(reporter, "lighting corners of patches");
  solution.Points = MakeSmoothPoints(mesh, solution.Elements);
  std::vector<Color> rest = solution.Irradiance;
  for (std::size_t i = 0; i < rest.size(); ++i)
  {
    rest[i] -= direct[i];
  }
  solution.Points.Irradiance = MeanAround(solution.Points, solution.Elements, rest);
  const std::vector<Color> light = DirectAround(
    solution.Points, solution.Elements, rays, sources, settings.ShadowPoints, step.GetProgress());
  for (std::size_t i = 0; i < light.size(); ++i)
  {
    solution.Points.Irradiance[i] += light[i];
  }
}

void SolveOnce(const PatchMesh& mesh, const Illumination& light, const Settings& settings,
  Solution& solution, tool::Reporter& reporter, FactorLog* log)
{
  solution.Elements = MakeElements(mesh);
  const PatchRays rays(solution.Elements);
  Factors factors;
  {
    tool::Step step(reporter, "tracing form factors");
    factors = TraceFactors(
      solution.Elements, rays, settings.Rays, light.Surroundings, step.GetProgress(), log);
  }
  LightSources sources = { light.Lights, MakeEmitters(mesh) };
  solution.EmissionByRays =
    EmissionIsBroad(solution.Elements, factors.Matrix, sources.Emitters.size(), settings);
  if (solution.EmissionByRays)
  {
    sources.Emitters.clear();
  }
  std::vector<Color> direct;
  {
    tool::Step step(reporter, "lighting patches");
    direct =
      DirectIrradiance(solution.Elements, rays, sources, settings.ShadowPoints, step.GetProgress());
  }
  std::vector<Color> arriving = direct;
  for (std::size_t i = 0; i < arriving.size(); ++i)
  {
    arriving[i] += factors.SkyIrradiance[i];
    if (solution.EmissionByRays)
    {
      factors.Matrix.ForEachIn(i,
        [&](std::size_t j, double share) { arriving[i] += share * solution.Elements[j].Emission; });
    }
  }
  {
    tool::Step step(reporter, "solving");
    if (settings.Reciprocal)
    {
      MakeReciprocal(factors.Matrix, solution.Elements, factors.Escaped);
    }
    const LightBalance balance = { solution.Elements, factors.Matrix, arriving };
    if (settings.Method == Solver::Gathering || settings.Both)
    {
      solution.Gathered = GatherLight(balance, settings.Tolerance, step.GetProgress());
    }
    if (settings.Method == Solver::Shooting || settings.Both)
    {
      solution.Shot = ShootLight(balance, settings.Tolerance, step.GetProgress());
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
  }
  LightPoints(mesh, rays, sources, direct, settings, solution, reporter);
  for (const auto& entry : factors.Matrix.Entries)
  {
    const double share = std::min(1.0, double(entry.Value));
    solution.FactorError =
      std::max(solution.FactorError, std::sqrt(share * (1.0 - share) / factors.Matrix.Rays));
  }
  solution.Matrix = std::move(factors.Matrix);
  solution.Escaped = std::move(factors.Escaped);
}

double Brightness(const Color& c)
{
  return c.x + c.y + c.z;
}

/// Faces whose corners differ by more than the steepness, relative to the mean of the scene, or to their own mean if that is
/// greater (Weber's law).
std::vector<char> FindSteep(const Solution& solution, double steepness)
{
  double mean = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < solution.Elements.size(); ++i)
  {
    const double light = Brightness(solution.Irradiance[i]);
    mean += light * solution.Elements[i].Area;
    area += light > 0.0 ? solution.Elements[i].Area : 0.0;
  }
  mean /= std::max(area, 1e-300);
  std::vector<char> steep(solution.Elements.size() / 2, 0);
  for (std::size_t i = 0; i < solution.Elements.size(); ++i)
  {
    const auto& corners = solution.Points.OfElement[i];
    double low = Brightness(solution.Points.Irradiance[corners[0]]);
    double high = low;
    for (const std::uint32_t corner : corners)
    {
      low = std::min(low, Brightness(solution.Points.Irradiance[corner]));
      high = std::max(high, Brightness(solution.Points.Irradiance[corner]));
    }
    const bool matters = solution.Elements[i].Reflectance != Color(0.0);
    if (matters && high - low > steepness * std::max(mean, 0.5 * (low + high)))
    {
      steep[i / 2] = 1;
    }
  }
  return steep;
}

/// The mean by area over lit elements.
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
}

double RelativeError(const Solution& solution)
{
  const double square = MeanOverLit(
    solution, [&](std::size_t i) { return glm::dot(solution.Error[i], solution.Error[i]); });
  const double mean =
    MeanOverLit(solution, [&](std::size_t i) { return Brightness(solution.Irradiance[i]); });
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
    MeanOverLit(solution, [&](std::size_t i) { return Brightness(solution.Radiosity[i]) / 3.0; });
  return mean > 0.0 ? most / mean : 0.0;
}

Solution Solve(PatchMesh mesh, const Illumination& light, const Settings& settings,
  tool::Reporter& reporter, FactorLog* log)
{
  if (mesh.Faces().empty())
  {
    tool::Fail("the scene has no surface of any area that could be lit");
  }
  Solution solution;
  RequireLight(MakeElements(mesh), light);
  {
    tool::Step step(reporter, "subdividing surfaces");
    Subdivide(mesh, settings, solution);
  }
  SolveOnce(mesh, light, settings, solution, reporter, log);
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
      break; // nothing is steep
    }
    mesh = std::move(finer);
    SolveOnce(mesh, light, settings, solution, reporter, log);
  }
  return solution;
}
}
