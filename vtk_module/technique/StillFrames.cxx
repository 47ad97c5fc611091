// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "technique/StillFrames.h"

#include "technique/FrameBuilder.h"

namespace penumbra
{
namespace
{
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

glm::dvec2 StillFrameShift(int index)
{
  // Powers of the inverse of the plastic number, the real root of x^3 = x + 1.
  constexpr double inverse = 0.75487766624669276;
  const double step = index % 2 != 0 ? (index + 1) / 2 : -(index / 2);
  return glm::fract(step * glm::dvec2(inverse, inverse * inverse) + 0.5) - 0.5;
}

void ShiftStillFrame(FrameBuilder& frame, const glm::dvec2& pixels)
{
  frame.SetJitter(pixels);
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
