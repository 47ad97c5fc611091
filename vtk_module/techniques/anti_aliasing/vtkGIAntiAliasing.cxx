// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIAntiAliasing.h"

#include "capture/MaterialTable.h"
#include "capture/SceneCapture.h"
#include "rays/RayProps.h"
#include "technique/FrameBuilder.h"
#include "technique/StillFrames.h"

#include <algorithm>
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

// Values of Edges.
enum
{
  ByFrames,
  ByRays
};

// Places among the passes that modify the picture.
constexpr int AccumulateOrder = 800;
constexpr int EdgeFilterOrder = 810;

// Number of averaged frames from which the edge filter no longer improves the average.
constexpr int FramesToFilter = 3;

// Coverage by rays has its full weight up to the first number of averaged frames, and none from the second on.
constexpr double FullCoverageFrames = 3.5;
constexpr double NoCoverageFrames = 24.0;

// Weight of the coverage in the mean of a number of frames.
double CoverageWeight(int frames)
{
  return glm::clamp(
    (NoCoverageFrames / frames - 1.0) / (NoCoverageFrames / FullCoverageFrames - 1.0), 0.0, 1.0);
}

// Weight of a still frame in the mean while it is the last one. index: number of still frames before it. Until the frame with the
// opposite jitter follows, the full weight would shift the mean.
double LastWeight(int index)
{
  return index % 2 == 0 ? 1.0 : 0.5;
}

// Averages of a view. Each resource counts its own frames, because radiance may be requested later than the picture.
struct Sums
{
  std::map<std::string, int> Frames; ///< number summed since the scene changed, by resource
  std::map<std::string, int>
    CoverageFrames; ///< number at the last update of the differences at edges

  // Number of frames of a resource since the scene changed.
  int Of(const char* name) const
  {
    const auto found = this->Frames.find(name);
    return found != this->Frames.end() ? found->second : 0;
  }

  // Number of frames in the picture, and in the radiance if it is kept, before this one.
  int Shown(const View& view) const
  {
    const int color = view.StillFrames > 0 ? this->Of(resource::Color) : 0;
    return view.KeepsRadiance ? std::min(color, this->Of(resource::Radiance)) : color;
  }
};

// Add this frame to the sum of the previous frames, and show the average. blends: whether edge pixels are blended by their coverage.
void AddAverage(PassDeclaration& pass, FrameBuilder& frame, Sums& sums, const char* resource,
  int maximum, bool blends)
{
  History& sum = frame.Keep(std::string("sum.") + resource, frame.WindowTexture(GL_RGBA32F));
  pass.UpdateHistory(sum, "sums");
  if (blends)
  {
    pass.Read(resource::EdgeCoverage)
      .UpdateHistory(
        frame.Keep(std::string("edges.") + resource, frame.WindowTexture(GL_RGBA32F)), "edges");
  }
  pass.Execute([&sums, &sum, resource, maximum, blends](FrameContext& context) {
    const bool first = !sum.Written || context.GetView().StillFrames == 0;
    const bool frozen = !first && sums.Of(resource) >= maximum;
    int& frames = sums.Frames[resource];
    frames = first ? 1 : frozen ? frames : frames + 1;
    Defines variant = { { "GI_FIRST", first ? "1" : "0" }, { "GI_FROZEN", frozen ? "1" : "0" } };
    Arguments arguments =
      Arguments()
        .Set("frames", static_cast<double>(frames))
        .Set("lastWeight", frames >= maximum ? 1.0 : LastWeight(context.GetView().StillFrames));
    if (blends)
    {
      const bool goesOn = !first && sums.CoverageFrames[resource] == frames - 1;
      sums.CoverageFrames[resource] = frames;
      variant["GI_COVERAGE"] = "1";
      variant["GI_FIRST_COVERAGE"] = goesOn ? "0" : "1";
      arguments.Set("share", CoverageWeight(frames))
        .Set("display", resource == std::string(resource::Color));
    }
    context.Draw("anti_aliasing/accumulate.frag", variant, arguments);
  });
}

// Trace the coverage of edge pixels. index: number of still frames before this one.
void AddCoverage(FrameBuilder& frame, int index)
{
  RayProps& rays = frame.Rays("their edges are smoothed by still frames only");
  const View& view = frame.GetView();
  Defines variant = rays.ShaderDefines();
  if (frame.Lights().HasPositional())
  {
    variant["GI_POSITIONAL"] = "1";
  }
  frame.AddPass("edge-rays")
    .Read(resource::Albedo)
    .Read(resource::Normal)
    .Read(resource::DepthCopy)
    .Write(resource::EdgeCoverage, frame.WindowTexture(GL_RG32UI), "coverage")
    .ReadIfPresent(resource::DirectVisibility, "GI_DIRECT_VISIBILITY")
    .ReadIfPresent(resource::Irradiance, "GI_IRRADIANCE")
    .Offer(rays.ShaderArguments())
    .Offer(frame.Lights().InView(1.0 - frame.Plan().SpreadShare()))
    .Offer(frame.Capture().Materials().ShaderArguments())
    .Compute("anti_aliasing/coverage.comp", variant,
      view.ToScene(rays.Origin())
        .Set("jitter", glm::vec2(view.Jitter))
        .Set("turn", glm::vec2(StillFrameShift(index))),
      Work::Items(view.Viewport.z, view.Viewport.w));
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
    const Sums& sums = frame.ViewState<Sums>(this);
    const int frames = sums.Shown(frame.GetView());
    frame.SetAveragedFrames(frames < this->MaximumFrames ? frames + 1 : 0);
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
    const bool complete = sums.Shown(view) >= maximum;
    const int index = complete ? 0 : view.StillFrames;
    ShiftStillFrame(frame, StillFrameShift(index));
    const bool blends = this->Edges == ByRays && !complete && CoverageWeight(index + 1) > 0.0;
    if (blends)
    {
      AddCoverage(frame, index);
    }
    AddAverage(frame.AddPass("accumulate").Modify(resource::Color, AccumulateOrder), frame, sums,
      resource::Color, maximum, blends);
    if (view.KeepsRadiance)
    {
      AddAverage(
        frame.AddPass("accumulate-radiance").ModifyIfPresent(resource::Radiance, AccumulateOrder),
        frame, sums, resource::Radiance, maximum, blends);
    }
    if (frame.Plan().HasLitParts())
    {
      for (const char* part : { resource::LitShown, resource::LitEncoded })
      {
        AddAverage(frame.AddPass(std::string("accumulate-") + part)
                     .ModifyIfPresent(part, AccumulateOrder, "colorTexture"),
          frame, sums, part, maximum, blends);
      }
    }
    filter = view.StillFrames + 1 < FramesToFilter;
  }
  if (filter)
  {
    frame.AddPass("edge-filter")
      .Modify(resource::Color, EdgeFilterOrder)
      .ReadIfPresent(resource::EdgeCoverage, "GI_COVERAGE")
      .Draw("anti_aliasing/edge_filter.frag", {}, {});
  }
}
