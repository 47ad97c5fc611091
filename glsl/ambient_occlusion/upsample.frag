#version 430 core
// From half resolution to the window's: of the four texels around a pixel, those on its surface.
// Kopf, Cohen, Lischinski and Uyttendaele 2007, Joint Bilateral Upsampling.
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "ambient_occlusion/raw.glsl"
#include "ambient_occlusion/alike.glsl"

layout(binding = 0) uniform usampler2D rawTexture;
layout(binding = 1) uniform sampler2D depthTexture;
layout(binding = 2) uniform sampler2D normalTexture;

layout(location = 0) out float openness;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(depthTexture, pixel, 0).r;
  GiSurfel here = giSurfel(gl_FragCoord.xy, depth, texelFetch(normalTexture, pixel, 0).xy, 2.0);
  ivec2 low = ivec2(view.Viewport.xy) / 2;
  ivec2 high = ivec2(view.Viewport.xy + view.Viewport.zw - 1.0) / 2;
  vec2 place = vec2(pixel - giRawOffset()) * 0.5;
  ivec2 corner = ivec2(floor(place));
  vec2 part = place - vec2(corner);
  float sum = 0.0;
  float weights = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    ivec2 offset = ivec2(i & 1, i >> 1);
    ivec2 at = clamp(corner + offset, low, high);
    uvec2 other = texelFetch(rawTexture, at, 0).xy;
    vec2 near = mix(1.0 - part, part, vec2(offset));
    // Where none is alike, all count a little.
    float alike = giAlike(here, vec2(giRawPixel(at) - pixel), giRawDepth(other), giRawNormal(other));
    float weight = (near.x * near.y + 1e-3) * (alike + 1e-3);
    sum += weight * giRawOpenness(other);
    weights += weight;
  }
  openness = max(sum / weights, 0.0);
}
