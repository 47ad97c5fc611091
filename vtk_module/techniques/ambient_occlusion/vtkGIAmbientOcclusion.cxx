// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIAmbientOcclusion.h"

#include "gpu/ScopedState.h"
#include "technique/FrameBuilder.h"

#include "occlusion.h"

vtkStandardNewMacro(vtkGIAmbientOcclusion);

using namespace penumbra;

namespace
{
constexpr const char* Raw = "ambient-occlusion.raw";
constexpr const char* Places = "ambient-occlusion.depth";
constexpr const char* AlongRows = "ambient-occlusion.along-rows";
constexpr const char* Smoothed = "ambient-occlusion.smoothed";

enum Methods
{
  Horizon,
  Hemisphere
};

// Part of the scene's diagonal that the automatic radius takes. A wider one is hardly nearer to
// openness of any reach, as what is farther is often not on the screen.
constexpr double AutomaticRadius = 0.15;
// Part of it that things are deep.
constexpr double AutomaticThickness = 0.07;

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

// Of the samples of the horizon method, so many lie in one slice, half of them to each side: the
// filter averages slices over pixels, so that places along a slice are worth more than slices.
constexpr int SamplesPerSlice = 32;
// Of the places to one side, one in so many looks for the end of the highest thing.
constexpr int PlacesPerRefinement = 4;

struct Work
{
  Buffer* KernelBlock;
  double Radius;
  double Bias;
  double Thickness; ///< 0: unlimited
  int Method;
  int Samples;
  int Stride; ///< pixels of the window that a sampled one stands for, across and down
  bool Filter;
  bool Bent; ///< directions too

  // Binds the target, and draws to its part that the viewport covers.
  void Begin(FrameContext& context, ScopedState& scope, const char* output, int stride) const
  {
    scope.Set(GL_BLEND, false);
    scope.DepthMask(false);
    if (stride == 1)
    {
      // The triangle lies at the far plane: only pixels with something nearer are drawn.
      scope.Set(GL_DEPTH_TEST, true);
      scope.DepthFunc(GL_GREATER);
      context.BindTarget({ output }, resource::Depth);
      this->Clear(output);
      return;
    }
    scope.Set(GL_DEPTH_TEST, false);
    context.BindTarget({ output });
    const glm::ivec4& area = context.GetView().Viewport;
    const glm::ivec2 low = glm::ivec2(area) / stride;
    const glm::ivec2 high = (glm::ivec2(area.x + area.z, area.y + area.w) - 1) / stride;
    scope.Viewport(low.x, low.y, high.x - low.x + 1, high.y - low.y + 1);
  }

  // What is not drawn is on no surface: neighbours would else take for one what another frame left there.
  static void Clear(const char* output)
  {
    if (output == resource::AmbientVisibility)
    {
      constexpr GLfloat open[4] = { 1.0f, 0.5f, 0.5f, 0.5f };
      glClearBufferfv(GL_COLOR, 0, open);
      return;
    }
    const GLuint nowhere[4] = { glm::floatBitsToUint(
      1e30f) }; // a depth that is near no surface's plane
    glClearBufferuiv(GL_COLOR, 0, nowhere);
  }

  Defines Variant() const
  {
    Defines defines = { { "GI_STRIDE", std::to_string(this->Stride) } };
    if (this->Bent)
    {
      defines["GI_BENT"] = "1";
    }
    return defines;
  }

  const Program& Sampler(FrameContext& context) const
  {
    Defines defines = this->Variant();
    if (this->Method == Hemisphere)
    {
      defines["GI_SAMPLES"] = std::to_string(this->Samples);
      return context.Shaders().Fragment("ambient_occlusion/hemisphere.frag", defines);
    }
    if (this->Thickness > 0.0)
    {
      defines["GI_THICKNESS"] = "1";
    }
    return context.Shaders().Fragment("ambient_occlusion/horizon.frag", defines);
  }

  void CopyDepth(FrameContext& context) const
  {
    ScopedState scope(context.State());
    scope.Set(GL_BLEND, false);
    scope.Set(GL_DEPTH_TEST, false);
    scope.DepthMask(false);
    context.BindTarget({ Places });
    context.Use(context.Shaders().Fragment("ambient_occlusion/depth.frag"),
      { context.Input(resource::WindowDepth) });
    context.DrawFullscreen();
  }

  void Sample(FrameContext& context) const
  {
    ScopedState scope(context.State());
    this->Begin(context, scope, Raw, this->Stride);
    const Program& program = this->Sampler(context);
    context.Use(program, { context.Input(Places), context.Input(resource::Normal) });
    this->KernelBlock->BindBase(GL_UNIFORM_BUFFER, 1);
    const int slices = std::max(1, this->Samples / SamplesPerSlice);
    const int places = std::max(1, this->Samples / (2 * slices));
    const int refinements = places / PlacesPerRefinement;
    glUniform1i(program.Location("slices"), slices);
    glUniform1i(program.Location("steps"), places - refinements);
    glUniform1i(program.Location("refinements"), refinements);
    const double bias = this->Method == Hemisphere ? this->Bias * this->Radius : this->Bias;
    glUniform1f(program.Location("radius"), static_cast<GLfloat>(this->Radius));
    glUniform1f(program.Location("bias"), static_cast<GLfloat>(bias));
    glUniform1f(program.Location("thickness"), static_cast<GLfloat>(this->Thickness));
    context.DrawFullscreen();
  }

