// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadow maps, each a square of one atlas, and their lights. Compiled as C++ and as GLSL.
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

// Arrangements of a light's maps.
#define GI_SHADOW_SINGLE 0
#define GI_SHADOW_CUBE 1     // six maps, in the order +x -x +y -y +z -z
#define GI_SHADOW_CASCADES 2 // nearest cascade first

struct ShadowMapData
{
  mat4 ViewToMap; // from view coordinates to atlas coordinates and depth, all in [0, 1], before division by w
  vec4 Area;      // the map's area in the atlas, between the centres of its outer texels: x0, y0, x1, y1
  vec4 Scale;     // x: width of a texel, at unit distance if the light is positional; y, z: distances from
                  // the light at depths 0 and 1
};

struct ShadowLightData
{
  vec4 Direction; // xyz: direction in which a directional light travels, in view coordinates
  vec4 Position;  // xyz: position of a positional light, in view coordinates; w: 1 if positional
  vec4 Ends;      // distances from the eye at which cascades end
  vec4 Size;      // x: radius of a positional light; tangent of half the angle of a directional one
  ivec4 Maps;     // x: first map; y: number of maps; z: GI_SHADOW_...
};

#ifdef __cplusplus
static_assert(sizeof(ShadowMapData) == 6 * 16, "std430 layout");
static_assert(sizeof(ShadowLightData) == 5 * 16, "std430 layout");
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
