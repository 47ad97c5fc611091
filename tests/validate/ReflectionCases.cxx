// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Share of uniform light that each surface model reflects: a flat surface in surroundings of radiance 1, seen at an
// angle, against the same model integrated on the CPU.
#include "Case.h"
#include "Reflectance.h"
#include "Shapes.h"

#include <cstdio>

namespace validate
{
namespace
{
constexpr int Pixels = 64;
constexpr double Pi = 3.14159265358979323846;

Outcome Albedo(Studio& studio, int samples, const Material& material, double degrees)
{
  studio.Clear(Pixels, Pixels);
  studio.AddEnvironment(1.0, 50.0);
  studio.Add(Floor(-1.0, 1.0, -1.0, 1.0, 0.0), material);
  studio.SetBounces(1);
  const double angle = degrees * Pi / 180.0;
  // VTK computes view directions from the camera's position even in a parallel projection, so the camera is far away
  // and the picture small.
  const Vec3 eye = { { 0.0, -20.0 * std::sin(angle), 20.0 * std::cos(angle) } };
  studio.LookParallel(eye, { { 0.0, 0.0, 0.0 } }, { { 0.0, 1.0, 1.0 } }, 0.005, 1.0);
  return MeanOfEqual(studio.Trace(samples));
}

Case Phong(double diffuse, double specular, double power, double degrees, int quick)
{
  char name[80];
  std::snprintf(name, sizeof(name), "diffuse %g, specular %g, power %g, seen at %g°", diffuse,
    specular, power, degrees);
  return { "share of uniform light that VTK's Phong model reflects", name,
    PhongAlbedo(diffuse, specular, power, std::cos(degrees * Pi / 180.0)),
    { Rule::Relative, 0.005 }, 128, quick, [=](Studio& studio, int n) {
      return Albedo(studio, n, Shiny(diffuse, specular, power), degrees);
    } };
}

Case Physics(double metallic, double roughness, double degrees, int quick)
{
  char name[80];
  std::snprintf(name, sizeof(name), "white %s, roughness %g, seen at %g°",
    metallic > 0.5 ? "metal" : "dielectric", roughness, degrees);
  return {
    "share of uniform light that VTK's metallic-roughness model (single scattering) reflects", name,
    PhysicalAlbedo(1.0, metallic, roughness, std::cos(degrees * Pi / 180.0)),
    { Rule::Relative, 0.005 }, 256, quick,
    [=](Studio& studio, int n) {
      return Albedo(studio, n, Physical(1.0, metallic, roughness), degrees);
    }
  };
}
}

std::vector<Case> ReflectionCases()
{
  std::vector<Case> cases;
  const std::string phong =
    "The expected values come from the same formulas, reimplemented in C++ and integrated by the "
    "midpoint rule. VTK's highlight has no normalization factor, so its share decreases as its "
    "power increases.";
  const std::string physical =
    "Expected values as above. The model has no multiple scattering between facets, so rough "
    "metals "
    "are dark. Dielectrics seen at an angle reflect up to 2.4 % more light than they receive. "
    "Penumbra keeps VTK's look.";
  for (double power : { 1.0, 10.0, 100.0 })
  {
    for (double degrees : { 0.0, 60.0 })
    {
      cases.push_back(Phong(0.3, 0.6, power, degrees, power > 1.0 && power < 100.0 ? 16 : 0));
      cases.back().Remark = power < 2.0 && degrees < 1.0 ? phong : "";
    }
  }
  for (double metallic : { 1.0, 0.0 })
  {
    for (double roughness : { 0.1, 0.3, 0.6, 1.0 })
    {
      for (double degrees : { 0.0, 60.0 })
      {
        const bool quick = roughness > 0.2 && roughness < 0.4 && degrees > 0.0;
        cases.push_back(Physics(metallic, roughness, degrees, quick ? 16 : 0));
        cases.back().Remark = roughness < 0.2 && metallic > 0.5 && degrees < 1.0 ? physical : "";
      }
    }
  }
  return cases;
}
}
