// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Setters of public classes that refuse numbers that are not finite, and limit the others.
 */
#pragma once

#include "vtkObject.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
/// Set a member to a value within bounds. The name is the property's in the error message.
inline void SetChecked(
  vtkObject* self, const char* name, double& member, double value, double low, double high)
{
  if (!std::isfinite(value))
  {
    vtkErrorWithObjectMacro(self, << name << " must be a finite number; it is left unchanged.");
    return;
  }
  const double limited = std::clamp(value, low, high);
  if (limited != member)
  {
    member = limited;
    self->Modified();
  }
}

/// Set three numbers of at least 0.
inline void SetCheckedColor(
  vtkObject* self, const char* name, double (&member)[3], double r, double g, double b)
{
  if (!(std::isfinite(r) && std::isfinite(g) && std::isfinite(b) && r >= 0 && g >= 0 && b >= 0))
  {
    vtkErrorWithObjectMacro(
      self, << name << " must be three finite numbers of at least 0; it is left unchanged.");
    return;
  }
  if (member[0] != r || member[1] != g || member[2] != b)
  {
    member[0] = r;
    member[1] = g;
    member[2] = b;
    self->Modified();
  }
}
}
