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

// Where the depth is that VTK's next draws meet: in the window's buffer if passes write to it, otherwise in the texture
// that is presented later.
const Texture* ShownDepth(FrameContext& context)
{
  const Texture* buffer = context.Input(resource::Depth);
  const Texture* window = buffer->IsBorrowed() ? buffer : context.PresentedDepth();
  return window ? window : context.Input(resource::DepthCopy);
}

// Restore the depth of the first, unshifted frame, because what VTK draws next is not shifted either.
void RestoreDepth(FrameContext& context, const History& kept)
{
  const Texture* depth = ShownDepth(context);
  const bool keep = !kept.Written || context.GetView().StillFrames == 0;
  context.CopyDepth(keep ? depth : &kept.Storage, keep ? &kept.Storage : depth);
}
}

glm::dvec2 StillFrameJitter(int index)
{
  return index > 0 ? glm::dvec2(Halton(index, 2), Halton(index, 3)) - 0.5 : glm::dvec2(0.0);
}

void ShiftStillFrame(FrameBuilder& frame, int index)
{
  if (index > 0)
  {
    frame.SetJitter(StillFrameJitter(index));
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
