// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws several frames of a vtkGIPass for each still picture, which ParaView draws only once, so that techniques can
 * accumulate light and smooth edges. Draws one frame while the camera moves, and for a selection.
 */
#pragma once

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <string>

class vtkGIPass;
class vtkPVView;
class vtkRenderer;

namespace penumbra
{
class StillFramesPass : public vtkRenderPass
{
public:
  static StillFramesPass* New();
  vtkTypeMacro(StillFramesPass, vtkRenderPass);

  void SetPass(vtkGIPass* pass);
  void SetFrames(int frames) { this->Frames = frames; }
  void SetView(vtkPVView* view) { this->View = view; }

  /// Let all ranks that draw a moving picture together keep the budget alike. Each must call it at the start of each
  /// picture: IceT does not let a rank draw whose data are out of view.
  void ShareBudget(vtkRenderer* renderer);

  /// Whether Render() was called since the last call of this.
  bool TakeRendered();

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

private:
  vtkSmartPointer<vtkGIPass> Pass;
  vtkWeakPointer<vtkPVView> View;
  int Frames = 1;
  bool Rendered = false;
  std::string ReportedNotes; ///< the pass's notes, reported once until they change
};
}
