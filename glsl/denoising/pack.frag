#version 430 core
// Joins a noisy value with its surface. Variants: those of denoising/signal.glsl; GI_OWN_SURFACE (the surfaces are not the frame's,
// see resource::PathSurface).
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/filter_reach.glsl"
#include "denoising/signal.glsl"
#ifdef GI_SHARES
#define GI_TEXTURE sampler2DArray
#define GI_AT(pixel) ivec3(pixel, layer)
uniform int layer;
#else
#define GI_TEXTURE sampler2D
#define GI_AT(pixel) (pixel)
#endif
layout(binding = 0) uniform GI_TEXTURE current; // a of light: see temporal_accumulation/accumulate.frag
#ifdef GI_JOINT
layout(binding = 5) uniform sampler2D meanTexture;
#endif
#ifndef GI_LIGHT
layout(binding = 4) uniform GI_TEXTURE reachTexture;
#endif
#ifdef GI_OWN_SURFACE
layout(binding = 1) uniform sampler2D pathSurface;
#else
layout(binding = 1) uniform sampler2D albedoTexture;
layout(binding = 2) uniform sampler2D depthTexture;
layout(binding = 3) uniform sampler2D normalTexture;
#endif

uniform int stillSamples; // of each pixel in another mean of the picture

layout(location = 0) out uvec4 result;
#ifdef GI_JOINT
layout(location = 1) out vec4 own;
#endif

#if defined(GI_LIGHT) && !defined(GI_OWN_SURFACE)
const float REACHES = 48.0; // of a concavity, along the shorter side of a picture
const float FARTHEST = 6.0; // times the reach, from where surfaces count less than half

// x: sine of the angle at which the surface at another pixel rises above a surface's plane; y: how much it counts. far: the distance
// from which it counts less than half.
vec2 riseAt(ivec2 at, vec3 P, vec3 N, float far)
{
  ivec2 low = ivec2(view.Viewport.xy);
  ivec2 high = low + ivec2(view.Viewport.zw) - 1;
  if (at != clamp(at, low, high) || texelFetch(albedoTexture, at, 0).a == 0.0)
  {
    return vec2(0.0);
  }
  vec3 apart = giViewPosition(vec2(at) + 0.5, texelFetch(depthTexture, at, 0).r) - P;
  float size = length(apart);
  float share = size / max(far, 1e-30);
  return vec2(dot(N, apart) / max(size, 1e-30), 1.0 / (1.0 + share * share));
}

// How hollow a surface is: the mean sine of the angle at which surfaces around rise above its plane. On ridges, where they fall on
// both sides, it is negative. A flat face beside its own edges or corner is flat, as what lies behind them takes no light from it.
float concavityAt(ivec2 pixel, float depth, vec2 normal)
{
  vec3 P = giViewPosition(gl_FragCoord.xy, depth);
  vec3 N = giDecodeOctahedral(normal);
  int reach = max(int(min(view.Viewport.z, view.Viewport.w) / REACHES + 0.5), 2);
  float far = FARTHEST * float(reach) * distance(giViewPosition(gl_FragCoord.xy + vec2(1.0, 0.0), depth), P);
  vec2 rise = vec2(0.0);
  float fall = 0.0;
  float steepest = 0.0; // at a corner one pair of opposite pixels falls, too
  for (int i = 0; i < 4; ++i)
  {
    ivec2 offset = reach * (ivec2(i % 3, i / 3) - 1);
    vec2 one = riseAt(pixel + offset, P, N, far);
    vec2 other = riseAt(pixel - offset, P, N, far);
    rise += vec2(one.y * max(one.x, 0.0) + other.y * max(other.x, 0.0), one.y + other.y);
    float both = 2.0 * min(one.y, other.y) * min(max(one.x, other.x), 0.0);
    fall += both;
    steepest = min(steepest, both);
  }
  return (rise.x + fall - steepest) / max(rise.y, 1e-6);
}
#endif

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  GiSignal signal;
#ifdef GI_OWN_SURFACE
  vec4 surface = texelFetch(pathSurface, pixel, 0);
  bool exists = surface.a > 0.0;
  signal.depth = surface.z;
  signal.normal = surface.xy;
#else
  bool exists = texelFetch(albedoTexture, pixel, 0).a > 0.0;
  signal.depth = texelFetch(depthTexture, pixel, 0).r;
  signal.normal = texelFetch(normalTexture, pixel, 0).xy;
#endif
  vec4 value = texelFetch(current, GI_AT(pixel), 0);
#ifdef GI_JOINT
  own = min(value, vec4(GI_BRIGHTEST));
  value = texelFetch(meanTexture, pixel, 0);
#endif
  signal.value = exists ? min(value, vec4(GI_BRIGHTEST)) : vec4(0.0);
#ifndef GI_LIGHT
  float size = distance(giViewPosition(gl_FragCoord.xy + vec2(1.0, 0.0), signal.depth),
    giViewPosition(gl_FragCoord.xy, signal.depth));
  signal.reach = min(texelFetch(reachTexture, GI_AT(pixel), 0) / max(size, 1e-30), vec4(radius));
  signal.frames = exists && signal.reach.x >= 0.0 ? 1.0 : 0.0;
  signal.reach = max(signal.reach, 0.0);
#else
  signal.reach = vec4(0.0); // follows from the frames
  signal.frames = exists ? max(floor(value.a), float(stillSamples + 1)) : 0.0;
  signal.error = fract(value.a);
  signal.concavity = 0.0;
#ifndef GI_OWN_SURFACE
  signal.concavity = exists ? concavityAt(pixel, signal.depth, signal.normal) : 0.0;
#endif
#endif
  result = giPackSignal(signal);
}
