// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// What a surface reflects beside what the G-buffer holds per pixel. Compiled as C++ and as GLSL.
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

// How light is reflected. AS_DRAWN takes VTK's own colour: unlit primitives, and materials whose
// reflection the G-buffer cannot hold (anisotropy, clear coat).
#define GI_MATERIAL_AS_DRAWN 0
#define GI_MATERIAL_PHONG 1
#define GI_MATERIAL_PBR 2

struct MaterialData
{
  vec4 Specular; // Phong: rgb colour times coefficient, w power. PBR: rgb edge tint, w base F0
  ivec4 Model;   // x: how light is reflected; y: 1 for lines and points, which rays do not meet;
                 // z: row of the table of motions; w: a number of the prop that stays, below 2^24
};

#ifdef __cplusplus
static_assert(sizeof(MaterialData) == 2 * 16, "std430 layout");
}
}
#else
layout(std430, binding = 1) readonly buffer MaterialBlock
{
  MaterialData materials[];
};
#endif
