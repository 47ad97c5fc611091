// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The stages of a frame that VTK draws itself: camera and lights, hardware selection, translucent props with depth
 * peeling, FXAA, volumes and annotations, in VTK's order.
 */
#pragma once

#include <functional>
#include <vector>

class vtkOpenGLFXAAFilter;
class vtkOpenGLRenderer;
class vtkProp;
class vtkRenderState;

namespace penumbra
{
class StockStages
{
public:
  explicit StockStages(const vtkRenderState* state);

  /// Set up viewport and lights and clear, as a renderer does first.
  void UpdateCameraAndLights();

  /// Draw for the hardware selector if one is active. Returns whether the frame is then complete.
  bool RenderSelection();

  /// Whether the renderer asks for hidden-line removal, which only VTK's own drawing of opaque props supports.
  bool NeedsStockOpaque() const;

  /// Draw all opaque props as VTK does.
  void RenderOpaque();

  /// Skip some of the translucent props.
  void ExcludeTranslucent(std::function<bool(vtkProp*)> isExcluded)
  {
    this->IsExcluded = std::move(isExcluded);
  }

  /// Draw everything that follows the opaque props. opaque: number of opaque props that were drawn elsewhere. fxaa:
  /// filters the picture if the renderer asks for it.
  void RenderAfterOpaque(int opaque, vtkOpenGLFXAAFilter* fxaa);

  int RenderedProps() const { return this->Rendered; }

private:
  const vtkRenderState* State;
  vtkOpenGLRenderer* Renderer;
  template <typename Draw>
  void WithProps(std::vector<vtkProp*> props, const Draw& draw);
  std::function<bool(vtkProp*)> IsExcluded;
  int Rendered = 0;
};
}
