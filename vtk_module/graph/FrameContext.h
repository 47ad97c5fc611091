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

  /// Make a program current, with these arguments and what the pass declared, for drawing shapes of one's own.
  void Use(const Program& program, const Arguments& given) const;

  /// Run a compute shader. Its variant is that of the resources that are present, and what is added here.
  void Dispatch(const std::string& shader, const Defines& variant, const Arguments& given,
    const Work& work) const;

  /// Draw one triangle over the viewport, at the far plane, by a fragment shader: to the pass's outputs,
  void Draw(const std::string& shader, const Defines& variant, const Arguments& given,
    const Drawing& drawing = {}) const;
  /// or to what is bound, in whatever state.
  void DrawBound(
    const std::string& shader, const Defines& variant, const Arguments& given) const;

  /// What the pass's shaders are compiled with for the resources that are present, and what is added.
  Defines Variant(const Defines& added = {}) const;
  Commands& GetCommands() const;

  /// As Frame::Keep(), for what has a shape that is known only when the pass runs. It counts as written.
  const Texture& Keep(const std::string& name, const TextureDesc& desc, bool& fresh) const;

  /// Copy the viewport's part of a depth texture to another of the same format.
  void CopyDepth(const Texture* from, const Texture* to) const;

private:
  friend class FrameExecutor;
  Arguments Offered() const;
  class FrameExecutor* Executor = nullptr;
  const FrameGraph::Step* Step = nullptr;
};
}
