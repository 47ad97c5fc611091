// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Transformations to the previous frame. Compiled as C++ and as GLSL.
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
  mat4 PreviousViewToClip; // of the previous frame, without jitter
  mat4 ToPrevious;         // from view coordinates to those of the previous frame
  vec4 PreviousShift;      // xy: jitter of the previous frame, in clip coordinates
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

// ToPrevious for static props, followed by the matrix of each prop that moves.
layout(std430, binding = 2) readonly buffer MotionBlock
{
  mat4 motions[];
};
#endif
