// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Conservation of energy: closed boxes, and white objects in white surroundings.
#include "Case.h"
#include "Shapes.h"

namespace validate
{
namespace
{
constexpr int Pixels = 64; // width and height of a picture
// Practically unlimited: Russian roulette ends each path earlier, without bias.
constexpr int UnlimitedBounces = 1000;
constexpr double Far = 50.0; // distance of the surroundings

/// Number of reflections after which less than 0.0001 of the light remains.
int Reflections(double reflectance)
{
  return static_cast<int>(std::ceil(std::log(1e-4) / std::log(reflectance)));
}

Outcome ClosedBox(Studio& studio, int samples, double reflectance)
{
  constexpr double emission = 0.25;
  studio.Clear(Pixels, Pixels);
  studio.Add(Box({ { -1.0, -1.0, -1.0 } }, { { 1.0, 1.0, 1.0 } }), Matte(reflectance, emission));
  studio.SetBounces(Reflections(reflectance));
  studio.Look({ { -0.7, -0.6, 0.2 } }, { { 1.0, 0.8, -0.3 } }, 80.0);
  return MeanOfEqual(studio.Trace(samples), emission);
}

enum class Surroundings
{
  Walls,  ///< distant glowing walls
  Picture ///< an environment texture
};

Outcome Furnace(Studio& studio, int samples, const Shape& object, double reflectance, double half,
  Surroundings surroundings)
{
  studio.Clear(Pixels, Pixels);
  if (surroundings == Surroundings::Walls)
  {
    studio.AddEnvironment(1.0, Far);
  }
  else
  {
    studio.SetEnvironmentTexture(1.0);
  }
  studio.Add(object, Matte(reflectance));
  studio.SetBounces(UnlimitedBounces);
  studio.LookParallel(
    { { 0.0, -4.0, 3.0 } }, { { 0.0, 0.0, 0.0 } }, { { 0.0, 0.0, 1.0 } }, half, 0.1);
  return MeanOfEqual(studio.Trace(samples));
}

Case ClosedBoxCase(double reflectance, const std::string& name, int samples, int quick)
{
  return { "closed box: emission 1 and reflectance ρ of every wall give 1 / (1 − ρ)", name,
    1.0 / (1.0 - reflectance), { Rule::Relative, 0.005 }, samples, quick,
    [reflectance](Studio& studio, int n) { return ClosedBox(studio, n, reflectance); } };
}

Case FurnaceCase(const std::string& name, const std::function<Shape()>& make, double reflectance,
  double half, int samples, int quick, Surroundings surroundings = Surroundings::Walls)
{
  return { "furnace: a diffuse object in surroundings of radiance 1", name,
    reflectance < 1.0 ? reflectance : 1.0, { Rule::Relative, 0.002 }, samples, quick,
    [=](Studio& studio, int n) {
      return Furnace(studio, n, make(), reflectance, half, surroundings);
    } };
}
}

std::vector<Case> EnergyCases()
{
  const auto ball = [] { return Sphere(1.0, 0.0); };
  const auto ring = [] { return Torus(1.0, 0.5); };
  std::vector<Case> cases = {
    ClosedBoxCase(0.2, "ρ = 0.2", 256, 32),
    ClosedBoxCase(0.5, "ρ = 0.5", 256, 32),
    ClosedBoxCase(0.8, "ρ = 0.8", 256, 32),
    FurnaceCase("sphere, ρ = 0.5, only its disc", ball, 0.5, 0.65, 64, 8),
    FurnaceCase("sphere, ρ = 1: invisible", ball, 1.0, 1.3, 64, 8),
    FurnaceCase("torus (concave), ρ = 1: invisible", ring, 1.0, 1.6, 64, 8),
    FurnaceCase(
      "sphere, ρ = 1, in an environment texture", ball, 1.0, 1.3, 64, 8, Surroundings::Picture),
    FurnaceCase("torus (concave), ρ = 1, in an environment texture", ring, 1.0, 1.6, 64, 8,
      Surroundings::Picture),
  };
  cases[2].Picture = "closed-box";
  cases[2].Eye = { { -0.7, -0.6, 0.2 } };
  cases[2].Target = { { 1.0, 0.8, -0.3 } };
  cases[3].Picture = "furnace-half";
  cases[3].Eye = { { 0.0, -4.0, 3.0 } };
  cases[5].Picture = "furnace-white";
  cases[5].Eye = { { 0.0, -4.0, 3.0 } };
  return cases;
}
}
