// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// A shadow map and the light it belongs to. Compiled as C++ and as GLSL.
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

struct ShadowMapData
{
  mat4 ViewToMap; // view coordinates to the map's [0, 1] cube, before division
};

struct ShadowLightData
{
  vec4 Direction; // xyz: the way a directional light travels, view coordinates
  vec4 Position;  // xyz: of a positional light, view coordinates; w: 1 if positional
  vec4 Texel;     // x: width of a texel, at unit distance from a positional light; y: filter radius
  ivec4 Maps;     // x: first map; y: number of maps, 1 or 6
};

#ifdef __cplusplus
static_assert(sizeof(ShadowMapData) == 64, "std430 layout");
static_assert(sizeof(ShadowLightData) == 4 * 16, "std430 layout");
}
}
#else
layout(std430, binding = 2) readonly buffer ShadowMapBlock
{
  ShadowMapData shadowMaps[];
};
layout(std430, binding = 3) readonly buffer ShadowLightBlock
{
  ShadowLightData shadowLights[];
};
#endif
