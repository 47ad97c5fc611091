// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Runs a compiled frame graph on the GPU: lends textures for their lifetime, binds targets, times
 * passes. The window's own buffers replace textures where possible.
 */
#pragma once

#include "gpu/GpuTimer.h"
#include "gpu/HeldTextures.h"
#include "graph/FrameContext.h"

namespace penumbra
{
/// VTK's framebuffer of the window being rendered, and those of its textures that passes may use as their own: the last
/// version of the picture, and the depth.
struct WindowTarget
{
  GLuint Framebuffer = 0;
  std::unique_ptr<Texture> Color;
  std::unique_ptr<Texture> Depth;
  bool OwnDepth = false; ///< the frame needs depths of its own; Depth is only written for VTK
};

class FrameExecutor
{
public:
  FrameExecutor(ResourcePool& pool, ShaderLibrary& shaders, const View& view,
    vtkOpenGLRenderer* renderer, const WindowTarget& window, const HeldTextures& held,
    const std::string& viewName, Buffer& viewBlock);
  ~FrameExecutor();

  /// Run the graph. The textures that VTK keeps bound are bound at the beginning of each step and at the end. timer: told
  /// when each step is done; may be nullptr.
  void Run(const FrameGraph& graph, GpuTimer* timer);

private:
  friend class FrameContext;
  const Texture* Find(int version) const;
  bool IsWindow(int version) const;
  void UploadView();
  void Prepare(const FrameGraph::Step& step);
  void Retire(int position);

  ResourcePool& Pool;
  Commands CommandRunner;
  const View& CurrentView;
  vtkOpenGLRenderer* Renderer;
  vtkOpenGLState* State;
  const WindowTarget& Window;
  const HeldTextures& Held;
  std::string ViewName;
  const FrameGraph* Graph = nullptr;
  std::vector<Texture*> Lent; ///< by version
  VertexArrayHandle EmptyVertexArray;
  Buffer& ViewBlock; ///< stays bound for the props that VTK draws after the frame graph
};
}
