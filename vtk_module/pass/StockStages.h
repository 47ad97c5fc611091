// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The stages of a frame that stay VTK's own: camera and lights, hardware selection, translucent
 * props with their peeling, FXAA, volumes and annotations, in VTK's order.
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

  /// Viewport, clearing, light geometry. What a renderer does first.
  void UpdateCameraAndLights();

  /// Draw for the hardware selector if one is active; true if that was the whole frame.
  bool RenderSelection();

  /// Whether the renderer asks for something that only VTK's own drawing of opaque props does:
  /// the removal of hidden lines.
  bool NeedsStockOpaque() const;

  /// All opaque props as VTK draws them.
  void RenderOpaque();

  /// Do not draw these among the translucent props.
  void LeaveOutTranslucent(std::function<bool(vtkProp*)> which)
  {
    this->LeftOut = std::move(which);
  }

  /// Everything that follows the opaque props. opaque: how many of those were drawn elsewhere.
  /// fxaa filters the picture where the renderer asks for it.
  void RenderAfterOpaque(int opaque, vtkOpenGLFXAAFilter* fxaa);

  int RenderedProps() const { return this->Rendered; }

private:
  const vtkRenderState* State;
  vtkOpenGLRenderer* Renderer;
  template <typename Draw>
  void WithProps(std::vector<vtkProp*> props, const Draw& draw);
  std::function<bool(vtkProp*)> LeftOut;
  int Rendered = 0;
};
}
