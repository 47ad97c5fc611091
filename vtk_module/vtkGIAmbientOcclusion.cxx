// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIAmbientOcclusion.h"

#include "private/Frame.h"
#include "private/ScopedState.h"

#include "occlusion.h"

vtkStandardNewMacro(vtkGIAmbientOcclusion);

using namespace penumbra;

namespace
{
constexpr const char* Raw = "ambient-occlusion.raw";

// Part of the scene's diagonal that the automatic radius takes: wide enough to darken the folds of
// a surface, narrow enough to leave open what is seen as open.
constexpr double AutomaticRadius = 0.1;

// The van der Corput sequence in base 2.
double RadicalInverse(unsigned int i)
{
  double result = 0.0;
  for (double digit = 0.5; i; i >>= 1, digit *= 0.5)
  {
    result += digit * (i & 1);
  }
  return result;
}

// Directions spread as the cosine to the normal (z) weighs them, so that every sample counts
// alike; lengths grow quadratically, as near occluders hide more (Filion and McNaughton 2008).
shared::OcclusionData MakeKernel(int samples)
{
  shared::OcclusionData data;
  for (int i = 0; i < samples; ++i)
  {
    const double radius = std::sqrt((i + 0.5) / samples);
    const double turn = i * 2.39996323;
    const double t = RadicalInverse(static_cast<unsigned int>(i) + 1);
    const double length = 0.05 + 0.95 * t * t;
    data.Kernel[i] = glm::vec4(radius * std::cos(turn) * length, radius * std::sin(turn) * length,
      std::sqrt(1.0 - radius * radius) * length, length);
  }
  return data;
}

struct Work
{
  Buffer* KernelBlock;
  double Radius;
  int Samples;
  double Bias;
  bool Filter;

  void Begin(FrameContext& context, ScopedState& scope, const char* output) const
  {
    scope.Set(GL_BLEND, false);
    scope.Set(GL_DEPTH_TEST, true);
    scope.DepthFunc(GL_GREATER);
    scope.DepthMask(false);
    context.BindTarget({ output }, resource::Depth);
  }

  void Sample(FrameContext& context, const char* output) const
  {
    ScopedState scope(context.State());
    this->Begin(context, scope, output);
    const Program& program = context.Shaders().Fragment("ambient_occlusion/sample.frag",
      { { "GI_SAMPLES", std::to_string(this->Samples) } });
    context.Use(program,
      { context.Input(resource::WindowDepth), context.Input(resource::Normal) });
    this->KernelBlock->BindBase(GL_UNIFORM_BUFFER, 1);
    glUniform1f(program.Location("radius"), static_cast<GLfloat>(this->Radius));
    glUniform1f(program.Location("bias"), static_cast<GLfloat>(this->Bias * this->Radius));
    context.DrawFullscreen();
  }

  void Smooth(FrameContext& context) const
  {
    ScopedState scope(context.State());
    this->Begin(context, scope, resource::AmbientVisibility);
    const Program& program = context.Shaders().Fragment("ambient_occlusion/filter.frag");
    context.Use(program, { context.Input(Raw), context.Input(resource::Normal) });
    glUniform1f(program.Location("tolerance"), static_cast<GLfloat>(this->Radius * 0.1));
    context.DrawFullscreen();
  }
};
}

struct vtkGIAmbientOcclusion::Resources
{
  Buffer KernelBlock;
  int Samples = 0;
};

vtkGIAmbientOcclusion::vtkGIAmbientOcclusion()
  : Impl(new Resources)
{
}

vtkGIAmbientOcclusion::~vtkGIAmbientOcclusion() = default;

void vtkGIAmbientOcclusion::ReleaseGraphicsResources(vtkWindow*)
{
  *this->Impl = Resources();
}

void vtkGIAmbientOcclusion::Contribute(FrameBuilder& frame)
{
  frame.SpreadLight(this->AmbientShare);
  const double radius =
    this->Radius > 0.0 ? this->Radius : AutomaticRadius * frame.GetView().Diagonal;
  if (radius <= 0.0)
  {
    return;
  }
  const Work work{ &this->Impl->KernelBlock, radius, this->Samples, this->Bias, this->Filter };
  const char* sampled = this->Filter ? Raw : resource::AmbientVisibility;
  frame.AddPass("ambient-occlusion")
    .Read(resource::Depth)
    .Read(resource::WindowDepth)
    .Read(resource::Normal)
    .Write(sampled, frame.WindowTexture(this->Filter ? GL_RG32F : GL_R8))
    .Execute([this, work, sampled](FrameContext& context) {
      if (this->Impl->Samples != work.Samples)
      {
        const shared::OcclusionData kernel = MakeKernel(work.Samples);
        this->Impl->KernelBlock.Upload(GL_UNIFORM_BUFFER, &kernel, sizeof(kernel));
        this->Impl->Samples = work.Samples;
      }
      work.Sample(context, sampled);
    });
  if (this->Filter)
  {
    frame.AddPass("ambient-occlusion-filter")
      .Read(Raw)
      .Read(resource::Depth)
      .Read(resource::WindowDepth)
      .Read(resource::Normal)
      .Write(resource::AmbientVisibility, frame.WindowTexture(GL_R8))
      .Execute([work](FrameContext& context) { work.Smooth(context); });
  }
}
