// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// View parameters of a frame, one uniform block for all passes. Compiled as C++ and as GLSL.
#ifdef __cplusplus
#pragma once
#include <glm/glm.hpp>
namespace penumbra
{
namespace shared
{
using mat4 = glm::mat4;
using vec4 = glm::vec4;
using ivec4 = glm::ivec4;
#endif

#define GI_VIEW_BINDING 0

struct ViewData
{
  mat4 ViewToClip; // with this frame's jitter
  mat4 ClipToView;
  mat4 ViewToWorld; // rotation and translation; precise only near the camera
  vec4 Viewport;    // x, y, width, height in pixels of the window
  vec4 Scene;       // x: diagonal of the visible bounds; y: 1 for a parallel projection
  ivec4 Frame;      // x: index in the noise sequences; y: number of lights; z: frame number
};

#ifdef __cplusplus
static_assert(sizeof(ViewData) == 3 * 64 + 3 * 16, "std140 layout");
}
}
#else
layout(std140, binding = GI_VIEW_BINDING) uniform ViewBlock
{
  ViewData view;
};
#endif
