#version 430 core
// Traces one path per pixel and adds it to the sums. Variants: GI_RAY_EDGES (some surfaces show the edges of
// their cells), GI_VISIBLE_SKY (a skybox is behind everything), GI_OWN (follows the path to its first surface only, and
// adds what that shows without light; shaders have too few images to do so at once), and those of path_tracing/paths.glsl.
#define GI_POSITIONAL 1
#include "shared/view.h"
#include "shared/light.h"
#include "shared/material.h"
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/lights.glsl"
#include "lib/luminance.glsl"
#include "lib/phong.glsl"
#include "lib/pbr.glsl"
#include "lib/sampling.glsl"
#include "lib/light_points.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"
#include "rays/toward_light.glsl"
#include "path_tracing/paths.glsl"
#ifdef GI_RAY_EDGES
#include "path_tracing/edges.glsl"
#endif

layout(local_size_x = 8, local_size_y = 8) in;

// Sums over samples.
#ifdef GI_OWN
layout(rgba32f, binding = 0) uniform image2D sumOwn; // rgb; a: number of samples
uniform int ownSamples;                              // that number so far
uniform vec2 shift;                                  // of the ray, in pixels
#else
layout(rgba32f, binding = 0) uniform image2D sumShown;   // rgb for display; a: number of PBR samples
layout(rgba32f, binding = 1) uniform image2D sumEncoded; // linear rgb of PBR samples; a: squared luminance
layout(rgba32f, binding = 2) uniform image2D sumAlbedo;  // rgb; a: samples that hit a surface
layout(rgba32f, binding = 3) uniform image2D sumNormal;  // xyz in world coordinates; w: depth
layout(rgba32f, binding = 4) uniform image2D sumUnlit;  // rgb for display of what is not lit; a: number of samples
#endif

layout(binding = 0) uniform sampler2D albedoTexture;
layout(binding = 1) uniform sampler2D normalTexture;
layout(binding = 2) uniform sampler2D depthTexture;
#ifndef GI_OWN
layout(binding = 3) uniform sampler2D colorTexture;
#endif
#if defined(GI_VISIBLE_SKY) && !defined(GI_OWN)
#include "lib/sky.glsl"
layout(binding = 4) uniform sampler2D skyTexture;
#endif

uniform mat3 viewToScene;
uniform int sampleIndex;   // number of samples in the sums
uniform int seedOfAll;
uniform float drawnReach;  // share of the distance to a line or point within which a surface hides it

const float DEPTH_ERROR = 2.5e-7; // of a 24-bit depth buffer

void main()
{
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 window = pixel + ivec2(view.Viewport.xy);
  if (any(greaterThanEqual(pixel, ivec2(view.Viewport.zw))))
  {
    return;
  }
  seed = giHash(uint(window.x) + (uint(window.y) << 16) + uint(seedOfAll) * 0x9e3779b9u);
  sampleNumber = sampleIndex;
  uint state = giHash(seed ^ giHash(uint(sampleIndex)));

  // The matrices contain the frame's jitter.
  vec2 center = vec2(window) + 0.5;
#ifdef GI_OWN
  center += shift;
#endif
  vec3 near = giViewPosition(center, 0.0);
  vec3 path = giViewPosition(center, 1.0) - near;
  vec3 direction = normalize(path);
  Ray ray = Ray(eye + viewToScene * near, 0.0, viewToScene * direction, length(path));
  bool captured = texelFetch(albedoTexture, window, 0).a > 0.0;
#ifdef GI_OWN
  captured = captured && shift == vec2(0.0); // else the depth is another ray's
#endif
  int material = int(texelFetch(normalTexture, window, 0).z * 65535.0 + 0.5);
  float depth = texelFetch(depthTexture, window, 0).r;
  if (captured && (material == GI_MATERIAL_AS_DRAWN || (materials[material].Model.y & GI_MATERIAL_THIN) != 0))
  {
    ray.tMax = length(giViewPosition(center, depth) - near) * drawnReach;
  }

  RaySurfacePoint at;
  vec3 start = ray.origin;
  float first;
  RayHit hit = traceThrough(ray, at, first, state);
  // If the rasterizer drew something well in front of the first hit, rays do not see that prop.
  float farthest = length(giViewPosition(center, min(depth + DEPTH_ERROR, 1.0)) - near);
  bool hidden = captured && drawnReach < 1.0 && first > farthest * (2.0 - drawnReach);
  bool met = hit.instance >= 0 && !hidden;
#ifdef GI_OWN
  vec4 own = ownSamples > 0 ? imageLoad(sumOwn, window) : vec4(0.0);
  bool isLit = met && (raySurfaces[at.surface].Where.z & GI_SURFACE_MODEL) != GI_SURFACE_UNLIT;
  bool finite = !any(isnan(at.emission)) && !any(isinf(at.emission));
  imageStore(sumOwn, window, own + vec4(isLit && finite ? at.emission : vec3(0.0), 1.0));
#else
  bool encoded = false;
  bool lit = false;
  vec3 value = texelFetch(colorTexture, window, 0).rgb; // lines and points, background
#ifdef GI_VISIBLE_SKY
  if (!captured)
  {
    vec4 sky = texelFetch(skyTexture, window, 0);
    encoded = sky.a > 0.5;
    value = giSkyRadiance(sky);
  }
#endif
  vec4 albedo = vec4(0.0);
  vec4 normal = vec4(0.0);
  if (met)
  {
#ifdef GI_RAY_EDGES
    at = withEdges(at, hit, transpose(viewToScene), eye, center);
#endif
    albedo = vec4(at.color.rgb, 1.0);
    normal = vec4(at.normal, dot(at.position - start, viewToScene * vec3(0.0, 0.0, -1.0)) - near.z);
    RaySurface surface = raySurfaces[at.surface];
    encoded = (surface.Where.z & GI_SURFACE_MODEL) == GI_SURFACE_PBR;
    lit = (surface.Where.z & GI_SURFACE_MODEL) != GI_SURFACE_UNLIT;
    value = pathRadiance(ray, at, 0.0, state);
    value = any(isnan(value)) || any(isinf(value)) ? vec3(0.0) : value;
    value = lit && rayColoredByData(surface) ? mix(at.color.rgb, value, giDataLit(encoded)) : value;
  }
  float luminance = giLuminance(value);
  bool more = sampleIndex > 0;
  vec4 none = vec4(0.0);
  vec4 shown = more ? imageLoad(sumShown, window) : none;
  vec4 linear = more ? imageLoad(sumEncoded, window) : none;
  vec4 albedos = more ? imageLoad(sumAlbedo, window) : none;
  vec4 unlit = more ? imageLoad(sumUnlit, window) : none;
  vec4 normals = more ? imageLoad(sumNormal, window) : none;
  imageStore(sumShown, window, shown + (encoded ? vec4(0.0, 0.0, 0.0, 1.0) : vec4(value, 0.0)));
  imageStore(sumEncoded, window,
    linear + vec4(encoded ? value : vec3(0.0), luminance * luminance));
  imageStore(sumAlbedo, window, albedos + albedo);
  // A sky that VTK encodes is in sumEncoded alone.
  imageStore(sumUnlit, window, unlit + (lit || encoded ? none : vec4(value, 1.0)));
  imageStore(sumNormal, window, normals + normal);
#endif
}
