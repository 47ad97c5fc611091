// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIAntiAliasing.h"

#include "gpu/ScopedState.h"
#include "technique/FrameBuilder.h"
#include "technique/StillFrames.h"

#include <map>
#include <string>

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

// What is averaged in a view, by resource. Radiance may be asked for later than the picture.
struct Sums
{
  std::map<std::string, int> Frames; ///< summed since the scene changed

  // Whether the sum of a resource is whole, so that further frames change nothing.
  bool IsWhole(const char* name, int maximum) const
  {
    const auto found = this->Frames.find(name);
    return found != this->Frames.end() && found->second >= maximum;
  }
};

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
void Average(FrameContext& context, Sums& sums, const char* resource, int maximum)
{
  const View& view = context.GetView();
  bool fresh = false;
  Texture& sum = context.History((std::string("sum.") + resource).c_str(),
    { GL_RGBA32F, view.WindowSize.x, view.WindowSize.y, 0 }, fresh);
  const bool first = fresh || view.StillFrames == 0;
  const bool frozen = !first && sums.IsWhole(resource, maximum);
  int& frames = sums.Frames[resource];
  frames = first ? 1 : frozen ? frames : frames + 1;
  const Program& program = context.Shaders().Fragment("anti_aliasing/accumulate.frag",
    { { "GI_FIRST", first ? "1" : "0" }, { "GI_FROZEN", frozen ? "1" : "0" } });
  glProgramUniform1f(program.Get(), program.Location("frames"), static_cast<GLfloat>(frames));
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
  if (mode == Off || frame.Plan().IsDrawnByRays())
  {
    return;
  }
  bool filter = true;
  if (mode == Accumulate)
  {
    const int maximum = this->MaximumFrames;
    Sums& sums = frame.ViewState<Sums>(this);
    const bool whole = sums.IsWhole(resource::Color, maximum) &&
      (!view.KeepsRadiance || sums.IsWhole(resource::Radiance, maximum));
    ShiftStillFrame(frame, whole ? 0 : view.StillFrames);
    frame.AddPass("accumulate")
      .Modify(resource::Color, AccumulateOrder)
      .Execute([maximum, &sums](
                 FrameContext& context) { Average(context, sums, resource::Color, maximum); });
    frame.AddPass("accumulate-radiance")
      .ModifyIfPresent(resource::Radiance, AccumulateOrder)
      .Execute([maximum, &sums](
                 FrameContext& context) { Average(context, sums, resource::Radiance, maximum); });
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
