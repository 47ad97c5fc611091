// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// A case: what a scene must come to, and how it is measured.
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
  double StandardError = NAN; ///< NAN where it is not known
  double Expected = NAN;      ///< where it is only known by measuring
  std::vector<std::string> Notes;
};

/// What Measured must be. In a full run a standard error of more than a third of the tolerance fails
/// too, as it could not tell.
struct Rule
{
  enum Kind
  {
    Relative, ///< within Value times Expected
    Absolute, ///< within Value of Expected
    Chance,   ///< within three standard errors of Expected, and those within Value times Expected
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
  int Quick;   ///< the same for the quick run, which leaves the case out where it is 0
  std::function<Outcome(Studio&, int samples)> Measure;
  std::string Picture; ///< name of the picture that is kept of it
  Vec3 Eye = { { 0.0, 0.0, 0.0 } };
  Vec3 Target = { { 0.0, 0.0, 0.0 } };
  std::string Remark = ""; ///< what a reader of its group should know
};

std::vector<Case> EnergyCases();
std::vector<Case> ReflectionCases();
std::vector<Case> OcclusionCases();
std::vector<Case> LightCases();
std::vector<Case> FormFactorCases();
std::vector<Case> StrategyCases();
std::vector<Case> ConvergenceCases();

/// Mean of a picture whose pixels all expect the same value; they have sequences of their own, so
/// that their spread is the error's.
Outcome MeanOfEqual(const Film& film, double unit = 1.0);
/// Mean over the surfaces seen, where pixels differ; the standard error is that of random samples,
/// and the samples are spread more evenly.
Outcome MeanOfSurface(const Film& film, double unit = 1.0);
/// Mean of one picture, which expects that of another one of the same size, pixel by pixel.
Outcome MeanBeside(const Film& film, const Film& other);
}
