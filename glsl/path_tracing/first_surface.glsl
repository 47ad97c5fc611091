// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The first surface that the eye sees through a point of a pixel, and the random numbers of the path from there. Needs
// shared/view.h, shared/material.h, lib/reconstruct.glsl and path_tracing/paths.glsl. Variants: GI_RAY_EDGES (some surfaces show
// the edges of their cells).
#ifdef GI_RAY_EDGES
#include "path_tracing/edges.glsl"
#endif
layout(binding = 0) uniform sampler2D albedoTexture;
layout(binding = 1) uniform sampler2D normalTexture;
layout(binding = 2) uniform sampler2D depthTexture;

uniform mat3 viewToScene;
uniform int seedOfAll;
uniform float drawnReach; // share of the distance to a line or point within which a surface hides it

const float DEPTH_ERROR = 2.5e-7; // of a 24-bit depth buffer

// Start the random numbers of a path. Returns their state.
uint startPath(ivec2 window, int number)
{
  seed = giHash(uint(window.x) + (uint(window.y) << 16) + uint(seedOfAll) * 0x9e3779b9u);
  sampleNumber = number;
  return giHash(seed ^ giHash(uint(number)));
}

// Whether the rasterizer drew a prop that it captured at the pixel's centre.
bool drawnAt(ivec2 window)
{
  return texelFetch(albedoTexture, window, 0).a > 0.0;
}

// Returns whether there is one. shift: of the point from the pixel's centre, in pixels; what the rasterizer drew is known at the
// centre only. ray: from the eye, or from what it passed.
bool firstSurface(ivec2 window, vec2 shift, out Ray ray, out RaySurfacePoint at, inout uint state)
{
  // The matrices contain the frame's jitter.
  vec2 center = vec2(window) + 0.5 + shift;
  vec3 near = giViewPosition(center, 0.0);
  vec3 path = giViewPosition(center, 1.0) - near;
  ray = Ray(eye + viewToScene * near, 0.0, viewToScene * normalize(path), length(path));
  bool captured = shift == vec2(0.0) && drawnAt(window);
  int material = int(texelFetch(normalTexture, window, 0).z * 65535.0 + 0.5);
  float depth = texelFetch(depthTexture, window, 0).r;
  if (captured && (material == GI_MATERIAL_AS_DRAWN || (materials[material].Model.y & GI_MATERIAL_THIN) != 0))
  {
    ray.tMax = length(giViewPosition(center, depth) - near) * drawnReach;
  }
  float first;
  RayHit hit = traceThrough(ray, at, first, state);
  // If the rasterizer drew something well in front of the first hit, rays do not see that prop.
  float farthest = length(giViewPosition(center, min(depth + DEPTH_ERROR, 1.0)) - near);
  bool hidden = captured && drawnReach < 1.0 && first > farthest * (2.0 - drawnReach);
  bool met = hit.instance >= 0 && !hidden;
#ifdef GI_RAY_EDGES
  if (met)
  {
    at = withEdges(at, hit, transpose(viewToScene), eye, center);
  }
#endif
  return met;
}
