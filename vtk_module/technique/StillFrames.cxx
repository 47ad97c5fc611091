// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "technique/StillFrames.h"

#include "technique/FrameBuilder.h"

namespace penumbra
{
namespace
{
// The Halton sequence, which is evenly distributed for any number of frames.
double Halton(int index, int base)
{
  double result = 0.0;
  for (double digit = 1.0 / base; index > 0; index /= base, digit /= base)
  {
    result += digit * (index % base);
  }
  return result;
}

// Restore the depth of the first, unshifted frame, because what VTK draws next is not shifted either. It goes to the
// depth buffer if the window is drawn to directly, otherwise to the texture that is presented later.
void RestoreDepth(FrameContext& context, const History& kept)
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
  frame.AddLast([&kept](FrameBuilder& last) {
    last.AddPass("steady-depth")
      .Read(resource::Depth)
      .Read(resource::DepthCopy)
      .Read(resource::Color)
      .UpdateHistory(kept)
      .SideEffect()
      .Execute([&kept](FrameContext& context) { RestoreDepth(context, kept); });
  });
}
}
