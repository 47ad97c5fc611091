// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The interface through which a pass runs.
 */
#pragma once

#include "gpu/ResourcePool.h"
#include "gpu/ShaderLibrary.h"
#include "graph/FrameGraph.h"
#include "graph/Resources.h"
#include "graph/View.h"

#include <optional>

class vtkOpenGLRenderer;
class vtkOpenGLState;

namespace penumbra
{
/// Access of a running pass to its resources, and its means to draw and dispatch.
class FrameContext
{
public:
  const View& GetView() const;
  ShaderLibrary& Shaders() const;
  vtkOpenGLState* State() const;
  vtkOpenGLRenderer* Renderer() const;

  /// A texture that the pass declared; nullptr for an optional input that is absent.
  const Texture* Input(const char* resource) const;
  const Texture* Output(const char* resource) const;

  /// The window's depth texture, if the frame has depths of its own and direct light can present them there.
  const Texture* PresentedDepth() const;

  /// Bind outputs, and depth if named, as the target to draw to. Nothing is kept of an output that is nullptr.
  void BindTarget(const std::vector<const char*>& outputs, const char* depth = nullptr) const;
  void BindTarget(const std::vector<Attachment>& colors, const Attachment& depth) const;
  std::vector<Attachment> Attachments(const std::vector<const char*>& outputs) const;

  /// Make a program current with these arguments and the pass's declared ones, to draw geometry of the pass's own.
  void Use(const Program& program, const Arguments& given) const;

  /// Run a compute shader. variant: defines in addition to those of the resources that are present.
  void Dispatch(const std::string& shader, const Defines& variant, const Arguments& given,
    const Work& work) const;

  /// Draw one triangle over the viewport, at the far plane, with a fragment shader: to the pass's outputs,
  void Draw(const std::string& shader, const Defines& variant, const Arguments& given,
    const Drawing& drawing = {}) const;
  /// or to the bound target, in the current state; or another shape.
  void DrawBound(const std::string& shader, const Defines& variant, const Arguments& given,
    const Shape& shape = {}) const;

  /// Defines of the pass's shaders: those of the resources that are present, and the added ones.
  Defines Variant(const Defines& added = {}) const;
  Commands& GetCommands() const;

  /// As Frame::Keep(), for a history whose shape is known only when the pass runs. It counts as written. fresh: set to
  /// whether it was not written before.
  const Texture& Keep(const std::string& name, const TextureDesc& desc, bool& fresh) const;

  /// Copy the viewport's part of the window's colours to an output.
  void CopyWindow(const char* output) const;

  /// Copy the viewport's part of a depth texture to another of the same format.
  void CopyDepth(const Texture* from, const Texture* to) const;

private:
  friend class FrameExecutor;
  const Arguments& Offered() const;
  class FrameExecutor* Executor = nullptr;
  const FrameGraph::Step* Step = nullptr;
  mutable std::optional<Arguments> StepArguments; ///< of Offered(), after its first call
};
}
