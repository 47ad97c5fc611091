// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Traces rays in the scene that penumbra::RayScene has bound. Coordinates are relative to the scene's
// origin, distances in units of the direction's length. Variants: GI_RAY_SPHERES, GI_RAY_CYLINDERS
// (the scene has some, see RayScene::ShaderDefines()).
//
// The loop is shaped for software GL, where each lane of a vector is a ray. Both
// sides of an if are executed, a store to a varying index of an array takes eight branches, and only a
// loop can end early, once its last lane is done. Nodes are therefore pushed and popped without conditions, and bounds
// are compared as integers, which need no handling of NaN.
#include "shared/ray_scene.h"
#include "rays/primitives.glsl"

#ifdef GI_RAY_TEXTURES
#define GI_RAY_TEXEL texelFetch
#else
#define GI_RAY_TEXEL imageLoad
#endif

const int GI_RAY_MOST_STEPS = 1 << 24; // leaves and instances that a ray visits

struct Ray
{
  vec3 origin;
  float tMin; // not below 0
  vec3 direction;
  float tMax;
};

struct RayHit
{
  float t;           // tMax where nothing is hit
  int instance;      // the instance's record, -1 if nothing is hit
  int primitive;     // the primitive's record
  vec2 barycentrics; // triangle: weights of its second and third vertex
};

vec4 rayNode(int texel)
{
  return uintBitsToFloat(GI_RAY_TEXEL(rayNodes, texel));
}
vec4 rayPrimitive(int texel)
{
  return uintBitsToFloat(GI_RAY_TEXEL(rayPrimitives, texel));
}
vec4 rayInstance(int texel)
{
  return uintBitsToFloat(GI_RAY_TEXEL(rayInstances, texel));
}

// 1 / direction, finite where a component is zero. A slab's faces are then far away on either side of the origin, since
// bounds are a little larger than their contents and the origin is never on a face that matters.
vec3 rayInverse(vec3 direction)
{
  const float tiny = 1e-30;
  return 1.0 / mix(direction, vec3(tiny), lessThan(abs(direction), vec3(tiny)));
}

