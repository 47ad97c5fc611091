// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// A light by VTK's definition, in view coordinates (for rays: relative to their scene's origin). Compiled as C++ and as
// GLSL.
#ifdef __cplusplus
#pragma once
#include <glm/glm.hpp>
namespace penumbra
{
namespace shared
{
using vec4 = glm::vec4;
using ivec4 = glm::ivec4;
#endif

// Kinds. HEADLIGHT is VTK's special case of a single headlight, lit along the view's z axis.
#define GI_LIGHT_HEADLIGHT 0
#define GI_LIGHT_DIRECTIONAL 1
#define GI_LIGHT_POSITIONAL 2

// Shapes, see vtkGILightShape.
#define GI_SHAPE_NONE 0 // a point, or the size that a technique gives to such lights
#define GI_SHAPE_POINT 1
#define GI_SHAPE_ANGLE 2 // only directional lights
#define GI_SHAPE_SPHERE 3 // this and the following: only positional lights
#define GI_SHAPE_DISC 4 // this and the following: flat
#define GI_SHAPE_RECTANGLE 5

struct LightData
{
  vec4 Color;       // rgb: intensity times colour; w: cosine of the cone angle, -2 for no cone
  vec4 Direction;   // xyz: direction in which the light travels; w: exponent of the cone's falloff
  vec4 Position;    // xyz: position, if positional
  vec4 Attenuation; // xyz: constant, linear and quadratic coefficient; w: area of a flat light / pi
  ivec4 Kind;       // x: kind; y: channel of the visibility mask or -1; z: 1 for a headlight;
                    // w: 1 if the light does not follow the camera
  vec4 Side;        // xyz: from the centre of a flat light to its side, or to a disc's rim; w: shape
  vec4 Up;          // xyz: the same, turned by a right angle; w: radius of a sphere, or 1 - cos of half an angle
};

#ifdef __cplusplus
static_assert(sizeof(LightData) == 7 * 16, "std430 layout");
}
}
#else
layout(std430, binding = 0) readonly buffer LightBlock
{
  LightData lights[];
};
#endif
