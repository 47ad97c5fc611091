// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "technique/StillFrames.h"

#include "technique/FrameBuilder.h"

namespace penumbra
{
namespace
{
// The Halton sequence: evenly spread however many frames there will be.
double Halton(int index, int base)
{
  double result = 0.0;
  for (double digit = 1.0 / base; index > 0; index /= base, digit /= base)
  {
    result += digit * (index % base);
  }
  return result;
}

// What VTK draws next is not shifted: give it the depth of the frame that was not shifted either.
// A window drawn to directly holds it in its depth buffer; another one is presented it later.
void SteadyDepth(FrameContext& context, const History& kept)
{
  const Texture* buffer = context.Input(resource::Depth);
  const Texture* depth = buffer->IsBorrowed() ? buffer : context.Input(resource::DepthCopy);
  const bool keep = !kept.Written || context.GetView().StillFrames == 0;
  context.CopyDepth(keep ? depth : &kept.Storage, keep ? &kept.Storage : depth);
}
}

void ShiftStillFrame(FrameBuilder& frame, int index)
{
  if (index > 0)
  {
    frame.SetJitter({ Halton(index, 2) - 0.5, Halton(index, 3) - 0.5 });
  }
  const GLenum format = frame.GetView().DepthFormat;
  History& kept = frame.Keep("depth", frame.WindowTexture(format ? format : GL_DEPTH_COMPONENT32F));
  frame.AddPass("steady-depth")
    .Read(resource::Depth)
    .Read(resource::DepthCopy)
    .Read(resource::Color)
    .UpdateHistory(kept)
    .SideEffect()
    .Execute([&kept](FrameContext& context) { SteadyDepth(context, kept); });
}
}
