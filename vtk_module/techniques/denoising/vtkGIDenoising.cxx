// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIDenoising.h"

#include "gpu/ScopedState.h"
#include "technique/FrameBuilder.h"

#include <utility>

vtkStandardNewMacro(vtkGIDenoising);

using namespace penumbra;

namespace
{
constexpr const char* Signal = "denoising.signal";
constexpr const char* Next = "denoising.next";

// Order among the passes that modify a noisy resource: after the mean over frames.
constexpr int Order = 600;

// Still frames after which no pixel is filtered, see glsl/denoising/signal.glsl.
constexpr int LastFrame = 64;

void Filter(FrameContext& context, const char* name, double radius)
{
  ScopedState scope(context.State());
  scope.Set(GL_BLEND, false);
  scope.Set(GL_DEPTH_TEST, false);
  const Texture* signal = context.Output(Signal);
  const Texture* next = context.Output(Next);
  context.BindTarget({ { signal, -1 } }, {});
  context.DrawBound("denoising/pack.frag", {},
    Arguments().Set("stillFrames", context.GetView().StillFrames));
  for (int step = 1; step < 2.0 * radius; step *= 2)
  {
    context.BindTarget({ { next, -1 } }, {});
    context.DrawBound("denoising/filter.frag", {},
      Arguments().Sample("signalTexture", signal).Set("step", step).Set("radius", radius));
    std::swap(signal, next);
  }
  context.BindTarget({ { context.Output(name), -1 } }, {});
  context.DrawBound("denoising/unpack.frag", {},
    Arguments().Sample("signalTexture", signal).Set("radius", radius));
}
}

vtkGIDenoising::vtkGIDenoising() = default;
vtkGIDenoising::~vtkGIDenoising() = default;

void vtkGIDenoising::Contribute(FrameBuilder& frame)
{
  if (this->Radius <= 0.0 || frame.GetView().StillFrames >= LastFrame)
  {
    return;
  }
  const char* name = resource::TracedIrradiance;
  frame.AddPass("denoising")
    .Read(resource::Albedo)
    .Read(resource::Normal)
    .Read(resource::DepthCopy)
    .ModifyIfPresent(name, Order, "current")
    .Write(Signal, frame.WindowTexture(GL_RGBA32UI))
    .Write(Next, frame.WindowTexture(GL_RGBA32UI))
    .Execute([name, radius = this->Radius](
               FrameContext& context) { Filter(context, name, radius); });
}
