// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Convergence of the error, and the cost of a picture of indirect light.
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

/// Slope of the least-squares line through points, and its standard error.
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

/// Slope of the errors of 4 to samples / 16 paths per pixel against a reference of `samples` paths. The reference
/// contains these paths, which makes the slope of random samples steeper by 0.006.
Outcome ErrorSlope(Studio& studio, int samples, const std::string& shaders)
{
  constexpr int pixels = 48;
  BuildCornellBox(studio, pixels);
  // The lamp is out of view. The pixels on its edge, a thousand times as bright as the error of the others, would
  // measure anti-aliasing instead of light transport.
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

/// Ratio of red to green light along the floor's left edge, relative to that along its right edge.
Outcome ColorBleeding(Studio& studio, int samples)
{
  constexpr int pixels = 128;
  BuildCornellBox(studio, pixels);
  const Film film = studio.Trace(samples);
  double colors[2][2] = { { 0.0, 0.0 }, { 0.0, 0.0 } };
  // In row y the floor extends from column y to column 127 - y.
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
    "up to 8 reflections",
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
  const std::string group = "error over samples in a Cornell box: slope in a log-log diagram";
  return {
    { group, "independent random numbers", -0.5, { Rule::Absolute, 0.05 }, 4096, 0,
      slope(penumbra_test::TestData("validate/independent")), "", {}, {},
      "The reference has 4096 paths per pixel. With independent random numbers, the error falls "
      "with "
      "the square root of the number of samples. The path tracer's own sequence (Owen-scrambled "
      "Sobol "
      "points) is spread evenly over a pixel's samples, and the error falls faster. For the first "
      "row, "
      "one shader is replaced (`tests/validate/independent/`)." },
    { group, "the path tracer's own low-discrepancy sequence", -0.45, { Rule::AtMost, 0.0 }, 4096,
      0, slope(""), "", {}, {} },
    { "Cornell box", "red over green, left edge of the floor over right edge", 1.0,
      { Rule::AtLeast, 0.0 }, 256, 0, ColorBleeding, "cornell", { { 0.0, -3.9, 0.0 } }, {} },
  };
}
}
