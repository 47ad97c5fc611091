// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Form factors: radiance of a white receiver over that of its emitter. Expected values: Howell, Mengüç, Daun, Siegel
// 2020, "Thermal Radiation Heat Transfer", appendix C.
#include "Case.h"
#include "Shapes.h"

namespace validate
{
namespace
{
constexpr int Pixels = 64;
constexpr double Pi = 3.14159265358979323846;

struct Squares
{
  bool Above = false; ///< an emitter at height 1
  int Beside = 0;     ///< number of emitters that share an edge with the receiver
};

/// Mean over the unit square on the floor, as seen from below the upper emitter.
Outcome Received(Studio& studio, int samples, const Squares& squares)
{
  studio.Clear(Pixels, Pixels);
  studio.Add(Floor(-1.0, 2.0, -1.0, 2.0, 0.0), Matte(1.0));
  const Material glow = Matte(0.0, 1.0);
  if (squares.Above)
  {
    studio.Add(Ceiling(0.0, 1.0, 0.0, 1.0, 1.0), glow);
  }
  const double corners[5][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0, 0 } };
  for (int i = 0; i < squares.Beside; ++i)
  {
    const auto* a = corners[i];
    const auto* b = corners[i + 1];
    studio.Add(Quad({ { { { a[0], a[1], 0.0 } }, { { a[0], a[1], 1.0 } }, { { b[0], b[1], 1.0 } },
                 { { b[0], b[1], 0.0 } } } }),
      glow);
  }
  studio.SetBounces(0);
  studio.LookParallel(
    { { 0.5, 0.5, 2.0 } }, { { 0.5, 0.5, 0.0 } }, { { 0.0, 1.0, 0.0 } }, 0.5, 1.01);
  return MeanOfSurface(studio.Trace(samples));
}

Outcome Discs(Studio& studio, int samples)
{
  studio.Clear(Pixels, Pixels);
  studio.Add(Disc(1.0, 0.0, true), Matte(1.0));
  studio.Add(Disc(1.0, 1.0, false), Matte(0.0, 1.0));
  studio.SetBounces(0);
  studio.LookParallel(
    { { 0.0, 0.0, 2.0 } }, { { 0.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }, 1.02, 1.01);
  return MeanOfSurface(studio.Trace(samples));
}

Outcome UnderSquare(Studio& studio, int samples)
{
  studio.Clear(Pixels, Pixels);
  studio.Add(Floor(-2.0, 2.0, -2.0, 2.0, 0.0), Matte(1.0));
  studio.Add(Ceiling(-0.5, 0.5, -0.5, 0.5, 1.0), Matte(0.0, 1.0));
  studio.SetBounces(0);
  studio.LookParallel(
    { { 0.0, 0.0, 1.0 } }, { { 0.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }, 0.01, 0.95);
  return MeanOfEqual(studio.Trace(samples));
}

/// Sum of a cube's form factors, from separate measurements of the two kinds.
Outcome CubeSum(Studio& studio, int samples)
{
  const Outcome above = Received(studio, samples, { true, 0 });
  const Outcome beside = Received(studio, samples, { false, 1 });
  Outcome outcome;
  outcome.Measured = above.Measured + 4.0 * beside.Measured;
  outcome.StandardError = std::hypot(above.StandardError, 4.0 * beside.StandardError);
  return outcome;
}

Case Factor(const std::string& name, double expected, int samples, int quick,
  const std::function<Outcome(Studio&, int)>& measure, const std::string& picture = "")
{
  return { "form factors", name, expected, { Rule::Relative, 0.005 }, samples, quick, measure,
    picture, { { 3.0, -4.0, 2.0 } }, { { 0.3, 0.3, 0.5 } } };
}
}

std::vector<Case> FormFactorCases()
{
  // Formulas of the published values.
  const double parallel = 2.0 / Pi *
    (std::log(std::sqrt(4.0 / 3.0)) + 2.0 * std::sqrt(2.0) * std::atan(1.0 / std::sqrt(2.0)) -
      0.5 * Pi);
  const double perpendicular = (1.0 - parallel) / 4.0;
  const double below =
    4.0 / (2.0 * Pi) * 2.0 * 0.5 / std::sqrt(1.25) * std::atan(0.5 / std::sqrt(1.25));
  const double discs = 0.5 * (3.0 - std::sqrt(5.0));
  const auto with = [](const Squares& squares) {
    return [squares](Studio& studio, int n) { return Received(studio, n, squares); };
  };
  return {
    Factor("unit squares, parallel, at distance 1 (0.199825)", parallel, 128, 32, with({ true, 0 }),
      "form-factor-parallel"),
    Factor("unit squares, perpendicular, sharing an edge (0.200044)", perpendicular, 256, 64,
      with({ false, 1 }), "form-factor-perpendicular"),
    Factor("F∥ + 4 F⊥ of a cube", 1.0, 256, 0, CubeSum),
    Factor("floor of a cube whose other sides emit light", 1.0, 256, 0, with({ true, 4 }),
      "form-factor-cube"),
    Factor("coaxial discs, r = h = 1 (0.381966)", discs, 256, 32, Discs, "form-factor-discs"),
    Factor("point under a unit square at height 1 (0.239456)", below, 128, 32, UnderSquare,
      "form-factor-point"),
  };
}
}
