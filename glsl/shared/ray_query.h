// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Ray queries and their answers in buffers, for picking, tests and benchmarks. Compiled as C++ and as
// GLSL.
#ifdef __cplusplus
#pragma once
#include <glm/glm.hpp>
namespace penumbra
{
namespace shared
{
using vec2 = glm::vec2;
using vec4 = glm::vec4;
using ivec2 = glm::ivec2;
#endif

#define GI_RAY_QUERY_BINDING 4
#define GI_RAY_ANSWER_BINDING 5
#define GI_RAY_QUERY_GROUP 64

struct RayQuery
{
  vec4 Origin;    // xyz: relative to the scene's origin; w: smallest distance
  vec4 Direction; // xyz: its length is the unit of distances; w: largest distance
};

struct RayAnswer
{
  ivec2 Hit;         // x: instance, -1 for none; y: primitive
  vec2 Barycentrics; // weights of the triangle's second and third vertex
  float Distance;
  int User;          // RayInstance::User of the instance that was hit
  ivec2 Unused;
};

#ifdef __cplusplus
static_assert(sizeof(RayQuery) == 2 * 16, "std430 layout");
static_assert(sizeof(RayAnswer) == 2 * 16, "std430 layout");
}
}
#else
layout(std430, binding = GI_RAY_QUERY_BINDING) readonly buffer RayQueryBlock
{
  RayQuery rayQueries[];
};
layout(std430, binding = GI_RAY_ANSWER_BINDING) writeonly buffer RayAnswerBlock
{
  RayAnswer rayAnswers[];
};
#endif
