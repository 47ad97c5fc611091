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
};

/// One value of a preset. A parameter of nullptr stands for the technique's own switch.
struct PresetValue
{
  const char* Preset;
  const char* Parameter;
  double Value;
};
}
