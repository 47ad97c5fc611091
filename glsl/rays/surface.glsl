// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// What a ray sees where it ends: position, normals and material, as VTK draws them. Needs
// rays/trace.glsl, shared/material.h, lib/octahedral.glsl. Variants: GI_RAY_CLIPPED (some surfaces
// have clipping planes), and those of rays/trace.glsl.
#include "shared/ray_surface.h"

struct RaySurfacePoint
{
  vec3 position;  // relative to the scene's origin
  float error;    // by how much it may be off
  vec3 geometric; // unit, to the side the ray comes from
  vec3 normal;    // unit, for shading
  bool front;     // seen from the side from which its corners run counter-clockwise
  vec4 color;     // diffuse reflectance or base colour; a: opacity
  vec3 emission;
  int surface;    // index of its material
  int primitive;
};

vec3 rayToMeshTransposed(int instance, vec3 v)
{
  int at = instance * GI_RAY_INSTANCE_TEXELS;
  return rayInstance(at).xyz * v.x + rayInstance(at + 1).xyz * v.y + rayInstance(at + 2).xyz * v.z;
}

vec3 rayPointNormal(uint bits)
{
  return giDecodeOctahedral(unpackUnorm2x16(bits));
}

// The surface in a colour that stands in place of the material's.
RaySurface rayColored(RaySurface surface, vec4 mapped)
{
  bool phong = (surface.Where.z & GI_SURFACE_MODEL) == GI_SURFACE_PHONG;
  surface.Color = vec4(mapped.rgb * (phong ? surface.Factors.x : 1.0), mapped.a * surface.Color.a);
  surface.Emission.rgb = phong ? mapped.rgb * surface.Factors.y : surface.Emission.rgb;
  return surface;
}

#ifdef GI_RAY_CLIPPED
// Whether a clipping plane takes this point of a surface away.
bool rayClipped(RaySurface surface, vec3 position)
{
  bool clipped = false;
  for (int i = 0; i < surface.Clip.y; ++i)
  {
    vec4 plane = uintBitsToFloat(texelFetch(rayPoints, surface.Clip.x + i));
    clipped = clipped || dot(plane.xyz, position) + plane.w < 0.0;
  }
  return clipped;
}
#endif

// The colours of a surface at a point of one of its primitives.
void rayColors(RaySurface surface, int primitive, vec2 barycentrics, out vec4 color, out vec3 emission)
{
  int flags = surface.Where.z;
  if ((flags & (GI_SURFACE_POINT_COLORS | GI_SURFACE_CELL_COLORS)) != 0)
  {
    uvec4 found = texelFetch(rayAttributes, surface.Where.x + primitive);
    vec4 mapped = unpackUnorm4x8(found.w);
    if ((flags & GI_SURFACE_POINT_COLORS) != 0)
    {
      ivec3 corner = surface.Where.y + ivec3(found.xyz);
      mapped = (1.0 - barycentrics.x - barycentrics.y) *
          unpackUnorm4x8(texelFetch(rayPoints, corner.x).y) +
        barycentrics.x * unpackUnorm4x8(texelFetch(rayPoints, corner.y).y) +
        barycentrics.y * unpackUnorm4x8(texelFetch(rayPoints, corner.z).y);
    }
    surface = rayColored(surface, mapped);
  }
  color = surface.Color;
  emission = surface.Emission.rgb;
  if ((flags & GI_SURFACE_MODEL) == GI_SURFACE_UNLIT)
  {
    emission = color.rgb;
    color.rgb = vec3(0.0);
  }
}

