#version 430 core
// Gives each pixel the light at itself, or the mean of that at the nearest pixels from which rays went in this frame, on the
// same surface (joint bilateral upsampling: Kopf, Cohen, Lischinski and Uyttendaele 2007). a: number of pixels that share a
// sample, negative for a sample of other pixels.
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/alike.glsl"
#include "ray_traced_light/turn.glsl"

layout(binding = 0) uniform sampler2D samples;
layout(binding = 1) uniform sampler2D albedoTexture;
layout(binding = 2) uniform sampler2D normalTexture;
layout(binding = 3) uniform sampler2D depthTexture;

layout(location = 0) out vec4 traced;

struct Blend
{
  vec3 sum;
  float weights;
};

// Adds the sample of a block. similar: on the same surface; else on any that faces the same way.
void add(inout Blend blend, ivec2 block, ivec2 pixel, GiSurfel here, float share, const bool similar)
{
  if (any(lessThan(block, ivec2(0))) || any(greaterThanEqual(block, textureSize(samples, 0))))
  {
    return;
  }
  vec4 light = texelFetch(samples, block, 0);
  ivec2 at = block * stride + turnPlace(block.y);
  ivec2 window = at + ivec2(view.Viewport.xy);
  float depth = similar ? texelFetch(depthTexture, window, 0).r : here.depth + dot(here.slope, vec2(at - pixel));
  float weight = light.a * share * giSimilarity(here, vec2(at - pixel), depth, texelFetch(normalTexture, window, 0).xy);
  blend.sum += weight * light.rgb;
  blend.weights += weight;
}

void main()
{
  ivec2 window = ivec2(gl_FragCoord.xy);
  ivec2 pixel = window - ivec2(view.Viewport.xy);
  traced = vec4(0.0);
  if (texelFetch(albedoTexture, window, 0).a == 0.0)
  {
    return;
  }
  float sharing = float(stride.x * stride.y);
  ivec2 own = pixel / stride;
  ivec2 place = turnPlace(own.y);
  if (pixel == own * stride + place)
  {
    traced = vec4(texelFetch(samples, own, 0).rgb, sharing);
    return;
  }
  GiSurfel here = giSurfel(gl_FragCoord.xy, texelFetch(depthTexture, window, 0).r,
    texelFetch(normalTexture, window, 0).xy, float(stride.x));
  vec2 between = vec2(pixel - place) / vec2(stride);
  ivec2 base = ivec2(floor(between));
  vec2 share = between - vec2(base);
  Blend blend = Blend(vec3(0.0), 0.0);
  for (int i = 0; i < 4; ++i)
  {
    ivec2 offset = ivec2(i & 1, i >> 1);
    if (turnIsCheckerboard())
    {
      // Rays went from all four neighbours.
      ivec2 beside = pixel + ivec2(offset.x + offset.y - 1, offset.x - offset.y);
      add(blend, ivec2(floor(vec2(beside) / vec2(stride))), pixel, here, 1.0, true);
    }
    else
    {
      vec2 shares = mix(1.0 - share, share, vec2(offset));
      add(blend, base + offset, pixel, here, max(shares.x * shares.y, 1e-3), true);
    }
  }
  // Thin things may have none there.
  int more = blend.weights == 0.0 ? 16 : 0;
  for (int i = 0; i < more; ++i)
  {
    add(blend, base + ivec2(i & 3, i >> 2) - 1, pixel, here, 1.0, false);
  }
  traced = vec4(blend.sum / max(blend.weights, 1e-20), -sharing);
}
