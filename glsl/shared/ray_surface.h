// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// What a ray finds where it ends: materials, attributes of triangles and points, emitters. Compiled
// as C++ and as GLSL.
#ifdef __cplusplus
#pragma once
#include <glm/glm.hpp>
#include <cstdint>
namespace penumbra
{
namespace shared
{
using vec4 = glm::vec4;
using ivec4 = glm::ivec4;
#endif

#define GI_RAY_SURFACE_BINDING 6
#define GI_RAY_EMITTER_BINDING 7
// Texture units.
#define GI_RAY_ATTRIBUTE_UNIT 12 // one texel a triangle (or sphere, or cylinder)
#define GI_RAY_POINT_UNIT 13     // one texel a point, or a clipping plane
#define GI_RAY_TEXEL_UNIT 14     // four texels of pictures in one

// How a surface reflects, as GI_MATERIAL_..., in the lowest bits; unlit ones show their colour.
#define GI_SURFACE_PHONG 1
#define GI_SURFACE_PBR 2
#define GI_SURFACE_UNLIT 3
#define GI_SURFACE_MODEL 3
#define GI_SURFACE_SMOOTH 4          // normals of points are interpolated
#define GI_SURFACE_POINT_COLORS 8    // in place of the material's
#define GI_SURFACE_CELL_COLORS 16
#define GI_SURFACE_CULL_BACK 32      // not drawn where seen from behind
#define GI_SURFACE_CULL_FRONT 64
#define GI_SURFACE_PARTLY 128        // rays may pass: culled, translucent, clipped
#define GI_SURFACE_PLACE_COLORS 256  // each instance has its own, in place of the material's

struct RaySurface
{
  vec4 Color;    // rgb: diffuse reflectance or base colour; a: opacity
  vec4 Specular; // Phong: rgb reflectance, w power. PBR: rgb edge tint, w base F0
  vec4 Emission; // rgb: radiance; w: chance per area that an emitter sample picks a point here
  vec4 Factors;  // Phong: x, y: colour to reflectance, to emission. PBR: x metallic, y roughness
  ivec4 Where;   // x: first attribute; y: first point; z: flags; w: surface of the back or -1
  ivec4 Clip;    // x: first clipping plane, a texel of the points; y: how many
};

// A triangle that emits, in the scene's coordinates.
struct RayEmitter
{
  vec4 A; // w: chance that this or an earlier emitter is picked
  vec4 B; // w: surface, as bits
  vec4 C; // w: primitive within the surface, as bits
};

#ifdef __cplusplus
/// Attributes of a triangle, sphere or cylinder.
struct RayAttribute
{
  std::uint32_t Points[3]; ///< counted from the surface's first
  std::uint32_t Color;     ///< of the cell, RGBA8
};
struct RayPoint
{
  std::uint32_t Normal; ///< octahedral, two 16-bit unsigned normalized numbers
  std::uint32_t Color;  ///< RGBA8
  float TextureU;
  float TextureV;
};
static_assert(sizeof(RaySurface) == 6 * 16, "std430 layout");
static_assert(sizeof(RayEmitter) == 3 * 16, "std430 layout");
static_assert(sizeof(RayAttribute) == 16, "texel");
static_assert(sizeof(RayPoint) == 16, "texel");
}
}
#else
layout(std430, binding = GI_RAY_SURFACE_BINDING) readonly buffer RaySurfaceBlock
{
  RaySurface raySurfaces[];
};
layout(std430, binding = GI_RAY_EMITTER_BINDING) readonly buffer RayEmitterBlock
{
  RayEmitter rayEmitters[];
};
layout(binding = GI_RAY_ATTRIBUTE_UNIT) uniform usamplerBuffer rayAttributes;
layout(binding = GI_RAY_POINT_UNIT) uniform usamplerBuffer rayPoints;
#endif
