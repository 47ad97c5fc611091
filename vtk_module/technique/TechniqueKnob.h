// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The levels of a technique that a frame budget chooses from: values of some of its parameters, which replace the user's for
 * a frame. No level costs more than the user's own settings, which are the last.
 */
#pragma once

#include "budget/Governor.h"

#include <functional>
#include <string>
#include <vector>

class vtkGITechnique;

namespace penumbra
{
struct BudgetFactor;

class TechniqueKnob
{
public:
  /// The levels of a technique with its present settings: one if it declares none, or none is cheaper than these.
  explicit TechniqueKnob(vtkGITechnique* technique);

  vtkGITechnique* Technique() const { return this->Owner; }
  int NumberOfLevels() const { return static_cast<int>(this->Levels.size()); }
  /// For the governor.
  Knob ToKnob() const;
  /// Values that differ from the user's: "resolution=half samples=16", or "own settings".
  std::string Name(int level) const;

  /// Put the values of a level in place, without a modified event. Returns a function that puts the user's back.
  std::function<void()> Apply(int level) const;

private:
  struct Level
  {
    std::vector<double> Values;
    double Work;
    double Error;
  };
  double Work(const std::vector<double>& values) const;
  /// Error at an amount of work, between the declared levels along its logarithm.
  double ErrorOf(double work) const;
  double Amount(const BudgetFactor& factor, double value) const;

  vtkGITechnique* Owner;
  std::vector<Level> Levels;
};
}
