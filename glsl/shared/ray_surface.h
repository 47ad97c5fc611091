// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Properties of the surfaces that rays hit: materials, attributes of primitives and points, emitters. Compiled
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
// Texture units.
#define GI_RAY_EMITTER_UNIT 8    // three texels per record of the tree of emitters
#define GI_RAY_SKY_UNIT 10       // radiance of the environment
#define GI_RAY_SKY_TABLE_UNIT 11 // cumulative probabilities to sample its directions
#define GI_RAY_ATTRIBUTE_UNIT 12 // one texel per triangle, sphere or cylinder
#define GI_RAY_POINT_UNIT 13     // one texel per point or clipping plane
#define GI_RAY_SKY_CELLS_UNIT 15 // radiance of the environment over cells of equal solid angle
#define GI_RAY_PICTURE_UNIT 14   // images, each preceded by two texels that describe it

// Flags of a surface. The lowest bits hold the reflection model, as GI_MATERIAL_...; unlit surfaces show their colour.
#define GI_SURFACE_PHONG 1
#define GI_SURFACE_PBR 2
#define GI_SURFACE_UNLIT 3
#define GI_SURFACE_MODEL 3
#define GI_SURFACE_SMOOTH 4          // point normals are interpolated
#define GI_SURFACE_POINT_COLORS 8    // points have colours that replace the material's
#define GI_SURFACE_CELL_COLORS 16    // cells have
#define GI_SURFACE_CULL_BACK 32      // back faces are not drawn
#define GI_SURFACE_CULL_FRONT 64     // front faces are not drawn
#define GI_SURFACE_PARTLY 128        // rays may pass: culled, translucent or clipped
#define GI_SURFACE_PLACE_COLORS 256  // instances have colours that replace the material's
#define GI_SURFACE_FRONT_PICTURES 512 // images are not drawn on back faces
#define GI_SURFACE_TANGENTS 1024      // the normal map applies

#define GI_RAY_NO_NORMAL 0u // marks a point without a normal, where the geometric normal applies

#define GI_RAY_EDGE_SHIFT 29 // position of the edge bits in RayAttribute::Points[0]

// The first texel of an image holds its size in x and y, and these flags in z. The second holds the border's colour.
#define GI_PICTURE_FLOATS 1      // a texel holds one pixel of floats, not four pixels of 8 bits per channel
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
  vec4 Emission; // rgb: radiance; w: density per area of a choice among points of all emitters by their power, 0 if not sampled
  vec4 Factors;  // x, y: factors from colour to reflectance and to emission; z: metallic; w: roughness
  ivec4 Where;   // x: first attribute; y: first point; z: flags; w: surface of the back faces or -1
  ivec4 Clip;    // x: first clipping plane, a texel of the points; y: number of planes; z: triangles per area of an emitter, as bits
  // First texels of images, or -1. x: factor of a Phong material's colours or of PBR's base colour; y: PBR's
  // occlusion, roughness and metallic; z: normal map; w: factor of the emission.
  ivec4 Pictures;
  // x: first texel of the image that replaces the colour, as an integer's bits; y: scale of the normal map; z: strength
  // of the occlusion map; w: opacity of edges
  vec4 More;
  vec4 Edge; // edges of cells: rgb colour; a: width in pixels, 0 for none
};

// A triangle that emits light, in scene coordinates; or, behind the triangles, four nodes of the tree above them, see
// penumbra::EmitterTree. Nodes have two numbers from 0 to 1, packed into 16 bits each, in B and in C.
struct RayEmitter
{
  vec4 A; // xyz: first corner; or the nodes' shares of the power of all emitters
  vec4 B; // xyz: second corner, w: surface, as bits; or x and y of the nodes' centres in the cube
  vec4 C; // xyz: third corner, w: primitive in the surface, as bits; or z, and radii in cube sides
};

#ifdef __cplusplus
/// Attributes of a triangle, sphere or cylinder.
struct RayAttribute
{
  /// Indices relative to the surface's first point. The highest bits of the first index mark edges that are not
  /// edges of a cell.
  std::uint32_t Points[3];
  std::uint32_t Color;     ///< the cell's colour, RGBA8
};
struct RayPoint
{
  std::uint32_t Normal; ///< octahedral, two 16-bit unsigned normalized numbers
  std::uint32_t Color;  ///< RGBA8
  float TextureU;
  float TextureV;
};
static_assert(sizeof(RaySurface) == 9 * 16, "std430 layout");
static_assert(sizeof(RayEmitter) == 3 * 16, "texels");
static_assert(sizeof(RayAttribute) == 16, "texel");
static_assert(sizeof(RayPoint) == 16, "texel");
}
}
#else
layout(std430, binding = GI_RAY_SURFACE_BINDING) readonly buffer RaySurfaceBlock
{
  RaySurface raySurfaces[];
};
layout(binding = GI_RAY_EMITTER_UNIT) uniform usamplerBuffer rayEmitters;
layout(binding = GI_RAY_ATTRIBUTE_UNIT) uniform usamplerBuffer rayAttributes;
layout(binding = GI_RAY_POINT_UNIT) uniform usamplerBuffer rayPoints;
#ifdef GI_RAY_PICTURES
layout(binding = GI_RAY_PICTURE_UNIT) uniform usamplerBuffer rayPictures;
#endif
#endif
