#version 430 core
// Joins a noisy value with its surface.
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "denoising/signal.glsl"
layout(binding = 0) uniform sampler2D current; // a: number of frames in the mean
layout(binding = 1) uniform sampler2D albedoTexture;
layout(binding = 2) uniform sampler2D depthTexture;
layout(binding = 3) uniform sampler2D normalTexture;

uniform int stillFrames; // before this one; they count even if no mean is kept

layout(location = 0) out uvec4 result;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  bool exists = texelFetch(albedoTexture, pixel, 0).a > 0.0;
  vec4 value = texelFetch(current, pixel, 0);
  result = giPackSignal(GiSignal(exists ? value.rgb : vec3(0.0), exists ? max(value.a, float(stillFrames + 1)) : 0.0,
    texelFetch(depthTexture, pixel, 0).r, texelFetch(normalTexture, pixel, 0).xy));
}