RayHit rayTrace(Ray ray, const bool any)
{
  RayHit result = RayHit(ray.tMax, -1, -1, vec2(0.0));
  int nearest = floatBitsToInt(max(ray.tMin, 0.0));
  vec3 origin = ray.origin;
  vec3 inverse = rayInverse(ray.direction);
  vec3 direction = ray.direction;
  RayShear sheared = RayShear(0, vec3(0.0));
  int instance = -1;
  bool top = true;

  // The end mark is there twice, as lanes that are done still read the entry below it. With a single
  // mark, Mesa 26.1 with LLVM 21 compiles traversals of sticks that never end.
  int stack[GI_RAY_STACK];
  stack[0] = GI_RAY_DONE;
  stack[1] = GI_RAY_DONE;
  int size = 2;
  int current = int(GI_RAY_TEXEL(rayInstances, GI_RAY_INSTANCE_TEXELS - 1).x);

  // The count is never reached. Without it, the same compiler makes endless loops of some of DDGI's rays.
  for (int steps = 0; steps < GI_RAY_MOST_STEPS && current != GI_RAY_DONE; ++steps)
  {
    while (current >= 0)
    {
      int at = current * GI_RAY_NODE_TEXELS;
      vec4 lower0 = rayNode(at);
      vec4 upper0 = rayNode(at + 1);
      vec3 lower1 = rayNode(at + 2).xyz;
      vec3 upper1 = rayNode(at + 3).xyz;
      vec3 p0 = (lower0.xyz - origin) * inverse;
      vec3 q0 = (upper0.xyz - origin) * inverse;
      vec3 p1 = (lower1 - origin) * inverse;
      vec3 q1 = (upper1 - origin) * inverse;
      // Floats of equal sign compare like integers, and mixed signs do no harm: the
      // entry is never before `nearest`, and an exit before that is a miss whatever its value.
      ivec3 enter0 = min(floatBitsToInt(p0), floatBitsToInt(q0));
      ivec3 leave0 = max(floatBitsToInt(p0), floatBitsToInt(q0));
      ivec3 enter1 = min(floatBitsToInt(p1), floatBitsToInt(q1));
      ivec3 leave1 = max(floatBitsToInt(p1), floatBitsToInt(q1));
      int farthest = floatBitsToInt(result.t);
      int near0 = max(max(enter0.x, enter0.y), max(enter0.z, nearest));
      int near1 = max(max(enter1.x, enter1.y), max(enter1.z, nearest));
      // Ize 2013, "Robust BVH ray traversal" (JCGT 2:2): the computed exit may be too early by two units in the
      // last place, the entry too late by as much.
      int far0 = min(min(leave0.x, leave0.y), min(leave0.z, farthest)) + 4;
      int far1 = min(min(leave1.x, leave1.y), min(leave1.z, farthest)) + 4;
      bool hit0 = near0 <= far0;
      bool hit1 = near1 <= far1;
      bool first0 = hit0 && !(hit1 && near1 < near0);
      int child0 = floatBitsToInt(lower0.w);
      int child1 = floatBitsToInt(upper0.w);
      stack[size] = first0 ? child1 : child0;
      int popped = stack[size - 1];
      current = hit0 || hit1 ? (first0 ? child0 : child1) : popped;
      size += hit0 && hit1 ? 1 : (hit0 || hit1 ? 0 : -1);
    }

    // Intersect the records of a leaf of a mesh.
    bool leaf = !top && current > GI_RAY_LEAVE;
    int first = ~current >> GI_RAY_LEAF_SHIFT;
    int count = leaf ? (~current & (GI_RAY_LEAF_SIZE - 1)) + 1 : 0;
    for (int i = 0; i < count; ++i)
    {
      int at = (first + i) * GI_RAY_PRIMITIVE_TEXELS;
      vec4 a = rayPrimitive(at);
      vec4 b = rayPrimitive(at + 1);
      vec4 c = rayPrimitive(at + 2);
      vec3 hit = vec3(result.t, 0.0, 0.0);
      int kind = floatBitsToInt(b.w);
      bool closer = false;
#if defined(GI_RAY_SPHERES) || defined(GI_RAY_CYLINDERS)
      if (kind == GI_RAY_TRIANGLE)
#endif
      {
        closer = rayTriangle(origin, sheared, ray.tMin, a.xyz, b.xyz, c.xyz, hit);
      }
#ifdef GI_RAY_SPHERES
      if (kind == GI_RAY_SPHERE)
      {
        closer = raySphere(origin, direction, ray.tMin, a.xyz, c.w, hit);
      }
#endif
#ifdef GI_RAY_CYLINDERS
      if (kind >= GI_RAY_CYLINDER)
      {
        closer = rayCylinder(origin, direction, ray.tMin, a.xyz, b.xyz, c.w,
          kind == GI_RAY_CAPPED_CYLINDER, hit);
      }
#endif
      if (closer)
      {
        result = RayHit(hit.x, instance, first + i, hit.yz);
      }
    }

    bool enter = top && current != GI_RAY_DONE;
    bool leave = current == GI_RAY_LEAVE;
    if (enter)
    {
      instance = first + 1;
      int at = instance * GI_RAY_INSTANCE_TEXELS;
      vec4 x = rayInstance(at);
      vec4 y = rayInstance(at + 1);
      vec4 z = rayInstance(at + 2);
      origin = vec3(dot(x.xyz, ray.origin) + x.w, dot(y.xyz, ray.origin) + y.w,
        dot(z.xyz, ray.origin) + z.w);
      direction =
        vec3(dot(x.xyz, ray.direction), dot(y.xyz, ray.direction), dot(z.xyz, ray.direction));
      inverse = rayInverse(direction);
      sheared = rayShear(direction);
      top = false;
      stack[size] = GI_RAY_LEAVE;
      ++size;
      current = floatBitsToInt(rayInstance(at + 3).x);
    }
    else if (current != GI_RAY_DONE)
    {
      if (leave)
      {
        origin = ray.origin;
        inverse = rayInverse(ray.direction);
        top = true;
      }
      --size;
      current = stack[size];
    }
    if (any && result.instance >= 0)
    {
      current = GI_RAY_DONE;
    }
  }
  return result;
}

RayHit traceClosest(Ray ray)
{
  return rayTrace(ray, false);
}

// Whether anything lies between tMin and tMax.
bool traceAny(Ray ray)
{
  return rayTrace(ray, true).instance >= 0;
}

// The caller's numbers of the hit: x the instance, y RayInstance::User.
ivec2 rayHitInstance(RayHit hit)
{
  return floatBitsToInt(rayInstance(hit.instance * GI_RAY_INSTANCE_TEXELS + 3).yz);
}
int rayHitPrimitive(RayHit hit)
{
  return floatBitsToInt(rayPrimitive(hit.primitive * GI_RAY_PRIMITIVE_TEXELS).w);
}
