// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIDenoising.h"

#include "gpu/ScopedState.h"
#include "technique/FrameBuilder.h"
#include "techniques/denoising/GuideNetwork.h"

#include "denoising.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkGIDenoising);

using namespace penumbra;

namespace
{
// Order among the passes that modify a noisy resource: after the mean over frames.
constexpr int Order = 600;

// Number of samples in still frames after which no pixel is filtered, see glsl/denoising/signal.glsl.
constexpr int LastSample = 64;
constexpr int LastSampleOfLight = 256;
constexpr int LastJointSample = 1024; // if the mean of still frames is the picture

// Order of the picture of a signal: after everything else.
constexpr int ShowOrder = 820;

constexpr const char* View = "denoising.view";

// Fit of light to normals.
constexpr const char* SlopeSums = "denoising.slope-sums";
constexpr const char* Slopes = "denoising.slopes";

/// Resources of a filter: what it filters, and two copies of that with the surfaces.
struct Names
{
  std::string Result;
  std::string Signal;
  std::string Next;
};

// A frame's own values, while the mean over frames guides their filter.
constexpr const char* Values = "denoising.values";
constexpr const char* NextValues = "denoising.values.next";

/// Textures of one level of the filter.
struct Buffers
{
  const Texture* Signal;
  const Texture* Values; ///< nullptr: those of the signal

  void Bind(const FrameContext& context) const
  {
    std::vector<Attachment> targets = { { this->Signal, -1 } };
    if (this->Values)
    {
      targets.push_back({ this->Values, -1 });
    }
    context.BindTarget(targets, {});
  }

