// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Sample offsets of the hemisphere. Compiled as C++ and as GLSL.
#ifdef __cplusplus
#pragma once
#include <glm/glm.hpp>
namespace penumbra
{
namespace shared
{
using vec4 = glm::vec4;
#endif

struct OcclusionData
{
  vec4 Kernel[256]; // xyz: offset in units of the radius, z along the normal; w: its length
};

#ifdef __cplusplus
static_assert(sizeof(OcclusionData) == 256 * 16, "std140 layout");
}
}
#else
layout(std140, binding = 1) uniform OcclusionBlock
{
  OcclusionData occlusion;
};
#endif
