// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Where things were in the frame before. Compiled as C++ and as GLSL.
#ifdef __cplusplus
#pragma once
#include <glm/glm.hpp>
namespace penumbra
{
namespace shared
{
using mat4 = glm::mat4;
using vec4 = glm::vec4;
#endif

struct MotionViewData
{
  mat4 ViewToClip;         // of this frame, without jitter
  mat4 PreviousViewToClip; // of the frame before, without jitter
  mat4 ToPrevious;         // from view coordinates to those of the frame before
  vec4 PreviousShift;      // xy: its jitter, in clip coordinates
};

#ifdef __cplusplus
static_assert(sizeof(MotionViewData) == 3 * 64 + 16, "std140 layout");
}
}
#else
layout(std140, binding = 1) uniform MotionViewBlock
{
  MotionViewData motion;
};

// As ToPrevious, for each prop that moves; the first is that.
layout(std430, binding = 2) readonly buffer MotionBlock
{
  mat4 motions[];
};
#endif
