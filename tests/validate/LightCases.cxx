// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Irradiance at a point on the axis of an emitting disc, with each strategy.
#include "Case.h"
#include "Shapes.h"

#include <cstdio>

namespace validate
{
namespace
{
constexpr int Pixels = 64;

Outcome UnderDisc(Studio& studio, int samples, double radius, const char* strategy)
{
  constexpr double radiance = 1.0;
  studio.Clear(Pixels, Pixels);
  studio.Add(Floor(-2.0, 2.0, -2.0, 2.0, 0.0), Matte(1.0));
  studio.Add(Disc(radius, 1.0, false), Matte(0.0, radiance));
  studio.SetBounces(0);
  studio.SetStrategy(strategy);
  // Look from below the disc at a spot so small that its irradiance equals that of the centre.
  studio.LookParallel(
    { { 0.0, 0.0, 1.0 } }, { { 0.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }, 0.01, 0.95);
  return MeanOfEqual(studio.Trace(samples), radiance);
}

Case DiscCase(double radius, const char* strategy, int samples, int quick)
{
  char name[80];
  std::snprintf(name, sizeof(name), "radius %g at height 1, strategy %s", radius, strategy);
  return { "disc light on its axis: E / (π L) = R² / (R² + h²)", name,
    radius * radius / (radius * radius + 1.0), { Rule::Relative, 0.005 }, samples, quick,
    [=](Studio& studio, int n) { return UnderDisc(studio, n, radius, strategy); },
    radius > 0.9 ? std::string("disc-") + strategy : "", { { 3.0, -5.0, 1.6 } },
    { { 0.0, 0.0, 0.5 } } };
}
}

std::vector<Case> LightCases()
{
  return {
    DiscCase(1.0, "both", 128, 32),
    DiscCase(1.0, "lights", 128, 32),
    DiscCase(1.0, "surfaces", 256, 64),
    DiscCase(0.25, "both", 64, 0),
    DiscCase(0.25, "lights", 64, 0),
    DiscCase(0.25, "surfaces", 2048, 0),
  };
}
}
