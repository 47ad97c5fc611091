#version 430 core
// Upsamples from half resolution: averages those of the four texels around a pixel that are on its surface.
// Kopf, Cohen, Lischinski and Uyttendaele 2007, Joint Bilateral Upsampling. Variants: GI_STRIDE,
// GI_BENT.
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "ambient_occlusion/raw.glsl"
#include "lib/alike.glsl"

layout(binding = 0) uniform usampler2D rawTexture;
layout(binding = 1) uniform sampler2D depthTexture;
layout(binding = 2) uniform sampler2D normalTexture;

layout(location = 0) out GI_OPEN result;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(depthTexture, pixel, 0).r;
  vec2 normal = texelFetch(normalTexture, pixel, 0).xy;
  GiSurfel here = giSurfel(gl_FragCoord.xy, depth, normal, 2.0);
  ivec2 low = ivec2(view.Viewport.xy) / 2;
  ivec2 high = ivec2(view.Viewport.xy + view.Viewport.zw - 1.0) / 2;
  vec2 place = vec2(pixel - giRawOffset()) * 0.5;
  ivec2 corner = ivec2(floor(place));
  vec2 fraction = place - vec2(corner);
  float sum = 0.0;
  vec3 hidden = vec3(0.0);
  float weights = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    ivec2 offset = ivec2(i & 1, i >> 1);
    ivec2 at = clamp(corner + offset, low, high);
    GI_RAW other = GI_RAW_OF(texelFetch(rawTexture, at, 0));
    vec2 bilinear = mix(1.0 - fraction, fraction, vec2(offset));
    // If none is on the surface, all of them count a little.
    float similarity = giSimilarity(here, vec2(giRawPixel(at) - pixel), giRawDepth(other), giRawNormal(other));
    float weight = (bilinear.x * bilinear.y + 1e-3) * (similarity + 1e-3);
    sum += weight * giRawOpenness(other);
    hidden += weight * giRawHidden(other);
    weights += weight;
  }
  result = giOpen(sum / weights, giDecodeOctahedral(normal), hidden / weights);
}
