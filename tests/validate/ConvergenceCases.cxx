// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// How fast the error falls, and what a picture of indirect light costs.
#include "Case.h"
#include "Cornell.h"
#include "TestData.h"

#include <cstdio>

namespace validate
{
namespace
{
double RootMeanSquare(const Film& film, const Film& reference)
{
  double squares = 0.0;
  for (std::size_t i = 0; i < film.Luminance.size(); ++i)
  {
    const double difference = film.Luminance[i] - reference.Luminance[i];
    squares += difference * difference;
  }
  return std::sqrt(squares / static_cast<double>(film.Luminance.size()));
}

/// Slope of a line through points, by least squares, and its standard error.
Outcome Fit(const std::vector<double>& x, const std::vector<double>& y)
{
  const double count = static_cast<double>(x.size());
  double sums[4] = { 0.0, 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    sums[0] += x[i];
    sums[1] += y[i];
    sums[2] += x[i] * x[i];
    sums[3] += x[i] * y[i];
  }
  const double spread = sums[2] - sums[0] * sums[0] / count;
  Outcome outcome;
  outcome.Measured = (sums[3] - sums[0] * sums[1] / count) / spread;
  double residual = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    const double off = y[i] - sums[1] / count - outcome.Measured * (x[i] - sums[0] / count);
    residual += off * off;
  }
  outcome.StandardError = std::sqrt(residual / (count - 2.0) / spread);
  return outcome;
}

/// Errors of 4 to samples / 16 paths a pixel against a reference of `samples`. It contains those
/// paths, which makes the slope of random samples steeper by 0.006.
Outcome ErrorSlope(Studio& studio, int samples, const std::string& shaders)
{
  constexpr int pixels = 48;
  BuildCornellBox(studio, pixels);
  // The lamp is out of sight: the pixels on its rim, a thousand times as bright as the rest's error,
  // would show how evenly a pixel's area is covered and hide how light is found.
  studio.Look({ { 0.0, -3.9, 0.0 } }, { { 0.0, 0.0, -0.3 } }, 25.0);
  studio.SetShaders(shaders);
  const Film reference = studio.Trace(samples);
  std::vector<double> counts;
  std::vector<double> errors;
  std::string note = "RMS error:";
  for (int n = 4; n <= samples / 16; n *= 2)
  {
    const double error = RootMeanSquare(studio.Trace(n), reference);
    counts.push_back(std::log(static_cast<double>(n)));
    errors.push_back(std::log(error));
    char text[60];
    std::snprintf(text, sizeof(text), " %.5f at %d%s", error, n, 2 * n > samples / 16 ? "" : ",");
    note += text;
  }
  Outcome outcome = Fit(counts, errors);
  outcome.Notes.push_back(note);
  return outcome;
}

/// Red over green light on the floor's left and right rim.
Outcome Bleeding(Studio& studio, int samples)
{
  constexpr int pixels = 128;
  BuildCornellBox(studio, pixels);
  const Film film = studio.Trace(samples);
  double colors[2][2] = { { 0.0, 0.0 }, { 0.0, 0.0 } };
  // In row y the floor reaches from column y to column 127 - y.
  for (int y = 4; y < 12; ++y)
  {
    for (int side = 0; side < 2; ++side)
    {
      for (int x = 0; x < 16; ++x)
      {
        const int column = side == 0 ? 14 + x : pixels - 15 - x;
        const float* color = &film.Color[3 * (static_cast<std::size_t>(y) * pixels + column)];
        colors[side][0] += color[0];
        colors[side][1] += color[1];
      }
    }
  }
  const Outcome mean = MeanOfSurface(film);
  char text[160];
  std::snprintf(text, sizeof(text),
    "mean luminance %.4f (standard error at most %.4f) of surfaces; %.2f s for a million paths of "
    "up to 8 "
    "reflections",
    mean.Measured, mean.StandardError, film.Seconds / (1e-6 * pixels * pixels * (samples - 1)));
  Outcome outcome;
  outcome.Measured = colors[0][0] / colors[0][1] / (colors[1][0] / colors[1][1]);
  outcome.Notes.push_back(text);
  return outcome;
}
}

std::vector<Case> ConvergenceCases()
{
  const auto slope = [](const std::string& shaders) {
    return [shaders](Studio& studio, int n) { return ErrorSlope(studio, n, shaders); };
  };
  const std::string group = "error against samples, a Cornell box: slope in a log-log diagram";
  return {
    { group, "independent random numbers", -0.5, { Rule::Absolute, 0.05 }, 4096, 0,
      slope(penumbra_test::TestData("validate/independent")), "", {}, {},
      "4096 paths a pixel are the reference. Random errors fall as the square root of the samples. "
      "The "
      "path tracer's own numbers are spread evenly over those of a pixel (Owen-scrambled Sobol "
      "points), and their errors fall faster; for the first row one shader is replaced "
      "(`tests/validate/independent/`)." },
    { group, "the path tracer's own, evenly spread", -0.45, { Rule::AtMost, 0.0 }, 4096, 0,
      slope(""), "", {}, {} },
    { "Cornell box", "red over green, the floor's left rim over its right one", 1.0,
      { Rule::AtLeast, 0.0 }, 256, 0, Bleeding, "cornell", { { 0.0, -3.9, 0.0 } }, {} },
  };
}
}
