// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Sampling points on emitters, sampling directions of reflection, and both have the same mean.
#include "Case.h"
#include "Shapes.h"

#include <memory>

namespace validate
{
namespace
{
Film UnderLamp(Studio& studio, int samples, const Material& material, const char* strategy)
{
  constexpr int pixels = 48;
  studio.Clear(pixels, pixels);
  studio.Add(Floor(-3.0, 3.0, -3.0, 3.0, 0.0), material);
  studio.Add(Sphere(0.8, 0.8), material);
  studio.Add(Quad({ { { { -3.0, 2.0, 0.0 } }, { { 3.0, 2.0, 0.0 } }, { { 3.0, 2.0, 4.0 } },
               { { -3.0, 2.0, 4.0 } } } }),
    Painted({ { 0.7, 0.5, 0.3 } }));
  studio.Add(Ceiling(-2.2, -0.2, -1.5, 0.5, 2.6), Matte(0.3, 2.0));
  studio.SetBounces(3);
  studio.SetStrategy(strategy);
  studio.Look({ { 1.0, -5.0, 2.2 } }, { { 0.0, 0.0, 0.7 } }, 30.0);
  return studio.Trace(samples);
}

Case SameMeanCase(const std::string& name, const Material& material,
  const std::shared_ptr<Film>& both, const char* strategy, int quick,
  const std::string& picture = "")
{
  // The two cases of a material share the picture with both strategies.
  return { "each strategy has the mean of both together", name + ", " + strategy, NAN,
    { Rule::Chance, 0.01 }, 256, quick,
    [=](Studio& studio, int n) {
      if (both->Samples != n)
      {
        *both = UnderLamp(studio, n, material, "both");
      }
      return MeanComparedTo(UnderLamp(studio, n, material, strategy), *both);
    },
    picture, { { 1.0, -5.0, 2.2 } }, { { 0.0, 0.0, 0.7 } } };
}
}

std::vector<Case> StrategyCases()
{
  struct Surface
  {
    const char* Name;
    Material Appearance;
    int QuickLights;
    int QuickSurfaces;
    const char* Picture;
  };
  const Surface surfaces[] = {
    { "diffuse", Matte(0.7), 8, 8, "strategies-diffuse" },
    { "Phong, power 30", Shiny(0.4, 0.5, 30.0), 0, 8, "strategies-phong" },
    { "metal, roughness 0.4", Physical(0.8, 1.0, 0.4), 8, 8, "strategies-metal" },
    { "dielectric, roughness 0.3", Physical(0.8, 0.0, 0.3), 8, 0, "strategies-dielectric" },
  };
  std::vector<Case> cases;
  for (const Surface& surface : surfaces)
  {
    const auto both = std::make_shared<Film>();
    cases.push_back(
      SameMeanCase(surface.Name, surface.Appearance, both, "lights", surface.QuickLights));
    cases.push_back(SameMeanCase(
      surface.Name, surface.Appearance, both, "surfaces", surface.QuickSurfaces, surface.Picture));
  }
  return cases;
}
}
