// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Errors of a shadow map over a range of biases, and the part of the range where both are small.
#ifndef penumbra_tool_BiasSweep_h
#define penumbra_tool_BiasSweep_h

#include "lab/BiasMeasures.h"

#include <optional>
#include <string>
#include <vector>

class vtkGITechnique;

namespace penumbra::tool
{
/// What is still good: less is not seen in a picture.
struct BiasLimits
{
  double Acne = 0.001; ///< share of the light on lit surfaces
  double Gap = 1;      ///< texels
};

struct BiasSample
{
  double Bias = 0;
  BiasErrors Errors;
};

/// A run of samples, all within the limits.
struct BiasWindow
{
  double Low = 0;
  double High = 0;
  bool ReachesEnd = false; ///< the last bias tried is in it: it may go on
  double Choice = 0;       ///< the middle, or where it has not both ends, the best sample
};

struct BiasSweep
{
  std::string Kind;                ///< "constant"
  std::string Parameter;           ///< "constant-bias"
  std::vector<BiasSample> Samples; ///< bias rising

  /// The widest run of samples within the limits, the lower of two alike; nothing where none is.
  std::optional<BiasWindow> Window(const BiasLimits& limits) const;
  /// The sample that comes nearest to the limits; of the samples within them, the choice.
  const BiasSample& Best(const BiasLimits& limits) const;
};

/// The greater of both errors, each as a share of its limit: at most 1 is within.
double ShareOfLimits(const BiasErrors& errors, const BiasLimits& limits);

/// The kinds of bias that a technique has: its parameters that are numbers and end in "-bias", without
/// that ending.
std::vector<std::string> BiasKinds(vtkGITechnique* technique);

/// From low to high, both included.
std::vector<double> EvenSteps(double low, double high, int count);
}

#endif
