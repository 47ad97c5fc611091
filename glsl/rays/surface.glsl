// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Position, normals and material of the surface that a ray hits, as VTK draws them. Needs
// rays/trace.glsl, lib/octahedral.glsl. Variants: GI_RAY_CLIPPED (some surfaces
// have clipping planes), GI_RAY_PICTURES (some have images), and those of rays/trace.glsl.
#include "shared/ray_surface.h"
#ifdef GI_RAY_PICTURES
#include "rays/pictures.glsl"
#endif

uniform float giReflectance; // factor of all diffuse reflectances and base colours

struct RaySurfacePoint
{
  vec3 position;  // relative to the scene's origin
  float error;    // bound on the position's error
  vec3 geometric; // unit geometric normal on the side that the ray comes from
  vec3 normal;    // unit shading normal
  bool front;     // whether the ray hits the side on which the corners run counter-clockwise
  vec4 color;     // diffuse reflectance or base colour; a: opacity
  vec3 emission;
  vec4 specular;  // as RaySurface::Specular
  float metallic;
  float roughness;
  float occlusion; // ambient occlusion factor of a PBR material
  int surface;     // index of its RaySurface
  vec3 bulge;      // offset from the flat triangle to the curved surface that the point normals represent
  float bend;      // sine of the largest angle between the point normals and the triangle's normal
  int primitive;
};

// Normal of a point, zero if it has none.
vec3 rayPointNormal(uint bits)
{
  return bits == GI_RAY_NO_NORMAL ? vec3(0.0) : giDecodeOctahedral(unpackUnorm2x16(bits));
}

// Whether colours from data replace the material's colour.
bool rayColoredByData(RaySurface surface)
{
  return (surface.Where.z & (GI_SURFACE_POINT_COLORS | GI_SURFACE_CELL_COLORS | GI_SURFACE_PLACE_COLORS)) != 0 ||
    floatBitsToInt(surface.More.x) >= 0;
}

// Replaces the material's colour by a mapped one.
RaySurface rayColored(RaySurface surface, vec4 mapped)
{
  bool phong = (surface.Where.z & GI_SURFACE_MODEL) == GI_SURFACE_PHONG;
  surface.Color = vec4(mapped.rgb * surface.Factors.x, mapped.a * surface.Color.a);
  surface.Emission.rgb = phong ? mapped.rgb * surface.Factors.y : surface.Emission.rgb;
  return surface;
}

#ifdef GI_RAY_CLIPPED
// Whether a clipping plane removes this point of a surface.
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

ivec3 rayCorners(RaySurface surface, int primitive)
{
  uvec3 points = texelFetch(rayAttributes, surface.Where.x + primitive).xyz;
  points.x &= (1u << GI_RAY_EDGE_SHIFT) - 1u;
  return surface.Where.y + ivec3(points);
}

vec2 rayTextureCoordinates(ivec3 corner, vec2 barycentrics)
{
  vec2 a = uintBitsToFloat(texelFetch(rayPoints, corner.x).zw);
  vec2 b = uintBitsToFloat(texelFetch(rayPoints, corner.y).zw);
  vec2 c = uintBitsToFloat(texelFetch(rayPoints, corner.z).zw);
  return (1.0 - barycentrics.x - barycentrics.y) * a + barycentrics.x * b + barycentrics.y * c;
}

#ifdef GI_RAY_PICTURES
// Applies a material's images at these texture coordinates. occlusion: as RaySurfacePoint::occlusion.
RaySurface rayPictured(RaySurface surface, vec2 uv, bool front, out float occlusion)
{
  occlusion = 1.0;
  int model = surface.Where.z & GI_SURFACE_MODEL;
  int colors = floatBitsToInt(surface.More.x);
  if (colors >= 0)
  {
    surface = rayColored(surface, rayPicture(colors, uv));
  }
  if (surface.Pictures.x >= 0 && (front || (surface.Where.z & GI_SURFACE_FRONT_PICTURES) == 0))
  {
    vec4 base = rayPicture(surface.Pictures.x, uv);
    surface.Color *= base;
    // For Phong materials VTK multiplies all outgoing light by the texture.
    surface.Specular.rgb *= model == GI_SURFACE_PBR ? vec3(1.0) : base.rgb;
    surface.Emission.rgb *= model == GI_SURFACE_PBR ? vec3(1.0) : base.rgb;
  }
  if (surface.Pictures.y >= 0)
  {
    vec4 material = rayPicture(surface.Pictures.y, uv);
    surface.Factors.zw *= material.bg;
    occlusion = mix(1.0, material.r, surface.More.z);
  }
  if (surface.Pictures.w >= 0)
  {
    surface.Emission.rgb *= rayPicture(surface.Pictures.w, uv).rgb;
  }
  return surface;
}

