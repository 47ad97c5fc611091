// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a technique's generated parameter table holds.
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
  const char* Name; ///< as in scripts: "slope-bias"
  ParameterType Type;
  const char* Unit;
  const char* Documentation;
  double Default;
  double Minimum;
  double Maximum;
  std::vector<const char*> Values; ///< an enum's values, by number
  double (*Get)(vtkGITechnique*);
  void (*Set)(vtkGITechnique*, double);
};

/// One line of a preset: parameter nullptr stands for the technique's own switch.
struct PresetValue
{
  const char* Preset;
  const char* Parameter;
  double Value;
};
}