RaySurfacePoint raySurfaceAt(Ray ray, RayHit hit)
{
  RaySurfacePoint result;
  int record = hit.instance * GI_RAY_INSTANCE_TEXELS;
  vec4 x = rayInstance(record);
  vec4 y = rayInstance(record + 1);
  vec4 z = rayInstance(record + 2);
  int at = hit.primitive * GI_RAY_PRIMITIVE_TEXELS;
  vec4 a = rayPrimitive(at);
  vec4 b = rayPrimitive(at + 1);
  vec4 c = rayPrimitive(at + 2);
  result.primitive = floatBitsToInt(a.w);
  result.surface = rayHitInstance(hit).y;
  RaySurface surface = raySurfaces[result.surface];
  vec3 position = ray.origin + hit.t * ray.direction;
  vec3 there = vec3(dot(x.xyz, position) + x.w, dot(y.xyz, position) + y.w,
    dot(z.xyz, position) + z.w);
  vec3 mesh;         // the normal in the mesh
  float above = 0.0; // by how much the point is off the surface there
  vec3 extent = abs(a.xyz - there);
#if defined(GI_RAY_SPHERES) || defined(GI_RAY_CYLINDERS)
  int kind = floatBitsToInt(b.w);
  if (kind == GI_RAY_SPHERE)
  {
    above = length(there - a.xyz) - c.w;
    mesh = normalize(there - a.xyz);
  }
  else if (kind >= GI_RAY_CYLINDER)
  {
    vec3 axis = normalize(b.xyz - a.xyz);
    vec3 across = (there - a.xyz) - dot(there - a.xyz, axis) * axis;
    bool cap = hit.barycentrics.y > 0.5;
    above = cap ? 0.0 : length(across) - c.w;
    mesh = cap ? axis * (hit.barycentrics.x > 0.5 ? 1.0 : -1.0) : normalize(across);
  }
  else
#endif
  {
    vec3 edge1 = b.xyz - a.xyz;
    vec3 edge2 = c.xyz - a.xyz;
    mesh = normalize(cross(edge1, edge2));
    above = dot(there - a.xyz, mesh);
    extent = max(extent, max(abs(b.xyz - there), abs(c.xyz - there)));
  }
  // The distance along the ray has the error of the ray's length; one step of Newton's method brings
  // the point to the surface, so that what leaves there need not be moved far.
  vec3 outward = x.xyz * mesh.x + y.xyz * mesh.y + z.xyz * mesh.z;
  float scale = length(outward);
  result.position = position - outward * (above / (scale * scale));
  outward /= scale;
  vec3 size = max(abs(result.position), abs(there) / scale);
  // A large triangle is met imprecisely even by a ray that starts close to the coordinates' origin: on
  // squares seen there, 6e-8 of their size was too little and 1e-7 enough.
  result.error = 1e-6 * max(size.x, max(size.y, size.z)) +
    3e-7 / scale * max(extent.x, max(extent.y, extent.z));
  // A mirroring transformation turns the corners' order round, and their cross product with it.
  float mirrored = dot(cross(x.xyz, y.xyz), z.xyz) < 0.0 ? -1.0 : 1.0;
  result.front = dot(outward, ray.direction) * mirrored < 0.0;
  bool toward = dot(outward, ray.direction) < 0.0;
  result.geometric = toward ? outward : -outward;
  result.normal = result.geometric;
  if ((surface.Where.z & GI_SURFACE_SMOOTH) != 0)
  {
    ivec3 corner = surface.Where.y + ivec3(texelFetch(rayAttributes, surface.Where.x + result.primitive).xyz);
    vec3 smooth_ = (1.0 - hit.barycentrics.x - hit.barycentrics.y) *
        rayPointNormal(texelFetch(rayPoints, corner.x).x) +
      hit.barycentrics.x * rayPointNormal(texelFetch(rayPoints, corner.y).x) +
      hit.barycentrics.y * rayPointNormal(texelFetch(rayPoints, corner.z).x);
    vec3 n = x.xyz * smooth_.x + y.xyz * smooth_.y + z.xyz * smooth_.z;
    n = result.front ? n : -n;
    result.normal = dot(n, n) > 0.0 ? normalize(n) : result.geometric;
  }
  if (!result.front && surface.Where.w >= 0)
  {
    result.surface = surface.Where.w;
    surface = raySurfaces[result.surface];
  }
  if ((surface.Where.z & GI_SURFACE_PLACE_COLORS) != 0)
  {
    surface = rayColored(surface, unpackUnorm4x8(floatBitsToUint(rayInstance(record + 3).w)));
  }
  rayColors(surface, result.primitive, hit.barycentrics, result.color, result.emission);
  return result;
}

// Where a ray leaves a surface toward a side of it: far enough not to meet it again.
vec3 rayLeave(RaySurfacePoint at, vec3 direction)
{
  float side = dot(at.geometric, direction) >= 0.0 ? 1.0 : -1.0;
  return at.position + side * at.error * at.geometric;
}
