// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// A case: a scene, its expected value, and how it is measured.
#pragma once

#include "Studio.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace validate
{
struct Outcome
{
  double Measured = NAN;
  double StandardError = NAN; ///< NAN if not known
  double Expected = NAN;      ///< if the expected value is measured too
  std::vector<std::string> Notes;
};

/// Condition on the measured value. In a full run, a standard error of more than a third of the tolerance fails too.
struct Rule
{
  enum Kind
  {
    Relative, ///< within Value times Expected
    Absolute, ///< within Value of Expected
    Chance,   ///< within three standard errors of Expected, which are at most Value times Expected
    AtLeast,  ///< Expected or more
    AtMost,   ///< Expected or less
  };
  Kind Is = Relative;
  double Value = 0.005;
};

struct Case
{
  std::string Group;
  std::string Name;
  double Expected; ///< NAN: Outcome::Expected
  Rule Limit;
  int Samples; ///< per pixel
  int Quick;   ///< samples per pixel in the quick run; 0 leaves the case out
  std::function<Outcome(Studio&, int samples)> Measure;
  std::string Picture; ///< name of the case's picture; empty: none
  Vec3 Eye = { { 0.0, 0.0, 0.0 } };
  Vec3 Target = { { 0.0, 0.0, 0.0 } };
  std::string Remark = ""; ///< remark on the group
};

std::vector<Case> EnergyCases();
std::vector<Case> ReflectionCases();
std::vector<Case> OcclusionCases();
std::vector<Case> LightCases();
std::vector<Case> FormFactorCases();
std::vector<Case> StrategyCases();
std::vector<Case> ConvergenceCases();

/// Mean of a picture whose pixels all have the same expected value. Their sequences are independent, so their spread
/// gives the standard error.
Outcome MeanOfEqual(const Film& film, double unit = 1.0);
/// Mean over the visible surfaces, whose pixels differ. The standard error is that of random samples, an upper bound
/// because the samples are spread more evenly.
Outcome MeanOfSurface(const Film& film, double unit = 1.0);
/// Mean of a picture, with the mean of another one of the same size as the expected value. The standard error is that
/// of the difference per pixel.
Outcome MeanComparedTo(const Film& film, const Film& other);
}