// Shading normal with the normal map applied. Tangents follow the image's first axis and have no handedness, as those
// of vtkPolyDataTangents.
vec3 rayBentNormal(RaySurface surface, ivec3 corner, vec2 uv, vec3 edge1, vec3 edge2, mat3 toScene, vec3 N)
{
  vec2 a = uintBitsToFloat(texelFetch(rayPoints, corner.x).zw);
  vec2 b = uintBitsToFloat(texelFetch(rayPoints, corner.y).zw) - a;
  vec2 c = uintBitsToFloat(texelFetch(rayPoints, corner.z).zw) - a;
  float area = b.x * c.y - c.x * b.y;
  vec3 T = toScene * ((c.y * edge1 - b.y * edge2) * (area < 0.0 ? -1.0 : 1.0));
  T -= dot(T, N) * N;
  vec3 bent = rayPicture(surface.Pictures.z, uv).xyz * 2.0 - 1.0;
  bent.xy *= surface.More.y;
  if (dot(T, T) <= 0.0 || dot(bent, bent) <= 0.0)
  {
    return N;
  }
  T = normalize(T);
  return normalize(mat3(T, cross(N, T), N) * bent);
}
#endif

// Material at a point of a primitive. occlusion: as RaySurfacePoint::occlusion.
RaySurface rayMaterial(
  RaySurface surface, int primitive, vec2 barycentrics, bool front, out float occlusion)
{
  int flags = surface.Where.z;
  occlusion = 1.0;
  if ((flags & (GI_SURFACE_POINT_COLORS | GI_SURFACE_CELL_COLORS)) != 0)
  {
    uvec4 attributes = texelFetch(rayAttributes, surface.Where.x + primitive);
    vec4 mapped = unpackUnorm4x8(attributes.w);
    if ((flags & GI_SURFACE_POINT_COLORS) != 0)
    {
      ivec3 corner = rayCorners(surface, primitive);
      mapped = (1.0 - barycentrics.x - barycentrics.y) *
          unpackUnorm4x8(texelFetch(rayPoints, corner.x).y) +
        barycentrics.x * unpackUnorm4x8(texelFetch(rayPoints, corner.y).y) +
        barycentrics.y * unpackUnorm4x8(texelFetch(rayPoints, corner.z).y);
    }
    surface = rayColored(surface, mapped);
  }
#ifdef GI_RAY_PICTURES
  if (any(greaterThanEqual(surface.Pictures, ivec4(0))) || floatBitsToInt(surface.More.x) >= 0)
  {
    vec2 uv = rayTextureCoordinates(rayCorners(surface, primitive), barycentrics);
    surface = rayPictured(surface, uv, front, occlusion);
  }
#endif
  if ((flags & GI_SURFACE_MODEL) == GI_SURFACE_UNLIT)
  {
    surface.Emission.rgb = surface.Color.rgb;
    surface.Color.rgb = vec3(0.0);
  }
  surface.Color.rgb *= giReflectance;
  return surface;
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
  vec3 meshPosition = vec3(dot(x.xyz, position) + x.w, dot(y.xyz, position) + y.w,
    dot(z.xyz, position) + z.w);
  vec3 meshNormal;    // in mesh coordinates
  float height = 0.0; // of the computed point over the surface
  bool triangle = true;
  vec3 extent = abs(a.xyz - meshPosition);
#if defined(GI_RAY_SPHERES) || defined(GI_RAY_CYLINDERS)
  int kind = floatBitsToInt(b.w);
  triangle = kind != GI_RAY_SPHERE && kind < GI_RAY_CYLINDER;
  if (kind == GI_RAY_SPHERE)
  {
    height = length(meshPosition - a.xyz) - c.w;
    meshNormal = normalize(meshPosition - a.xyz);
  }
  else if (kind >= GI_RAY_CYLINDER)
  {
    vec3 axis = normalize(b.xyz - a.xyz);
    vec3 across = (meshPosition - a.xyz) - dot(meshPosition - a.xyz, axis) * axis;
    bool cap = hit.barycentrics.y > 0.5;
    height = cap ? 0.0 : length(across) - c.w;
    meshNormal = cap ? axis * (hit.barycentrics.x > 0.5 ? 1.0 : -1.0) : normalize(across);
  }
  else
#endif
  {
    vec3 edge1 = b.xyz - a.xyz;
    vec3 edge2 = c.xyz - a.xyz;
    // Scale by the triangle's size: the squared cross product of a tiny triangle would underflow.
    vec3 sides = max(abs(edge1), abs(edge2));
    float size = max(sides.x, max(sides.y, sides.z));
    meshNormal = normalize(cross(edge1 / size, edge2 / size));
    height = dot(meshPosition - a.xyz, meshNormal);
    extent = max(extent, max(abs(b.xyz - meshPosition), abs(c.xyz - meshPosition)));
  }
  // The error of the hit distance grows with the ray's length. One step of Newton's method brings
  // the point to the surface, so that rays that leave from there need only a small offset.
  vec3 outward = x.xyz * meshNormal.x + y.xyz * meshNormal.y + z.xyz * meshNormal.z;
  float scale = length(outward);
  result.position = position - outward * (height / (scale * scale));
  outward /= scale;
  vec3 size = max(abs(result.position), abs(meshPosition) / scale);
  // The hit point on a large triangle is imprecise even if the ray starts close to the coordinates' origin. For
  // squares seen from there, 6e-8 of their size was too little and 1e-7 enough.
  result.error = 1e-6 * max(size.x, max(size.y, size.z)) +
    3e-7 / scale * max(extent.x, max(extent.y, extent.z));
  // A mirroring transformation reverses the order of the corners and thus their cross product.
  float mirrored = dot(cross(x.xyz, y.xyz), z.xyz) < 0.0 ? -1.0 : 1.0;
  result.front = dot(outward, ray.direction) * mirrored < 0.0;
  bool toward = dot(outward, ray.direction) < 0.0;
  result.geometric = toward ? outward : -outward;
  result.normal = result.geometric;
  result.bulge = vec3(0.0);
  result.bend = 0.0;
  if ((surface.Where.z & GI_SURFACE_SMOOTH) != 0)
  {
    ivec3 corner = rayCorners(surface, result.primitive);
    vec3 share = vec3(1.0 - hit.barycentrics.x - hit.barycentrics.y, hit.barycentrics);
    mat3 normals = mat3(rayPointNormal(texelFetch(rayPoints, corner.x).x),
      rayPointNormal(texelFetch(rayPoints, corner.y).x),
      rayPointNormal(texelFetch(rayPoints, corner.z).x));
    vec3 n = mat3(x.xyz, y.xyz, z.xyz) * (normals * share);
    n = result.front ? n : -n;
    result.normal = dot(n, n) > 0.0 ? normalize(n) : result.geometric;
    bool allCorners = texelFetch(rayPoints, corner.x).x != GI_RAY_NO_NORMAL &&
      texelFetch(rayPoints, corner.y).x != GI_RAY_NO_NORMAL && texelFetch(rayPoints, corner.z).x != GI_RAY_NO_NORMAL;
    if (allCorners && dot(result.normal, result.geometric) > 0.0)
    {
      // Depth of the point below the tangent planes at the corners.
      vec3 bulge = vec3(0.0);
      float least = 1.0;
      float side = result.front ? 1.0 : -1.0;
      mat3 corners = mat3(a.xyz, b.xyz, c.xyz);
      for (int i = 0; i < 3; ++i)
      {
        vec3 outside = side * normals[i];
        bulge -= share[i] * min(dot(meshPosition - corners[i], outside), 0.0) * outside;
        least = min(least, abs(dot(outside, meshNormal)));
      }
      result.bulge = inverse(transpose(mat3(x.xyz, y.xyz, z.xyz))) * bulge;
      result.bend = sqrt(max(0.0, 1.0 - least * least));
    }
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
#ifdef GI_RAY_PICTURES
  if (triangle && surface.Pictures.z >= 0)
  {
    ivec3 corner = rayCorners(surface, result.primitive);
    result.normal = rayBentNormal(surface, corner, rayTextureCoordinates(corner, hit.barycentrics),
      b.xyz - a.xyz, c.xyz - a.xyz, transpose(mat3(x.xyz, y.xyz, z.xyz)), result.normal);
  }
#endif
  surface = rayMaterial(
    surface, result.primitive, hit.barycentrics, result.front, result.occlusion);
  result.color = surface.Color;
  result.emission = surface.Emission.rgb;
  result.specular = surface.Specular;
  result.metallic = surface.Factors.z;
  result.roughness = surface.Factors.w;
  return result;
}

// Origin of a ray that leaves a surface, offset to the direction's side so that the ray does not hit the surface again.
vec3 rayLeave(RaySurfacePoint at, vec3 direction)
{
  float side = dot(at.geometric, direction) >= 0.0 ? 1.0 : -1.0;
  return at.position + side * at.error * at.geometric;
}

// Point where light arrives from a direction above the shading normal's plane. At grazing angles the point lies on
// the curved surface that the normals represent; otherwise facets would show as dark teeth along the terminator
// (Hanika 2021, Hacking the Shadow Terminator). blocked: the direction points into the triangle.
vec3 rayArrive(RaySurfacePoint at, vec3 direction, out bool blocked)
{
  // At other angles the offset would lift points out of contact shadows.
  float grazing = min(2.0 * at.bend, 0.3);
  float share = grazing > 0.0 ? clamp(2.0 - 2.0 * dot(at.normal, direction) / grazing, 0.0, 1.0) : 0.0;
  vec3 lift = share * at.bulge;
  blocked = dot(at.geometric, direction) <= 0.0 && dot(at.geometric, lift) <= at.error;
  return rayLeave(at, at.geometric) + lift;
}
