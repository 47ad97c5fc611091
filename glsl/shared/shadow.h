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

// Outlines of lights.
#define GI_OUTLINE_ROUND 0   // from all sides
#define GI_OUTLINE_ELLIPSE 1 // a disc, from the side
#define GI_OUTLINE_PARALLELOGRAM 2

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
  vec4 Size;      // x: radius of a positional light, or the longest of Side and Up; tangent of half the angle of a
                  // directional one; y: GI_OUTLINE_...
  vec4 Side;      // xyz: from a flat light's centre to its side, in units of Size.x, in view coordinates
  vec4 Up;
  ivec4 Maps;     // x: first map; y: number of maps; z: GI_SHADOW_...
};

#ifdef __cplusplus
static_assert(sizeof(ShadowMapData) == 6 * 16, "std430 layout");
static_assert(sizeof(ShadowLightData) == 7 * 16, "std430 layout");
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
