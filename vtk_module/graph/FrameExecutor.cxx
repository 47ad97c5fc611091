// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graph/FrameExecutor.h"

#include "gpu/ScopedState.h"

#include "view.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"

#include <stdexcept>

namespace penumbra
{
FrameExecutor::FrameExecutor(ResourcePool& pool, ShaderLibrary& shaders, const View& view,
  vtkOpenGLRenderer* renderer, const WindowTarget& window, const HeldTextures& held,
  const std::string& viewName, Buffer& viewBlock)
  : Pool(pool)
  , CommandRunner(shaders)
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
  this->CommandRunner.SetWindow(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
  this->UploadView();
}

FrameExecutor::~FrameExecutor()
{
  this->CommandRunner.Finish(); // also if a pass has thrown
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
  return entry.Resource == resource::Color && entry.IsFinal && this->Window.Color;
}

const Texture* FrameExecutor::Find(int version) const
{
  if (this->IsWindow(version))
  {
    return this->Window.Color.get();
  }
  const auto& entry = this->Graph->Versions()[version];
  if (entry.Resource == resource::Depth && this->Window.Depth && !this->Window.OwnDepth)
  {
    return this->Window.Depth.get();
  }
  return this->Lent[version];
}

void FrameExecutor::Prepare(const FrameGraph::Step& step)
{
  for (const auto& output : step.Outputs)
  {
    const auto& version = this->Graph->Versions()[output.second];
    if (version.Over != FrameGraph::None)
    {
      std::swap(this->Lent[output.second], this->Lent[version.Over]);
    }
    else if (!this->Find(output.second))
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
    this->Prepare(step);
    FrameContext context;
    context.Executor = this;
    context.Step = &step;
    this->Held.Restore(this->State);
    (*step.Action)(context);
    if (timer)
    {
      timer->Mark(step.Name, step.Owner);
    }
    for (History* history : step.Written)
    {
      history->Written = true;
    }
    this->Retire(position);
  }
  this->CommandRunner.Finish();
  // Shaders of shadow maps in props that VTK draws after the frame graph read it.
  this->ViewBlock.BindBase(GL_UNIFORM_BUFFER, GI_VIEW_BINDING);
  this->Held.Restore(this->State);
}

const View& FrameContext::GetView() const
{
  return this->Executor->CurrentView;
}

ShaderLibrary& FrameContext::Shaders() const
{
  return this->Executor->CommandRunner.Shaders();
}

vtkOpenGLState* FrameContext::State() const
{
  return this->Executor->State;
}

vtkOpenGLRenderer* FrameContext::Renderer() const
{
  return this->Executor->Renderer;
}

const Texture* FrameContext::PresentedDepth() const
{
  const WindowTarget& window = this->Executor->Window;
  return window.OwnDepth ? window.Depth.get() : nullptr;
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

std::vector<Attachment> FrameContext::Attachments(const std::vector<const char*>& outputs) const
{
  std::vector<Attachment> attachments;
  for (const char* output : outputs)
  {
    attachments.push_back({ output ? this->Output(output) : nullptr, -1 });
  }
  return attachments;
}

void FrameContext::BindTarget(const std::vector<const char*>& outputs, const char* depth) const
{
  Attachment attachment;
  if (depth)
  {
    const Texture* input = this->Input(depth);
    attachment.Target = input ? input : this->Output(depth);
  }
  this->BindTarget(this->Attachments(outputs), attachment);
}

void FrameContext::BindTarget(const std::vector<Attachment>& colors, const Attachment& depth) const
{
  Commands& commands = this->GetCommands();
  for (const Attachment& color : colors)
  {
    if (color.Target)
    {
      commands.BeforeUse(*color.Target, GL_FRAMEBUFFER_BARRIER_BIT);
    }
  }
  this->State()->vtkglBindFramebuffer(
    GL_FRAMEBUFFER, this->Executor->Pool.Framebuffer(colors, depth));
}

void FrameContext::CopyWindow(const char* output) const
{
  this->State()->PushFramebufferBindings();
  this->BindTarget({ output });
  this->State()->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->Executor->Window.Framebuffer);
  const glm::ivec4& area = this->GetView().Viewport;
  glBlitFramebuffer(area.x, area.y, area.x + area.z, area.y + area.w, area.x, area.y,
    area.x + area.z, area.y + area.w, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  this->State()->PopFramebufferBindings();
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

Commands& FrameContext::GetCommands() const
{
  return this->Executor->CommandRunner;
}

const Arguments& FrameContext::Offered() const
{
  if (!this->StepArguments)
  {
    Arguments& offered = this->StepArguments.emplace(this->Step->Offered);
    for (const auto& input : this->Step->InputSamplers)
    {
      offered.Sample(input.second, this->Input(input.first.c_str()));
    }
    for (const auto& output : this->Step->OutputImages)
    {
      offered.Image(output.second, *this->Output(output.first.c_str()), ShaderAccess::Write);
    }
    offered.Block("ViewBlock", this->Executor->ViewBlock);
  }
  return *this->StepArguments;
}

Defines FrameContext::Variant(const Defines& added) const
{
  Defines variant = this->Step->Variant;
  variant.insert(added.begin(), added.end());
  return variant;
}

const Texture& FrameContext::Keep(
  const std::string& name, const TextureDesc& desc, bool& fresh) const
{
  History& history = this->Executor->Pool.Keep(this->Executor->ViewName, name, desc);
  fresh = !history.Written;
  history.Written = true;
  return history.Storage;
}

void FrameContext::Use(const Program& program, const Arguments& given) const
{
  this->GetCommands().Use(program, given, this->Offered());
}

void FrameContext::Dispatch(
  const std::string& shader, const Defines& variant, const Arguments& given, const Work& work) const
{
  this->GetCommands().Dispatch(
    this->Shaders().Compute(shader, this->Variant(variant)), given, work, this->Offered());
}

void FrameContext::DrawBound(const std::string& shader, const Defines& variant,
  const Arguments& given, const Shape& shape) const
{
  const Defines defines = this->Variant(variant);
  this->Use(shape.Shader.empty() ? this->Shaders().Fragment(shader, defines)
                                 : this->Shaders().Raster(shape.Shader, shader, defines),
    given);
  glBindVertexArray(this->Executor->EmptyVertexArray.Get());
  glDrawArrays(GL_TRIANGLES, 0, shape.Vertices);
  glBindVertexArray(0);
}

void FrameContext::Draw(const std::string& shader, const Defines& variant, const Arguments& given,
  const Drawing& drawing) const
{
  ScopedState scope(this->State());
  std::vector<const char*> outputs;
  for (const std::string& output : this->Step->OutputOrder)
  {
    outputs.push_back(output.c_str());
  }
  this->BindTarget(outputs, drawing.CoveredOnly ? resource::Depth : nullptr);
  scope.Set(GL_BLEND, false);
  // The triangle lies at the far plane, so only pixels with a smaller depth pass.
  scope.Set(GL_DEPTH_TEST, drawing.CoveredOnly);
  scope.DepthFunc(GL_GREATER);
  scope.DepthMask(false);
  if (const auto* color = std::get_if<glm::vec4>(&drawing.Clear))
  {
    glClearBufferfv(GL_COLOR, 0, &(*color)[0]);
  }
  if (const auto* integers = std::get_if<glm::uvec4>(&drawing.Clear))
  {
    glClearBufferuiv(GL_COLOR, 0, &(*integers)[0]);
  }
  if (drawing.Stride > 1)
  {
    const glm::ivec4& area = this->GetView().Viewport;
    const glm::ivec2 low = glm::ivec2(area) / drawing.Stride;
    const glm::ivec2 high = (glm::ivec2(area.x + area.z, area.y + area.w) - 1) / drawing.Stride;
    scope.Viewport(low.x, low.y, high.x - low.x + 1, high.y - low.y + 1);
  }
  this->DrawBound(shader, variant, given);
}
}
