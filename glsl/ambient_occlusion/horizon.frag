#version 430 core
// Openness of a pixel's surface by horizons: in slices that contain the view direction,
// samples to each side find how high the surroundings rise, and the light above the horizon has
// a closed form. Jimenez, Wu, Pesce and Jarabo 2016, Practical Realtime Strategies for
// Accurate Indirect Occlusion. Variants: GI_STRIDE (width in pixels of the block that a texel represents),
// GI_THICKNESS (occluders have a finite thickness, and light passes behind them), GI_BENT (also find the mean direction
// of the occluded light).
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/sampling.glsl"
#include "ambient_occlusion/raw.glsl"
#include "ambient_occlusion/arc.glsl"
#include "ambient_occlusion/walk.glsl"
#ifdef GI_THICKNESS
#include "ambient_occlusion/sectors.glsl"
#else
#include "ambient_occlusion/horizon.glsl"
#endif

layout(binding = 1) uniform sampler2D normalTexture;

uniform int slices;

layout(location = 0) out GI_RAW result;

void main()
{
  ivec2 raw = ivec2(gl_FragCoord.xy);
  ivec2 pixel = giRawPixel(raw);
  float depth = texelFetch(depthTexture, pixel, 0).r;
  if (depth >= 1.0)
  {
    result = giPackRaw(1.0, depth, vec2(0.5), vec3(0.0));
    return;
  }
  vec2 normal = texelFetch(normalTexture, pixel, 0).xy;
  vec3 N = giDecodeOctahedral(normal);
  vec2 noise = giRawNoise(raw);
  Walk walk = walkFrom(pixel, depth, N, noise.y);
  mat3 around = giBasis(walk.V);
  vec3 rise = walkAxis(walk, N);
  float occludedLight = 0.0;
  vec3 hidden = vec3(0.0);
  for (int i = 0; i < slices; ++i)
  {
    float turn = (float(i) + noise.x) * (GI_ARC_PI / float(slices));
    vec3 T = around[0] * cos(turn) + around[1] * sin(turn);
    // Projection of the normal into the slice.
    vec2 n = vec2(max(dot(N, walk.V), 1e-3), dot(N, T));
    float share = length(n);
    n /= share;
    WalkLine line = walkAlong(walk, T, n, rise / share);
    vec3 ahead = occludedSide(walk, line);
    vec3 behind = occludedSide(walk, walkBack(line));
    occludedLight += share * (ahead.x + behind.x);
    hidden += share * ((ahead.y - behind.y) * T + (ahead.z + behind.z) * walk.V);
  }
  result = giPackRaw(1.0 - occludedLight / float(slices), depth, normal, hidden / float(slices));
}
