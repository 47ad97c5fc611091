// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIPathTracing.h"

#include "private/Frame.h"
#include "private/ScopedState.h"
#include "private/StillFrames.h"
#include "private/rays/RayProps.h"

vtkStandardNewMacro(vtkGIPathTracing);

using namespace penumbra;

vtkGIPathTracing::vtkGIPathTracing() = default;
vtkGIPathTracing::~vtkGIPathTracing() = default;

namespace
{
// Among the passes that modify the picture: before anti-aliasing.
constexpr int TraceOrder = 700;
constexpr const char* Traced = "path-tracing.traced"; // orders the passes that show the sums

constexpr std::array<const char*, 4> SumNames = { { "path-tracing.shown", "path-tracing.encoded",
  "path-tracing.albedo", "path-tracing.normal" } };

struct PathTracer
{
  RayProps* Rays;
  LightTable* Lights;
  int Samples;
  int Bounces;
  int Strategy;

  std::array<Texture*, 4> Sums(FrameContext& context) const
  {
    const View& view = context.GetView();
    std::array<Texture*, 4> sums = {};
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      bool fresh = false;
      sums[i] = &context.History(
        SumNames[i], { GL_RGBA32F, view.WindowSize.x, view.WindowSize.y, 0 }, fresh);
    }
    return sums;
  }

  void Trace(FrameContext& context) const
  {
    const View& view = context.GetView();
    const auto sums = this->Sums(context);
    for (GLuint unit = 0; unit < sums.size(); ++unit)
    {
      glBindImageTexture(unit, sums[unit]->Get(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    }
    Defines defines = this->Rays->ShaderDefines();
    const Program& program = context.Shaders().Compute("path_tracing/trace.comp", defines);
    context.Use(program,
      { context.Input(resource::Albedo), context.Input(resource::Normal),
        context.Input(resource::WindowDepth), context.Input(resource::Color) });
    this->Rays->Bind();
    this->Lights->BindWorld(0, this->Rays->Origin());
    const glm::mat3 rotation(glm::dmat3(view.ViewToWorld));
    const glm::vec3 eye(glm::dvec3(view.ViewToWorld[3]) - this->Rays->Origin());
    glUniformMatrix3fv(program.Location("viewToScene"), 1, GL_FALSE, &rotation[0][0]);
    glUniform3fv(program.Location("eye"), 1, &eye[0]);
    glUniform1i(program.Location("sampleIndex"), view.StillFrames);
    glUniform1i(program.Location("bounces"), this->Bounces);
    glUniform1i(program.Location("strategy"), this->Strategy);
    glUniform1i(program.Location("lightCount"), static_cast<GLint>(this->Lights->Lights().size()));
    glUniform1i(program.Location("emitterCount"), static_cast<GLint>(this->Rays->EmitterCount()));
    // Without lights VTK draws surfaces as flat colours, which look like lines to us: rays see them.
    constexpr float margin = 1e-3f;
    glUniform1f(program.Location("drawnReach"),
      this->Lights->Lights().empty() ? 1.0f + margin : 1.0f - margin);
    constexpr int group = 8;
    glDispatchCompute((view.Viewport.z + group - 1) / group, (view.Viewport.w + group - 1) / group, 1);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
  }

  void Show(FrameContext& context, const char* target) const
  {
    ScopedState scope(context.State());
    scope.Set(GL_BLEND, false);
    scope.Set(GL_DEPTH_TEST, false);
    scope.DepthMask(false);
    Defines defines;
    if (target == resource::Radiance)
    {
      defines["GI_RADIANCE"] = "1";
    }
    const auto sums = this->Sums(context);
    const Program& program = context.Shaders().Fragment("path_tracing/show.frag", defines);
    context.BindTarget({ target });
    context.Use(program, { sums[0], sums[1], context.Input(target) });
    glUniform1f(program.Location("samples"),
      static_cast<float>(std::min(context.GetView().StillFrames + 1, this->Samples)));
    context.DrawFullscreen();
  }
};
}

void vtkGIPathTracing::Contribute(FrameBuilder& frame)
{
  RayProps& rays = frame.Rays();
  const PathTracer tracer = { &rays, &frame.Lights(), this->Samples, this->Bounces, this->Strategy };
  if (rays.LeftOut() > 0)
  {
    frame.AddNote("rays do not see " + std::to_string(rays.LeftOut()) +
      " props of kinds that cannot be traced yet: they are drawn without global illumination");
  }
  ShiftStillFrame(frame, this->Samples);
  frame.SetAveraged();
  frame.SetDrawnByRays();
  const bool more = frame.GetView().StillFrames < this->Samples;
  frame.AddPass("path-trace")
    .Read(resource::Albedo)
    .Read(resource::Normal)
    .Read(resource::WindowDepth)
    .Modify(resource::Color, TraceOrder)
    .Write(Traced, { GL_R8, 1, 1, 0 })
    .Execute([tracer, more](FrameContext& context) {
      if (more)
      {
        tracer.Trace(context);
      }
      tracer.Show(context, resource::Color);
    });
  frame.AddPass("path-trace-radiance")
    .Read(Traced)
    .ModifyIfPresent(resource::Radiance, TraceOrder)
    .Execute([tracer](FrameContext& context) { tracer.Show(context, resource::Radiance); });
}