  Arguments Samples(Arguments arguments) const
  {
    arguments.Sample("signalTexture", this->Signal);
    return this->Values ? arguments.Sample("values", this->Values) : arguments;
  }
};

// Values of the parameters "method" and "weights".
constexpr int NeuralMethod = 1;
constexpr int BufferWeights = 1;

// Value of the parameter "signal".
constexpr int LightSignal = 0;

// Values of the parameter "show".
enum
{
  Off,
  Raw,
  Filtered
};

struct Manner
{
  double Radius;
  int StillSamples; ///< number of earlier samples of each pixel in a mean of the picture
  int Sharing;      ///< number of pixels that share a sample
  std::string Kind; ///< variant of the shaders, see denoising/signal.glsl
  bool OwnSurface;  ///< whether the surfaces are not the frame's
  int Show = Off;   ///< what is to be shown of the signal
  GuideNetwork* Network = nullptr; ///< that guides the filter
  /// Whether the filter preserves variation of light with the normal. Without a network that increases the error of some scenes
  /// while the camera moves.
  bool FitsNormals = false;
  /// Resource that guides the filter of the frame's own values, see NoisyResource; nullptr: none.
  const char* Mean = nullptr;
};

void ShowSignal(
  FrameContext& context, const Texture* signal, const Manner& manner, const Defines& variant)
{
  context.BindTarget({ { context.Output(View), -1 } }, {});
  context.DrawBound("denoising/view.frag", variant,
    Arguments()
      .Sample("signalTexture", signal)
      .Set("show", manner.Show)
      .Set("radius", manner.Radius));
}

// Fit light to normals and concavities. Returns the derivatives.
const Texture* FitSlopes(FrameContext& context, const Texture* signal)
{
  const glm::ivec4& area = context.GetView().Viewport;
  const Work tiles = Work::Items((area.z + GI_DENOISING_TILE - 1) / GI_DENOISING_TILE,
    (area.w + GI_DENOISING_TILE - 1) / GI_DENOISING_TILE);
  context.Dispatch("denoising/slope_sums.comp", {},
    Arguments()
      .Sample("signalTexture", signal)
      .Image("sums", *context.Output(SlopeSums), ShaderAccess::Write),
    tiles);
  context.Dispatch("denoising/slopes.comp", {},
    Arguments()
      .Sample("sums", context.Output(SlopeSums))
      .Image("slopes", *context.Output(Slopes), ShaderAccess::Write),
    tiles);
  return context.Output(Slopes);
}

// layer: -1 for a result without layers.
void Filter(FrameContext& context, const Names& names, int layer, const Manner& manner)
{
  ScopedState scope(context.State());
  scope.Set(GL_BLEND, false);
  scope.Set(GL_DEPTH_TEST, false);
  const bool joint = manner.Mean != nullptr;
  const auto buffers = [&](const std::string& signal, const char* values) {
    return Buffers{ context.Output(signal.c_str()), joint ? context.Output(values) : nullptr };
  };
  Buffers current = buffers(names.Signal, Values);
  Buffers next = buffers(names.Next, NextValues);
  Defines variant = { { manner.Kind, "1" } };
  if (joint)
  {
    variant["GI_JOINT"] = "1";
  }
  if (manner.OwnSurface)
  {
    variant["GI_OWN_SURFACE"] = "1";
  }
  current.Bind(context);
  context.DrawBound("denoising/pack.frag", variant,
    Arguments()
      .Set("stillSamples", manner.StillSamples)
      .Set("radius", manner.Radius)
      .Set("layer", layer));
  const bool guided = manner.Network && manner.Network->Run(context, current.Signal);
  const Texture* slopes = manner.FitsNormals ? FitSlopes(context, current.Signal) : nullptr;
  if (guided)
  {
    variant["GI_GUIDED"] = "1";
  }
  if (slopes)
  {
    variant["GI_SLOPES"] = "1";
  }
  const bool shows = manner.Show != Off && layer <= 0;
  if (shows && manner.Show != Filtered)
  {
    ShowSignal(context, current.Signal, manner, variant);
  }
  for (int level = 0;
       (1 << level) < 2.0 * manner.Radius && !(guided && level >= GuideNetwork::Levels); ++level)
  {
    Arguments arguments =
      current.Samples(guided ? GuideNetwork::Guides(context, level) : Arguments());
    if (slopes)
    {
      arguments.Sample("slopes", slopes);
    }
    next.Bind(context);
    context.DrawBound("denoising/filter.frag", variant,
      arguments.Set("step", 1 << level)
        .Set("radius", manner.Radius)
        .Set("sharing", manner.Sharing));
    std::swap(current, next);
  }
  if (shows && manner.Show == Filtered)
  {
    ShowSignal(context, current.Signal, manner, variant);
  }
  context.BindTarget({ { context.Output(names.Result.c_str()), layer } }, {});
  context.DrawBound("denoising/unpack.frag", variant,
    current.Samples(Arguments()).Set("radius", manner.Radius).Set("layer", layer));
}

// A pass that filters a result, all its layers in turn.
void AddFilter(FrameBuilder& frame, const NoisyResource& noisy, const Manner& manner)
{
  const std::string signal = std::string("denoising.") + noisy.Name;
  const std::string next = signal + ".next";
  auto& pass = frame.AddPass(signal)
                 .ModifyIfPresent(noisy.Name, Order, "current")
                 .Write(signal, frame.WindowTexture(GL_RGBA32UI))
                 .Write(next, frame.WindowTexture(GL_RGBA32UI));
  if (noisy.Surface)
  {
    pass.Read(noisy.Surface);
  }
  else
  {
    pass.Read(resource::Albedo).Read(resource::Normal).Read(resource::DepthCopy);
  }
  if (noisy.Reach)
  {
    pass.Read(noisy.Reach);
  }
  if (manner.Mean)
  {
    pass.Read(manner.Mean)
      .Write(Values, frame.WindowTexture(GL_RGBA16F))
      .Write(NextValues, frame.WindowTexture(GL_RGBA16F));
  }
  if (manner.Network)
  {
    GuideNetwork::Declare(pass, frame);
  }
  if (manner.FitsNormals)
  {
    const glm::ivec2 tiles =
      (frame.GetView().WindowSize + GI_DENOISING_TILE - 1) / GI_DENOISING_TILE;
    pass.Write(SlopeSums, { GL_RGBA32F, tiles.x, tiles.y, 8 })
      .Write(Slopes, { GL_RGBA32F, tiles.x, tiles.y, 4 });
  }
  if (manner.Show != Off)
  {
    pass.ReadIfPresent(resource::Reprojection, "GI_REPROJECTED")
      .Write(View, frame.WindowTexture(GL_RGBA16F));
  }
  pass.Execute([name = noisy.Name, signal, next, manner](FrameContext& context) {
    const int layers = context.Output(name)->Desc().Layers;
    for (int layer = std::min(layers - 1, 0); layer < layers; ++layer)
    {
      Filter(context, { name, signal, next }, layer, manner);
    }
  });
  if (manner.Show != Off)
  {
    frame.AddPass("denoising-show")
      .Read(View, "colorTexture")
      .DrawOver(resource::Color, ShowOrder)
      .Draw("lib/copy_color.frag", {}, {});
  }
}
}