  void Smooth(FrameContext& context, const char* input, const char* output) const
  {
    ScopedState scope(context.State());
    this->Begin(context, scope, output, this->Stride);
    Defines defines = this->Variant();
    if (this->Filter)
    {
      defines["GI_AVERAGED"] = "1";
    }
    if (input != Raw)
    {
      defines["GI_DOWN"] = "1";
    }
    if (output != resource::AmbientVisibility)
    {
      defines["GI_PACKED"] = "1";
    }
    const Program& program = context.Shaders().Fragment("ambient_occlusion/filter.frag", defines);
    context.Use(program, { context.Input(input) });
    context.DrawFullscreen();
  }

  void Upsample(FrameContext& context) const
  {
    ScopedState scope(context.State());
    this->Begin(context, scope, resource::AmbientVisibility, 1);
    const Program& program =
      context.Shaders().Fragment("ambient_occlusion/upsample.frag", this->Variant());
    context.Use(program,
      { context.Input(Smoothed), context.Input(resource::WindowDepth),
        context.Input(resource::Normal) });
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

const char* vtkGIAmbientOcclusion::GetOfferedResource()
{
  return resource::AmbientVisibility;
}

void vtkGIAmbientOcclusion::Plan(LightingPlan& plan, FrameBuilder&)
{
  plan.SpreadLight(this->AmbientShare);
  plan.SetInterreflection(this->Interreflection);
}

void vtkGIAmbientOcclusion::Contribute(FrameBuilder& frame)
{
  // Occlusion further off is in indirect light that is known.
  const double radius = this->Radius > 0.0
    ? this->Radius
    : std::min(AutomaticRadius * frame.GetView().Diagonal, frame.Plan().IndirectDetail());
  if (radius <= 0.0)
  {
    return;
  }
  double thickness =
    this->Thickness > 0.0 ? this->Thickness : AutomaticThickness * frame.GetView().Diagonal;
  if (thickness >= 2.0 * radius)
  {
    thickness = 0.0; // as good as endless, at less cost
  }
  const int stride = this->Resolution == 0 ? 1 : 2;
  const bool bent =
    this->BentNormals && this->Method == Horizon && frame.Plan().KnowsLightAround();
  const Work work{ &this->Impl->KernelBlock, radius, this->Bias, thickness, this->Method,
    this->Samples, stride, this->Filter, bent };
  TextureDesc raw = frame.WindowTexture(bent ? GL_RGBA32UI : GL_RG32UI);
  raw.Width = (raw.Width + stride - 1) / stride;
  raw.Height = (raw.Height + stride - 1) / stride;
  frame.AddPass("ambient-occlusion-depth")
    .Read(resource::WindowDepth)
    .Write(Places, frame.WindowTexture(GL_R32F))
    .Execute([work](FrameContext& context) { work.CopyDepth(context); });
  frame.AddPass("ambient-occlusion")
    .Read(Places)
    .Read(resource::Depth)
    .Read(resource::WindowDepth)
    .Read(resource::Normal)
    .Write(Raw, raw)
    .Execute([this, work](FrameContext& context) {
      if (work.Method == Hemisphere && this->Impl->Samples != work.Samples)
      {
        const shared::OcclusionData kernel = MakeKernel(work.Samples);
        this->Impl->KernelBlock.Upload(GL_UNIFORM_BUFFER, &kernel, sizeof(kernel));
        this->Impl->Samples = work.Samples;
      }
      work.Sample(context);
    });
  const TextureDesc whole = frame.WindowTexture(bent ? GL_RGBA16 : GL_R16);
  const char* sampled = Raw;
  if (this->Filter)
  {
    frame.AddPass("ambient-occlusion-filter-rows")
      .Read(Raw)
      .Read(resource::Depth)
      .Write(AlongRows, raw)
      .Execute([work](FrameContext& context) { work.Smooth(context, Raw, AlongRows); });
    sampled = AlongRows;
  }
  const char* smoothed = stride > 1 ? Smoothed : resource::AmbientVisibility;
  frame.AddPass("ambient-occlusion-filter")
    .Read(sampled)
    .Read(resource::Depth)
    .Write(smoothed, stride > 1 ? raw : whole)
    .Execute([work, sampled, smoothed](
               FrameContext& context) { work.Smooth(context, sampled, smoothed); });
  if (stride > 1)
  {
    frame.AddPass("ambient-occlusion-upsample")
      .Read(Smoothed)
      .Read(resource::Depth)
      .Read(resource::WindowDepth)
      .Read(resource::Normal)
      .Write(resource::AmbientVisibility, whole)
      .Execute([work](FrameContext& context) { work.Upsample(context); });
  }
}
