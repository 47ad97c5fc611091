// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Material parameters that the G-buffer does not hold per pixel. Compiled as C++ and as GLSL.
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

// Reflection models. AS_DRAWN keeps VTK's own colour, for unlit primitives and for materials that the G-buffer cannot
// represent (anisotropy, clear coat). CATCHER has no colour of its own: the background shows, darkened by shadows.
#define GI_MATERIAL_AS_DRAWN 0
#define GI_MATERIAL_PHONG 1
#define GI_MATERIAL_PBR 2
#define GI_MATERIAL_CATCHER 4 // 3 is that of unlit surfaces for rays

// Flags of a material.
#define GI_MATERIAL_THIN 1 // lines and points, which rays do not hit
#define GI_MATERIAL_DATA 2 // coloured by data

struct MaterialData
{
  vec4 Specular; // Phong: rgb colour times coefficient, w power. PBR: rgb edge tint, w base F0
  ivec4 Model;   // x: reflection model; y: flags, see below;
                 // z: row of the motion table; w: persistent number of the prop, below 2^24
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
