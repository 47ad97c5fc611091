// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Entries of a technique's generated tables of parameters and presets.
 */
#pragma once

#include <vector>

class vtkGITechnique;

namespace penumbra
{
enum class ParameterType
{
  Bool,
  Int,
  Double,
  Enum
};

struct ParameterInfo
{
  const char* Name; ///< the name in scripts: "slope-bias"
  ParameterType Type;
  const char* Unit;
  const char* Documentation;
  double Default;
  double Minimum;
  double Maximum;
  std::vector<const char*> Values; ///< names of an enum's values
  double (*Get)(vtkGITechnique*);
  void (*Set)(vtkGITechnique*, double);
  /// Set without clamping and without a modified event: for values that hold during a frame.
  void (*Put)(vtkGITechnique*, double);
};

/// One value of a preset. A parameter of nullptr stands for the technique's own switch.
struct PresetValue
{
  const char* Preset;
  const char* Parameter;
  double Value;
};

/// How the amount of work depends on a parameter.
struct BudgetFactor
{
  const char* Parameter;
  double Exponent;               ///< the work grows with this power of a number
  std::vector<double> Factors;   ///< for an enum: relative work of its values
  std::vector<const char*> Zero; ///< parameters whose product is meant by a value of 0
};

/// Values of these parameters, and the error that they add to the picture: relMSE against the path tracer, less that of the
/// last level. Measured by tests/bench/knobs.py.
struct BudgetLevel
{
  std::vector<double> Values;
  double Error;
};

/// The levels among which a frame budget chooses, from the cheapest to the best.
struct BudgetInfo
{
  const char* Unit; ///< of the work
  bool PerPixel;    ///< whether the work grows with the number of pixels
  std::vector<BudgetFactor> Work;
  std::vector<BudgetLevel> Levels;
};
}
