// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Light of emitting surfaces on a point: a disc on its axis, by each strategy.
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
  // From under the disc on a spot small enough for the irradiance to be the centre's.
  studio.LookParallel(
    { { 0.0, 0.0, 1.0 } }, { { 0.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }, 0.01, 0.95);
  return MeanOfEqual(studio.Trace(samples), radiance);
}

Case Disced(double radius, const char* strategy, int samples, int quick)
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
    Disced(1.0, "both", 128, 32),
    Disced(1.0, "lights", 128, 32),
    Disced(1.0, "surfaces", 256, 64),
    Disced(0.25, "both", 64, 0),
    Disced(0.25, "lights", 64, 0),
    Disced(0.25, "surfaces", 2048, 0),
  };
}
}
