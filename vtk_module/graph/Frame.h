// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A frame under construction, to which passes are added.
 */
#pragma once

#include "graph/FrameContext.h"

namespace penumbra
{
class Frame
{
public:
  /// pool: textures, in which the view's histories are under viewName.
  Frame(FrameGraph& graph, View& view, vtkOpenGLRenderer* renderer, ResourcePool& pool,
    const std::string& viewName)
    : CurrentView(view)
    , Graph(graph)
    , Renderer(renderer)
    , Pool(pool)
    , ViewName(viewName)
  {
  }
  PassDeclaration& AddPass(const std::string& name)
  {
    return this->Graph.AddPass(name).OwnedBy(this->Owner).Offer(this->Offered);
  }
  /// Whether a pass that was added writes this resource.
  bool IsWritten(const std::string& resource) const { return this->Graph.IsWritten(resource); }
  /// From now on, passes are added for a technique, or for none if "", and their shaders are offered these arguments.
  void AddFor(const std::string& technique, const Arguments& offered)
  {
    this->Owner = technique;
    this->Offered = offered;
  }

  /// History of the view with this name. It is created if the view has none of this shape.
  History& Keep(const std::string& name, const TextureDesc& desc)
  {
    return this->Pool.Keep(this->ViewName, name, desc);
  }
  const View& GetView() const { return this->CurrentView; }
  vtkOpenGLRenderer* GetRenderer() const { return this->Renderer; }

  /// Shape of a texture of the window's size.
  TextureDesc WindowTexture(GLenum format, int layers = 0) const
  {
    return { format, this->CurrentView.WindowSize.x, this->CurrentView.WindowSize.y, layers };
  }

protected:
  const std::string& GetOwner() const { return this->Owner; }

  View& CurrentView;

private:
  FrameGraph& Graph;
  vtkOpenGLRenderer* Renderer;
  ResourcePool& Pool;
  std::string ViewName;
  std::string Owner;
  Arguments Offered;
};
}
