// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a pass has at hand while it runs.
 */
#pragma once

#include "gpu/ResourcePool.h"
#include "gpu/ShaderLibrary.h"
#include "graph/FrameGraph.h"
#include "graph/Resources.h"
#include "graph/View.h"

class vtkOpenGLRenderer;
class vtkOpenGLState;

namespace penumbra
{
/// What a running pass has at hand.
class FrameContext
{
public:
  const View& GetView() const;
  ShaderLibrary& Shaders() const;
  vtkOpenGLState* State() const;
  vtkOpenGLRenderer* Renderer() const;

  /// A texture that the pass declared; nullptr for one it reads if present and that is absent.
  const Texture* Input(const char* resource) const;
  const Texture* Output(const char* resource) const;

  /// Bind outputs (and depth, if named) as the target to draw to. The final version of the
  /// picture binds VTK's own framebuffer.
  void BindTarget(const std::vector<const char*>& outputs, const char* depth = nullptr) const;
  void BindTarget(const std::vector<Attachment>& colors, const Attachment& depth) const;
  /// True where the output is drawn straight into VTK's framebuffer.
  bool IsWindow(const char* output) const;

  /// Make a program current and bind textures to its units, in order.
  void Use(const Program& program, const std::vector<const Texture*>& textures) const;

  /// Copy the viewport's part of a depth texture to another of the same format.
  void CopyDepth(const Texture* from, const Texture* to) const;

  /// One triangle over the viewport, at the far plane.
  void DrawFullscreen() const;

  /// A texture kept for this view from frame to frame. fresh: it was made or resized just now.
  Texture& History(const char* name, const TextureDesc& desc, bool& fresh) const;

private:
  friend class FrameExecutor;
  class FrameExecutor* Executor = nullptr;
  const FrameGraph::Step* Step = nullptr;
};
}
