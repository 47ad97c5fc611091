// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Points at which light is gathered, and the results. Compiled as C++ and as GLSL.
#ifdef __cplusplus
#pragma once
#include <glm/glm.hpp>
namespace penumbra
{
namespace shared
{
using vec4 = glm::vec4;
#endif

// Bindings of the storage blocks. rays/query.comp, which never runs together with a gatherer, uses the same ones.
#define GI_GATHER_POINT_BINDING 4
#define GI_GATHER_RESULT_BINDING 5
#define GI_GATHER_GROUP 64

// A result is a list of sums over samples. Light comes first: for the whole sphere, nine harmonics of three colours;
// for a hemisphere, irradiance divided by pi and, in the directional variant, the mean radiance followed by its first
// moments along x, y and z. These numbers about the surroundings come after it:
#define GI_GATHER_BACKS 0    // rays that hit the back of a surface
#define GI_GATHER_HITS 1     // rays that hit any surface
#define GI_GATHER_DISTANCE 2 // sum of the hits' distances
#define GI_GATHER_SURROUNDINGS 3

// Numbers per result of gathering/surfaces.comp: position, normal toward the start of the line, and the number of
// surfaces that the line meets.
#define GI_SURFACE_NUMBERS 7

struct GatherPoint
{
  vec4 Position; // xyz: relative to the scene's origin
  vec4 Normal;   // xyz: unit vector; zero to gather over the whole sphere
};

#ifdef __cplusplus
static_assert(sizeof(GatherPoint) == 2 * 16, "std430 layout");
}
}
#else
layout(std430, binding = GI_GATHER_POINT_BINDING) readonly buffer GatherPointBlock
{
  GatherPoint gatherPoints[];
};
layout(std430, binding = GI_GATHER_RESULT_BINDING) writeonly buffer GatherResultBlock
{
  float gatherResults[];
};
#endif
