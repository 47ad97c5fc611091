// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A frame in the making, as everything that adds passes to it sees it.
 */
#pragma once

#include "graph/FrameContext.h"

namespace penumbra
{
class Frame
{
public:
  Frame(FrameGraph& graph, View& view, vtkOpenGLRenderer* renderer)
    : CurrentView(view)
    , Graph(graph)
    , Renderer(renderer)
  {
  }
  PassDeclaration& AddPass(const std::string& name) { return this->Graph.AddPass(name); }
  const View& GetView() const { return this->CurrentView; }
  vtkOpenGLRenderer* GetRenderer() const { return this->Renderer; }

  /// The shape of a texture of the window's size.
  TextureDesc WindowTexture(GLenum format, int layers = 0) const
  {
    return { format, this->CurrentView.WindowSize.x, this->CurrentView.WindowSize.y, layers };
  }

protected:
  View& CurrentView;

private:
  FrameGraph& Graph;
  vtkOpenGLRenderer* Renderer;
};
}
