// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIAntiAliasing.h"

#include "private/Frame.h"
#include "private/ScopedState.h"
#include "private/StillFrames.h"

vtkStandardNewMacro(vtkGIAntiAliasing);

using namespace penumbra;

vtkGIAntiAliasing::vtkGIAntiAliasing() = default;
vtkGIAntiAliasing::~vtkGIAntiAliasing() = default;

namespace
{
enum Modes
{
  Auto,
  Off,
  Fxaa,
  Accumulate
};

// Places among the passes that modify the picture.
constexpr int AccumulateOrder = 800;
constexpr int EdgeFilterOrder = 810;

// Below this many averaged frames the edge filter still improves on the average.
constexpr int FramesToFilter = 8;

void DrawFilter(FrameContext& context, const Program& program, const char* resource)
{
  ScopedState scope(context.State());
  scope.Set(GL_BLEND, false);
  scope.Set(GL_DEPTH_TEST, false);
  scope.DepthMask(false);
  context.BindTarget({ resource });
  context.Use(program, { context.Input(resource) });
  context.DrawFullscreen();
}

// Add this frame to the sum of the frames before, and show the average.
void Average(FrameContext& context, const char* resource, int maximum)
{
  const View& view = context.GetView();
  bool fresh = false;
  Texture& sum = context.History((std::string("sum.") + resource).c_str(),
    { GL_RGBA32F, view.WindowSize.x, view.WindowSize.y, 0 }, fresh);
  const bool first = fresh || view.StillFrames == 0;
  const bool frozen = !first && view.StillFrames >= maximum;
  const Program& program = context.Shaders().Fragment("anti_aliasing/accumulate.frag",
    { { "GI_FIRST", first ? "1" : "0" }, { "GI_FROZEN", frozen ? "1" : "0" } });
  glProgramUniform1f(program.Get(), program.Location("frames"),
    frozen    ? maximum
      : first ? 1.0f
              : view.StillFrames + 1.0f);
  glBindImageTexture(0, sum.Get(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  DrawFilter(context, program, resource);
  glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}
}

void vtkGIAntiAliasing::Contribute(FrameBuilder& frame)
{
  const View& view = frame.GetView();
  const int mode = this->Mode != Auto ? this->Mode : view.WantsAntiAliasing ? Accumulate : Off;
  if (mode == Off || frame.IsAveraged())
  {
    return;
  }
  bool filter = true;
  if (mode == Accumulate)
  {
    const int maximum = this->MaximumFrames;
    const int still = frame.GetView().StillFrames;
    ShiftStillFrame(frame, still < maximum ? still : 0);
    frame.AddPass("accumulate")
      .Modify(resource::Color, AccumulateOrder)
      .Execute([maximum](FrameContext& context) { Average(context, resource::Color, maximum); });
    frame.AddPass("accumulate-radiance")
      .ModifyIfPresent(resource::Radiance, AccumulateOrder)
      .Execute([maximum](FrameContext& context) { Average(context, resource::Radiance, maximum); });
    filter = view.StillFrames + 1 < FramesToFilter;
  }
  if (filter)
  {
    frame.AddPass("edge-filter")
      .Modify(resource::Color, EdgeFilterOrder)
      .Execute([](FrameContext& context) {
        DrawFilter(
          context, context.Shaders().Fragment("anti_aliasing/edge_filter.frag"), resource::Color);
      });
  }
}
