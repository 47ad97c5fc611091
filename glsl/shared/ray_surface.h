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
#define GI_RAY_SKY_UNIT 10       // radiance of the surroundings
#define GI_RAY_SKY_TABLE_UNIT 11 // chances to pick a direction to them
#define GI_RAY_ATTRIBUTE_UNIT 12 // one texel a triangle (or sphere, or cylinder)
#define GI_RAY_POINT_UNIT 13     // one texel a point, or a clipping plane
#define GI_RAY_SKY_CELLS_UNIT 15 // that radiance over cells of equal solid angles
#define GI_RAY_PICTURE_UNIT 14   // pictures, each after two texels of its shape

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
#define GI_SURFACE_FRONT_PICTURES 512 // pictures are not drawn on the back
#define GI_SURFACE_TANGENTS 1024      // the picture of normals counts

#define GI_RAY_NO_NORMAL 0u // in place of a point's normal: it has none, and its surface's own counts

#define GI_RAY_EDGE_SHIFT 29 // in the first point of an attribute

// Of a picture, in its first texel: x, y: size; z: these flags. The second is its border's colour.
#define GI_PICTURE_FLOATS 1      // a texel holds one pixel, not four of 8 bits a channel
#define GI_PICTURE_NEAREST 2
#define GI_PICTURE_SRGB 4
#define GI_PICTURE_WRAP_SHIFT 3  // as vtkTexture::Wrap
#define GI_PICTURE_CLAMP 0
#define GI_PICTURE_REPEAT 1
#define GI_PICTURE_MIRROR 2
#define GI_PICTURE_BORDER 3

struct RaySurface
{
  vec4 Color;    // rgb: diffuse reflectance or base colour; a: opacity
  vec4 Specular; // Phong: rgb reflectance, w power. PBR: rgb edge tint, w base F0
  vec4 Emission; // rgb: radiance; w: chance per area that an emitter sample picks a point here
  vec4 Factors;  // x, y: colour to reflectance, to emission; z: metallic; w: roughness
  ivec4 Where;   // x: first attribute; y: first point; z: flags; w: surface of the back or -1
  ivec4 Clip;    // x: first clipping plane, a texel of the points; y: how many
  // Where pictures begin, or -1: x: times a Phong material's colours, or PBR's base colour; y: PBR's
  // occlusion, roughness, metallic; z: normals; w: emission, times the material's.
  ivec4 Pictures;
  // x: picture that is the colour, as an integer's bits; y: scale of the picture of normals; z: share
  // of the picture of occlusion; w: opacity of edges
  vec4 More;
  vec4 Edge; // of cells: rgb colour; a: width in pixels, 0 for none
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
  /// Counted from the surface's first; in the first one's highest bits, the edges that are not a
  /// cell's.
  std::uint32_t Points[3];
  std::uint32_t Color;     ///< of the cell, RGBA8
};
struct RayPoint
{
  std::uint32_t Normal; ///< octahedral, two 16-bit unsigned normalized numbers
  std::uint32_t Color;  ///< RGBA8
  float TextureU;
  float TextureV;
};
static_assert(sizeof(RaySurface) == 9 * 16, "std430 layout");
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
#ifdef GI_RAY_PICTURES
layout(binding = GI_RAY_PICTURE_UNIT) uniform usamplerBuffer rayPictures;
#endif
#endif
