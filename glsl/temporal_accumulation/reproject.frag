#version 430 core
// Where a pixel's surface was seen in the frame before, and for how many frames it was seen on end;
// and what the next frame is to compare with.
// A neighbour of that place counts if it lay in the same plane, faced the same way and was the same
// object (Nehab et al. 2007, Accelerating Real-Time Shading with Reverse Reprojection Caching).
// Variants: GI_STILL (nothing moves), GI_PROPS_MOVE (not only the camera),
// GI_DISPLACEMENT (the points of some move within them).
#include "shared/view.h"
#include "shared/material.h"
#include "shared/motion.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "temporal_accumulation/surface.glsl"

layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D normalTexture;
layout(binding = 2) uniform sampler2D surfaceTexture; // of the frame before
layout(binding = 3) uniform sampler2D displacementTexture;

#ifdef GI_STILL
const int taps = 1;
#else
const int taps = 4; // pixels around the place
#endif

uniform vec2 tolerance; // distance from the plane, part of the depth; cosine between normals
uniform float most;     // frames that a mean may count
uniform bool continued; // whether the frame before was remembered

// How far away it was in the frame before, in pixels; the frames that agree, this one counted; which
// of the four pixels around that place agree, a bit each.
layout(location = 0) out vec4 result;
layout(location = 1) out vec4 remembered;

vec2 windowOf(mat4 viewToClip, vec3 position)
{
  vec4 clip = viewToClip * vec4(position, 1.0);
  return view.Viewport.xy + (clip.xy / clip.w * 0.5 + 0.5) * view.Viewport.zw;
}

// A position seen in the frame before: of a pixel, at a depth along the view.
vec3 previousPosition(ivec2 pixel, float depth)
{
  mat4 m = motion.PreviousViewToClip;
  vec2 ndc = (vec2(pixel) + 0.5 - view.Viewport.xy) / view.Viewport.zw * 2.0 - 1.0 - motion.PreviousShift.xy;
  float w = m[2].w * depth + m[3].w;
  return vec3((ndc * w - m[2].xy * depth - m[3].xy) / vec2(m[0].x, m[1].y), depth);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 packedNormal = texelFetch(normalTexture, pixel, 0);
  vec3 P = giViewPosition(gl_FragCoord.xy, texelFetch(depthTexture, pixel, 0).r);
  vec3 N = giDecodeOctahedral(packedNormal.xy);
  int index = int(packedNormal.z * 65535.0 + 0.5);
  int object = materials[index].Model.w;
#ifdef GI_STILL
  vec3 before = P;
  vec3 normalBefore = N;
#else
  mat4 toPrevious = motion.ToPrevious;
#ifdef GI_PROPS_MOVE
  int row = materials[index].Model.z;
  if (row > 0)
  {
    toPrevious = motions[row];
  }
#endif
  vec3 before = P;
#ifdef GI_DISPLACEMENT
  before += texelFetch(displacementTexture, pixel, 0).xyz;
#endif
  before = (toPrevious * vec4(before, 1.0)).xyz;
  vec3 normalBefore = mat3(toPrevious) * N;
#endif

#ifdef GI_STILL
  vec2 moved = vec2(0.0);
#else
  vec2 moved = windowOf(motion.PreviousViewToClip, before) - windowOf(motion.ViewToClip, P);
  // What stays is fetched, not blended with its neighbours for a rounding's sake.
  moved = max(abs(moved.x), abs(moved.y)) < 1e-2 ? vec2(0.0) : moved;
#endif
  vec2 place = vec2(pixel) + moved;
  vec2 corner = floor(place);
  vec2 weight = place - corner;

  ivec2 low = ivec2(view.Viewport.xy);
  ivec2 high = low + ivec2(view.Viewport.zw);
  int agreeing = 0;
  float frames = 0.0;
  float weights = 0.0;
  for (int i = 0; i < taps && continued; ++i)
  {
    ivec2 offset = ivec2(i & 1, i >> 1);
    ivec2 at = ivec2(corner) + offset;
    vec2 share = mix(1.0 - weight, weight, vec2(offset));
    if (share.x * share.y < 1e-3 || any(lessThan(at, low)) || any(greaterThanEqual(at, high)))
    {
      continue;
    }
    GiSeenSurface seen = giUnpackSurface(texelFetch(surfaceTexture, at, 0));
    vec3 there = previousPosition(at, seen.depth);
    float off = abs(dot(normalBefore, there - before));
    if (seen.object == object && off < tolerance.x * abs(before.z) &&
      dot(seen.normal, normalBefore) > tolerance.y)
    {
      agreeing |= 1 << i;
      frames += share.x * share.y * seen.frames;
      weights += share.x * share.y;
    }
  }
  frames = weights > 0.0 ? min(frames / weights + 1.0, most) : 1.0;
  result = vec4(moved, frames, float(agreeing));
  remembered = giPackSurface(GiSeenSurface(N, P.z, object, frames));
}
