// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIAntiAliasing.h"

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

// Number of averaged frames from which the edge filter no longer improves the average.
constexpr int FramesToFilter = 8;

// Averages of a view. Each resource counts its own frames, because radiance may be requested later than the picture.
struct Sums
{
  std::map<std::string, int> Frames; ///< number summed since the scene changed, by resource

  // Whether a resource has all its frames, so that further ones change nothing.
  bool IsComplete(const char* name, int maximum) const
  {
    const auto found = this->Frames.find(name);
    return found != this->Frames.end() && found->second >= maximum;
  }
};

// Add this frame to the sum of the previous frames, and show the average.
void AddAverage(
  PassDeclaration& pass, FrameBuilder& frame, Sums& sums, const char* resource, int maximum)
{
  History& sum = frame.Keep(std::string("sum.") + resource, frame.WindowTexture(GL_RGBA32F));
  pass.UpdateHistory(sum, "sums").Execute([&sums, &sum, resource, maximum](FrameContext& context) {
    const bool first = !sum.Written || context.GetView().StillFrames == 0;
    const bool frozen = !first && sums.IsComplete(resource, maximum);
    int& frames = sums.Frames[resource];
    frames = first ? 1 : frozen ? frames : frames + 1;
    context.Draw("anti_aliasing/accumulate.frag",
      { { "GI_FIRST", first ? "1" : "0" }, { "GI_FROZEN", frozen ? "1" : "0" } },
      Arguments().Set("frames", static_cast<double>(frames)));
  });
}
}

int vtkGIAntiAliasing::ModeIn(FrameBuilder& frame) const
{
  const bool wanted = frame.GetView().WantsAntiAliasing;
  return this->Mode != Auto ? this->Mode : wanted ? Accumulate : Off;
}

void vtkGIAntiAliasing::Plan(LightingPlan& plan, FrameBuilder& frame)
{
  if (this->ModeIn(frame) == Accumulate)
  {
    plan.KeepLitParts();
  }
}

void vtkGIAntiAliasing::Contribute(FrameBuilder& frame)
{
  const View& view = frame.GetView();
  const int mode = this->ModeIn(frame);
  if (mode == Off || frame.Plan().IsDrawnByRays())
  {
    return;
  }
  bool filter = true;
  if (mode == Accumulate)
  {
    const int maximum = this->MaximumFrames;
    frame.AverageStillFrames();
    Sums& sums = frame.ViewState<Sums>(this);
    const bool complete = sums.IsComplete(resource::Color, maximum) &&
      (!view.KeepsRadiance || sums.IsComplete(resource::Radiance, maximum));
    ShiftStillFrame(frame, StillFrameShift(complete ? 0 : view.StillFrames));
    AddAverage(frame.AddPass("accumulate").Modify(resource::Color, AccumulateOrder), frame, sums,
      resource::Color, maximum);
    if (view.KeepsRadiance)
    {
      AddAverage(
        frame.AddPass("accumulate-radiance").ModifyIfPresent(resource::Radiance, AccumulateOrder),
        frame, sums, resource::Radiance, maximum);
    }
    if (frame.Plan().HasLitParts())
    {
      for (const char* part : { resource::LitShown, resource::LitEncoded })
      {
        AddAverage(frame.AddPass(std::string("accumulate-") + part)
                     .ModifyIfPresent(part, AccumulateOrder, "colorTexture"),
          frame, sums, part, maximum);
      }
    }
    filter = view.StillFrames + 1 < FramesToFilter;
  }
  if (filter)
  {
    frame.AddPass("edge-filter")
      .Modify(resource::Color, EdgeFilterOrder)
      .Draw("anti_aliasing/edge_filter.frag", {}, {});
  }
}
