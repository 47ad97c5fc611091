// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A look's settings of the techniques of a pass, which several renderers may share. They are undone when the last of
 * them gives its look up.
 */
#pragma once

#include "looks/LookDescription.h"

#include "vtkWeakPointer.h"

class vtkGIPass;

namespace penumbra
{
class LookSettings
{
public:
  explicit LookSettings(vtkGIPass* pass);
  ~LookSettings();
  LookSettings(const LookSettings&) = delete;
  LookSettings& operator=(const LookSettings&) = delete;

  vtkGIPass* GetPass() const;

  /// Undo the last settings and apply others.
  void Apply(const std::map<std::string, LookTechnique>& settings);

private:
  static void Set(vtkGIPass* pass, const std::map<std::string, LookTechnique>& settings);
  void Undo();

  vtkWeakPointer<vtkGIPass> Pass;
  std::map<std::string, LookTechnique> Before;
};
}
