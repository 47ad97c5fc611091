// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Visibility of uniform surroundings from a white surface among black ones, with one reflection of light.
#include "Case.h"
#include "Shapes.h"

#include <cstdio>

namespace validate
{
namespace
{
constexpr int Pixels = 64;
constexpr double Pi = 3.14159265358979323846;
constexpr double Long = 4000.0; // approximates infinity: visibility in a wedge is 0.00006 too high

/// Measure a spot of 0.02 by 0.02 from straight above, below all occluders.
Outcome MeasureSpot(Studio& studio, int samples, double x)
{
  studio.SetBounces(1);
  studio.LookParallel({ { x, 0.0, 1.0 } }, { { x, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }, 0.01, 0.95);
  return MeanOfEqual(studio.Trace(samples));
}

Outcome UnderSphere(Studio& studio, int samples, double x)
{
  studio.Clear(Pixels, Pixels);
  studio.AddEnvironment(1.0, 50.0);
  studio.Add(Floor(-3.0, 3.0, -3.0, 3.0, 0.0), Matte(1.0));
  studio.Add(Sphere(1.0, 1.0), Matte(0.0));
  return MeasureSpot(studio, samples, x);
}

Outcome BesideWall(Studio& studio, int samples, double height)
{
  studio.Clear(Pixels, Pixels);
  studio.AddEnvironment(1.0, 2.0 * Long);
  studio.Add(Floor(0.0, 3.0, -3.0, 3.0, 0.0), Matte(1.0));
  studio.Add(Quad({ { { { 0.0, -Long, 0.0 } }, { { 0.0, Long, 0.0 } }, { { 0.0, Long, height } },
               { { 0.0, -Long, height } } } }),
    Matte(0.0));
  return MeasureSpot(studio, samples, 1.0);
}

Outcome InWedge(Studio& studio, int samples, double degrees)
{
  studio.Clear(Pixels, Pixels);
  studio.AddEnvironment(1.0, 2.0 * Long);
  studio.Add(Floor(0.0, 3.0, -3.0, 3.0, 0.0), Matte(1.0));
  const double x = Long * std::cos(degrees * Pi / 180.0);
  const double z = Long * std::sin(degrees * Pi / 180.0);
  studio.Add(Quad({ { { { 0.0, -Long, 0.0 } }, { { 0.0, Long, 0.0 } }, { { x, Long, z } },
               { { x, -Long, z } } } }),
    Matte(0.0));
  return MeasureSpot(studio, samples, 0.5);
}

Outcome InPit(Studio& studio, int samples)
{
  studio.Clear(Pixels, Pixels);
  studio.AddEnvironment(1.0, 50.0);
  studio.Add(Sphere(1.0, 0.0, 90.0, 180.0), Matte(1.0));
  studio.SetBounces(1);
  // The largest square inside the rim of the pit.
  studio.LookParallel(
    { { 0.0, 0.0, 3.0 } }, { { 0.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }, 0.7, 0.1);
  return MeanOfEqual(studio.Trace(samples));
}

Case VisibilityCase(const std::string& name, double visibility, int samples, int quick,
  const std::function<Outcome(Studio&, int)>& measure, const std::string& picture, const Vec3& eye)
{
  return { "ambient occlusion: visibility of uniform surroundings", name, visibility,
    { Rule::Relative, 0.005 }, samples, quick, measure, picture, eye, { { 0.5, 0.0, 0.5 } } };
}

Case SphereCase(double x, int samples, int quick)
{
  char name[80];
  std::snprintf(name, sizeof(name), "%g from the foot of a unit sphere: 1 − (x² + 1)^(−3/2)", x);
  return VisibilityCase(name, 1.0 - std::pow(x * x + 1.0, -1.5), samples, quick,
    [x](Studio& studio, int n) { return UnderSphere(studio, n, x); },
    x < 1.0 ? "occlusion-sphere" : "", { { 3.0, -6.0, 3.0 } });
}

Case WallCase(double height, int quick)
{
  char name[80];
  std::snprintf(name, sizeof(name), "1 from a wall %g high: 1 − ½ (1 − d / √(d² + h²))", height);
  return VisibilityCase(name, 0.5 + 0.5 / std::sqrt(1.0 + height * height), 256, quick,
    [height](Studio& studio, int n) { return BesideWall(studio, n, height); },
    height > 1.0 ? "occlusion-wall" : "", { { 5.0, -6.0, 3.0 } });
}

Case WedgeCase(double degrees, int quick)
{
  char name[80];
  std::snprintf(name, sizeof(name), "between planes that open by %g°: ½ (1 − cos φ)", degrees);
  return VisibilityCase(name, 0.5 - 0.5 * std::cos(degrees * Pi / 180.0),
    degrees < 60.0 ? 1024 : 256, quick,
    [degrees](Studio& studio, int n) { return InWedge(studio, n, degrees); },
    degrees > 100.0 ? "occlusion-wedge" : "", { { 6.0, -6.0, 2.0 } });
}
}

std::vector<Case> OcclusionCases()
{
  return {
    SphereCase(0.5, 512, 64),
    SphereCase(1.0, 256, 0),
    SphereCase(2.0, 128, 0),
    WallCase(1.0, 32),
    WallCase(3.0, 0),
    WedgeCase(45.0, 0),
    WedgeCase(90.0, 32),
    WedgeCase(135.0, 0),
    VisibilityCase("anywhere in a hemispherical pit: ½", 0.5, 256, 32, InPit, "occlusion-pit",
      { { 0.5, -4.0, 4.0 } }),
  };
}
}
