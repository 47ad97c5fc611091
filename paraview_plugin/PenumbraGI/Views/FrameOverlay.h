// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A chart of what a view's frames cost, drawn over the view. It is in a renderer of its own layer, so that the picture
 * below does not change with it, and its averages go on.
 */
#pragma once

#include "vtkNew.h"
#include "vtkWeakPointer.h"

class vtkContextActor;
class vtkGIFrameChart;
class vtkGIPass;
class vtkRenderer;

namespace penumbra
{
class FrameOverlay
{
public:
  FrameOverlay();
  ~FrameOverlay();

  /// Draw the chart with a renderer from now on; nullptr for none.
  void SetRenderer(vtkRenderer* renderer);

  /// Show the last frame of a pass. visible: false leaves the chart out of this picture.
  void Update(vtkGIPass* pass, bool visible);

private:
  vtkNew<vtkGIFrameChart> Chart;
  vtkNew<vtkContextActor> Actor;
  vtkWeakPointer<vtkRenderer> Renderer;
};
}
