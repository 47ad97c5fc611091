// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The acceleration structure that rays are traced in: two levels of binary trees over triangles, spheres and cylinders.
// Compiled as C++ and as GLSL. The shader reads these records as texels of buffers, not as storage blocks, because of
// software GL. It gathers a 16-byte texel in two instructions per lane but loads each float of a storage block in a
// branch of its own, and it allows 2 GiB per texture buffer but 128 MiB per storage block. Variant: GI_RAY_TEXTURES
// (the buffers are textures, which GPUs cache better, instead of images, which software GL reads faster).
#ifdef __cplusplus
#pragma once
#include <glm/glm.hpp>
#include <cstdint>
namespace penumbra
{
namespace shared
{
#endif

// Image units. Every OpenGL 4.3 implementation has eight.
#define GI_RAY_NODE_UNIT 5
#define GI_RAY_PRIMITIVE_UNIT 6
#define GI_RAY_INSTANCE_UNIT 7
// Texture units, past the 16 that other textures share. Every implementation has 96.
#define GI_RAY_NODE_TEXTURE 16
#define GI_RAY_PRIMITIVE_TEXTURE 17
#define GI_RAY_INSTANCE_TEXTURE 18

// Texels per record.
#define GI_RAY_NODE_TEXELS 4
#define GI_RAY_PRIMITIVE_TEXELS 3
#define GI_RAY_INSTANCE_TEXELS 4

// A child is a node (0 and up) or a leaf: ~(first record * 8 + number of records - 1). The records of a leaf in the top
// level are instances. Two values that no leaf has mark the ends of the levels on the stack.
#define GI_RAY_LEAF_SHIFT 3
#define GI_RAY_LEAF_SIZE 8
#define GI_RAY_DONE (-2147483647 - 1)
#define GI_RAY_LEAVE (-2147483647)

// Maximum depths of the trees. The shader's stack of GI_RAY_STACK entries holds one entry per level and three marks:
// two for the end, one between the levels. Variant: GI_RAY_SHALLOW (a short stack is enough, which halves the time on
// GPUs whose threads keep it in memory).
#define GI_RAY_MESH_DEPTH 40
#define GI_RAY_TOP_DEPTH 22
#define GI_RAY_MARKS 3
#define GI_RAY_SHORT_STACK 34
#ifdef GI_RAY_SHALLOW
#define GI_RAY_STACK GI_RAY_SHORT_STACK
#else
#define GI_RAY_STACK 65
#endif

#define GI_RAY_TRIANGLE 0
#define GI_RAY_SPHERE 1
#define GI_RAY_CYLINDER 2        // open at its ends
#define GI_RAY_CAPPED_CYLINDER 3

#ifdef __cplusplus
/// The bounds of two children, one cache line.
struct RayNode
{
  glm::vec3 Lower0;
  std::int32_t Child0;
  glm::vec3 Upper0;
  std::int32_t Child1;
  glm::vec3 Lower1;
  std::int32_t Unused0;
  glm::vec3 Upper1;
  std::int32_t Unused1;
};

/// Triangle: A, B, C. Sphere: centre A. Cylinder: axis from A to B.
struct RayPrimitive
{
  glm::vec3 A;
  std::int32_t Primitive; ///< index in the input geometry
  glm::vec3 B;
  std::int32_t Kind;
  glm::vec3 C;
  float Radius;
};

/// Record 0 holds the top level's root in Root and nothing else.
struct RayInstance
{
  glm::vec4 SceneToMesh[3]; ///< rows, from coordinates relative to the scene's origin
  std::int32_t Root;
  std::int32_t Instance; ///< index that hits report
  std::int32_t User;     ///< the caller's number: a material, a prop
  std::uint32_t Color;   ///< the instance's own colour, RGBA8
};
static_assert(sizeof(RayNode) == GI_RAY_NODE_TEXELS * 16, "texels");
static_assert(sizeof(RayPrimitive) == GI_RAY_PRIMITIVE_TEXELS * 16, "texels");
static_assert(sizeof(RayInstance) == GI_RAY_INSTANCE_TEXELS * 16, "texels");
}
}
#elif defined(GI_RAY_TEXTURES)
layout(binding = GI_RAY_NODE_TEXTURE) uniform usamplerBuffer rayNodes;
layout(binding = GI_RAY_PRIMITIVE_TEXTURE) uniform usamplerBuffer rayPrimitives;
layout(binding = GI_RAY_INSTANCE_TEXTURE) uniform usamplerBuffer rayInstances;
#else
layout(rgba32ui, binding = GI_RAY_NODE_UNIT) readonly uniform uimageBuffer rayNodes;
layout(rgba32ui, binding = GI_RAY_PRIMITIVE_UNIT) readonly uniform uimageBuffer rayPrimitives;
layout(rgba32ui, binding = GI_RAY_INSTANCE_UNIT) readonly uniform uimageBuffer rayInstances;
#endif
