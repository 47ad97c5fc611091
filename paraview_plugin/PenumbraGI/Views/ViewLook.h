// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The look of a render view. It is applied on top of the view's lights, background and settings, which ParaView keeps.
 */
#pragma once

#include <string>

class vtkGIPass;
class vtkRenderer;

namespace penumbra
{
class ViewLook
{
public:
  /// Choose a look by its name or file.
  void Choose(const std::string& nameOrPath) { this->Chosen = nameOrPath; }

  /// Apply the chosen look, unless it is applied already. Reports one that cannot be read.
  void Update(vtkRenderer* renderer, vtkGIPass* pass);

  /// Remove the look, so that settings below it can change; Update() applies it again.
  void Remove(vtkRenderer* renderer);

  /// The last report, or "".
  const std::string& GetProblem() const { return this->Problem; }

private:
  std::string Chosen = "as-is";
  std::string Applied; ///< "" if none was tried since Remove()
  std::string Problem;
};
}
