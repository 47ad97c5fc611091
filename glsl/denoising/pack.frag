#version 430 core
// Joins a noisy value with its surface. Variants: those of denoising/signal.glsl.
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/filter_reach.glsl"
#include "denoising/signal.glsl"
#ifdef GI_SHARES
layout(binding = 0) uniform sampler2DArray current;
layout(binding = 4) uniform sampler2DArray penumbrasTexture;
uniform int layer;
#else
layout(binding = 0) uniform sampler2D current; // a: number of frames in the mean
#endif
layout(binding = 1) uniform sampler2D albedoTexture;
layout(binding = 2) uniform sampler2D depthTexture;
layout(binding = 3) uniform sampler2D normalTexture;

uniform int stillFrames; // that another mean of the picture has

const float BRIGHTEST = 6e4;      // what half floats hold
const float PENUMBRA_SHARE = 0.4; // reach, as a share of half the width; more blurs the edges

layout(location = 0) out uvec4 result;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  GiSignal signal;
  bool exists = texelFetch(albedoTexture, pixel, 0).a > 0.0;
  signal.depth = texelFetch(depthTexture, pixel, 0).r;
  signal.normal = texelFetch(normalTexture, pixel, 0).xy;
#ifdef GI_SHARES
  signal.value = texelFetch(current, ivec3(pixel, layer), 0);
  float size = distance(giViewPosition(gl_FragCoord.xy + vec2(1.0, 0.0), signal.depth),
    giViewPosition(gl_FragCoord.xy, signal.depth));
  signal.reach = min(PENUMBRA_SHARE * texelFetch(penumbrasTexture, ivec3(pixel, layer), 0) / max(size, 1e-30), vec4(radius));
  signal.frames = exists ? 1.0 : 0.0;
#else
  vec4 value = texelFetch(current, pixel, 0);
  signal.value = exists ? min(value, vec4(BRIGHTEST)) : vec4(0.0);
  signal.reach = vec4(0.0); // follows from the frames
  signal.frames = exists ? max(value.a, float(stillFrames + 1)) : 0.0;
#endif
  result = giPackSignal(signal);
}