vtkGIDenoising::vtkGIDenoising() = default;
vtkGIDenoising::~vtkGIDenoising() = default;

void vtkGIDenoising::Plan(LightingPlan& plan, FrameBuilder&)
{
  if (this->Radius > 0.0)
  {
    plan.FilterNoise();
  }
}

void vtkGIDenoising::Contribute(FrameBuilder& frame)
{
  if (this->Radius > 0.0)
  {
    // Not every technique that writes visibility writes the reach of its noise.
    frame.AddLast([this](FrameBuilder& last) { this->AddFilters(last); });
  }
}

void vtkGIDenoising::AddFilters(FrameBuilder& frame)
{
  const int averaged = frame.AveragesStillFrames() ? frame.GetView().StillFrames : 0;
  // By the parameter "signal". Where paths draw the picture, other light is not seen.
  const std::string signals[] = { frame.Plan().IsDrawnByRays() ? resource::PathLight
                                                               : resource::TracedIrradiance,
    resource::DirectVisibility, resource::Reflection };
  for (const NoisyResource& noisy : resource::Noisy)
  {
    const int sharing = frame.PixelsPerSample(noisy.Name);
    const int shown = signals[this->Signal] == noisy.Name ? this->Show : Off;
    const char* mean = noisy.Mean && frame.IsWritten(noisy.Mean) ? noisy.Mean : nullptr;
    const int last = !noisy.Light            ? LastSample
      : mean && this->Method != NeuralMethod ? LastJointSample
                                             : LastSampleOfLight;
    const bool isNoisy = averaged / sharing < last;
    const bool filters = noisy.Light ? signals[LightSignal] == noisy.Name
                                     : noisy.Reach && frame.IsWritten(noisy.Reach);
    if ((isNoisy || shown != Off) && filters)
    {
      const char* kind = noisy.PerLight ? "GI_SHARES" : noisy.Light ? "GI_LIGHT" : "GI_LOBE";
      GuideNetwork* network = noisy.Light ? this->FindNetwork(frame) : nullptr;
      AddFilter(frame, noisy,
        { this->Radius, averaged / sharing, sharing, kind, noisy.Surface != nullptr, shown, network,
          noisy.Light && (noisy.Surface || network || frame.GetView().StillFrames > 0), mean });
    }
  }
}

GuideNetwork* vtkGIDenoising::FindNetwork(FrameBuilder& frame)
{
  if (this->Method != NeuralMethod)
  {
    return nullptr;
  }
  auto& network = frame.ViewState<GuideNetwork>(this);
  if (network.UsesBuffers != (this->Weights == BufferWeights))
  {
    network = GuideNetwork();
    network.UsesBuffers = this->Weights == BufferWeights;
  }
  if (!network.Failure.empty())
  {
    frame.AddNote("The denoiser's network does not run here, so light is filtered without it: " +
      network.Failure);
    return nullptr;
  }
  if (!network.HasRun)
  {
    frame.AddNote(
      "The denoiser's network was compiled in this frame, which takes some seconds once.");
  }
  return &network;
}
