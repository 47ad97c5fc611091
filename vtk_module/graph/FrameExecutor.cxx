// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graph/FrameExecutor.h"

#include "view.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"

#include <stdexcept>

namespace penumbra
{
FrameExecutor::FrameExecutor(ResourcePool& pool, ShaderLibrary& shaders, const View& view,
  vtkOpenGLRenderer* renderer, const WindowTarget& window, const HeldTextures& held,
  const std::string& viewName, Buffer& viewBlock)
  : Pool(pool)
  , Library(shaders)
  , CurrentView(view)
  , Renderer(renderer)
  , State(renderer->GetState())
  , Window(window)
  , Held(held)
  , ViewName(viewName)
  , ViewBlock(viewBlock)
{
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  this->EmptyVertexArray = VertexArrayHandle(name);
  this->UploadView();
}

FrameExecutor::~FrameExecutor()
{
  for (Texture* texture : this->Lent)
  {
    this->Pool.Release(texture);
  }
}

void FrameExecutor::UploadView()
{
  const View& view = this->CurrentView;
  shared::ViewData data;
  data.ViewToClip = glm::mat4(view.ViewToClip);
  data.ClipToView = glm::mat4(glm::inverse(view.ViewToClip));
  data.ViewToWorld = glm::mat4(view.ViewToWorld);
  data.Viewport = glm::vec4(view.Viewport);
  data.Scene = glm::vec4(view.Diagonal, view.Parallel ? 1.0 : 0.0, 0.0, 0.0);
  data.Frame = glm::ivec4(view.Sequence, 0, view.FrameNumber, 0);
  this->ViewBlock.Upload(GL_UNIFORM_BUFFER, &data, sizeof(data));
}

bool FrameExecutor::IsWindow(int version) const
{
  const auto& entry = this->Graph->Versions()[version];
  return entry.Resource == resource::Color && entry.IsFinal && this->Window.Direct;
}

const Texture* FrameExecutor::Find(int version) const
{
  const auto& entry = this->Graph->Versions()[version];
  if (entry.Resource == resource::Depth && this->Window.Depth)
  {
    return this->Window.Depth;
  }
  return this->Lent[version];
}

void FrameExecutor::Prepare(const FrameGraph::Step& step, int)
{
  for (const auto& output : step.Outputs)
  {
    const auto& version = this->Graph->Versions()[output.second];
    if (version.Over != FrameGraph::None)
    {
      std::swap(this->Lent[output.second], this->Lent[version.Over]);
    }
    else if (!this->Find(output.second) && !this->IsWindow(output.second))
    {
      this->Lent[output.second] = this->Pool.Acquire(version.Desc);
    }
  }
}

void FrameExecutor::Retire(int position)
{
  for (std::size_t version = 0; version < this->Lent.size(); ++version)
  {
    if (this->Lent[version] && this->Graph->Versions()[version].Last == position)
    {
      this->Pool.Release(this->Lent[version]);
      this->Lent[version] = nullptr;
    }
  }
}

void FrameExecutor::Run(const FrameGraph& graph, GpuTimer* timer)
{
  this->Graph = &graph;
  this->Lent.assign(graph.Versions().size(), nullptr);
  for (int position = 0; position < static_cast<int>(graph.Steps().size()); ++position)
  {
    const auto& step = graph.Steps()[position];
    this->Prepare(step, position);
    FrameContext context;
    context.Executor = this;
    context.Step = &step;
    this->Held.Restore(this->State);
    if (timer)
    {
      timer->Begin(step.Name);
    }
    (*step.Work)(context);
    if (timer)
    {
      timer->End();
    }
    this->Retire(position);
  }
  this->Held.Restore(this->State);
}

const View& FrameContext::GetView() const
{
  return this->Executor->CurrentView;
}

ShaderLibrary& FrameContext::Shaders() const
{
  return this->Executor->Library;
}

vtkOpenGLState* FrameContext::State() const
{
  return this->Executor->State;
}

vtkOpenGLRenderer* FrameContext::Renderer() const
{
  return this->Executor->Renderer;
}

const Texture* FrameContext::Input(const char* resource) const
{
  const auto found = this->Step->Inputs.find(resource);
  return found == this->Step->Inputs.end() ? nullptr : this->Executor->Find(found->second);
}

const Texture* FrameContext::Output(const char* resource) const
{
  const auto found = this->Step->Outputs.find(resource);
  if (found == this->Step->Outputs.end())
  {
    throw std::logic_error(
      "the pass '" + this->Step->Name + "' does not declare its output '" + resource + "'");
  }
  return this->Executor->Find(found->second);
}

bool FrameContext::IsWindow(const char* output) const
{
  const auto found = this->Step->Outputs.find(output);
  return found != this->Step->Outputs.end() && this->Executor->IsWindow(found->second);
}

void FrameContext::BindTarget(const std::vector<const char*>& outputs, const char* depth) const
{
  if (outputs.size() == 1 && this->IsWindow(outputs[0]))
  {
    this->State()->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Executor->Window.Framebuffer);
    return;
  }
  std::vector<Attachment> colors;
  for (const char* output : outputs)
  {
    colors.push_back({ this->Output(output), -1 });
  }
  Attachment depthAttachment;
  if (depth)
  {
    const Texture* input = this->Input(depth);
    depthAttachment.Target = input ? input : this->Output(depth);
  }
  this->BindTarget(colors, depthAttachment);
}

void FrameContext::BindTarget(const std::vector<Attachment>& colors, const Attachment& depth) const
{
  this->State()->vtkglBindFramebuffer(
    GL_FRAMEBUFFER, this->Executor->Pool.Framebuffer(colors, depth));
}

void FrameContext::CopyDepth(const Texture* from, const Texture* to) const
{
  ResourcePool& pool = this->Executor->Pool;
  const glm::ivec4& area = this->GetView().Viewport;
  this->State()->PushFramebufferBindings();
  this->State()->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, pool.Framebuffer({}, { from, -1 }));
  this->State()->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, pool.Framebuffer({}, { to, -1 }));
  glBlitFramebuffer(area.x, area.y, area.x + area.z, area.y + area.w, area.x, area.y,
    area.x + area.z, area.y + area.w, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  this->State()->PopFramebufferBindings();
}

void FrameContext::Use(const Program& program, const std::vector<const Texture*>& textures) const
{
  // VTK remembers the program it bound last: make it forget, as we bind ours past it.
  static_cast<vtkOpenGLRenderWindow*>(this->Renderer()->GetRenderWindow())
    ->GetShaderCache()
    ->ReleaseCurrentShader();
  glUseProgram(program.Get());
  for (std::size_t unit = 0; unit < textures.size(); ++unit)
  {
    if (textures[unit])
    {
      this->State()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
      glBindTexture(textures[unit]->Target(), textures[unit]->Get());
    }
  }
  this->Executor->ViewBlock.BindBase(GL_UNIFORM_BUFFER, 0);
}

void FrameContext::DrawFullscreen() const
{
  glBindVertexArray(this->Executor->EmptyVertexArray.Get());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

Texture& FrameContext::History(const char* name, const TextureDesc& desc, bool& fresh) const
{
  return this->Executor->Pool.History(this->Executor->ViewName, name, desc, fresh);
}
}
