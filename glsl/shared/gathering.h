// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Points at which light is gathered, and what was found there. Compiled as C++ and as GLSL.
#ifdef __cplusplus
#pragma once
#include <glm/glm.hpp>
namespace penumbra
{
namespace shared
{
using vec4 = glm::vec4;
#endif

// Storage blocks; those of rays/query.comp, which never runs beside.
#define GI_GATHER_POINT_BINDING 4
#define GI_GATHER_RESULT_BINDING 5
#define GI_GATHER_GROUP 64

// Numbers of a result, each a sum over samples. First come those of light: of the whole sphere nine
// harmonics of three colours; of a hemisphere irradiance divided by pi, and where directions are asked for
// the mean of radiance, then its moments along x, y and z. After them:
#define GI_GATHER_BACKS 0    // rays that met the back of a surface
#define GI_GATHER_HITS 1     // rays that met any
#define GI_GATHER_DISTANCE 2 // of those, added up
#define GI_GATHER_SURROUNDINGS 3

// Numbers of a place on a surface that gathering/surfaces.comp finds: place, normal toward the line's beginning, how
// many surfaces the line meets.
#define GI_SURFACE_NUMBERS 7

struct GatherPoint
{
  vec4 Position; // xyz: relative to the scene's origin
  vec4 Normal;   // xyz: unit; zero for the whole sphere
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
