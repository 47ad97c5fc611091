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
#endif
  result = giPackSignal(signal);
}
