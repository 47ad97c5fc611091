#version 430 core
// What the network says of each pixel: features, how much their differences and those of light count at each level, and how much
// the regression on places and samples of other surfaces.
#include "shared/view.h"
#include "denoising/network/fine.glsl"
layout(binding = 0) uniform sampler2DArray outputs; // of the network, for blocks of 2x2 pixels
layout(binding = 1) uniform sampler2DArray fine;    // hidden activations of single pixels

// Half of the sharpness of the filter without a network, so that what stands out of the noise is not blurred away.
const float LEAST_SHARPNESS = 0.15;

// At a silhouette a pixel with few frames and dark rays would otherwise get the light of its neighbours.
const float MOST_OTHERS = 0.5;

layout(location = 0) out vec4 features;
layout(location = 1) out vec4 counts[4]; // by level: bandwidth, sharpness, shares of the regression on places and of other surfaces

vec4 softplus(vec4 x)
{
  return max(x, 0.0) + log(1.0 + exp(-abs(x)));
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 place = 0.5 * (gl_FragCoord.xy - view.Viewport.xy) - 0.5;
  vec2 last = ceil(0.5 * view.Viewport.zw) - 1.0;
  vec4 sums[5] = vec4[](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
  for (int i = 0; i < 4; ++i)
  {
    vec2 corner = floor(place) + vec2(i & 1, i >> 1);
    vec2 weight = 1.0 - abs(place - corner);
    for (int four = 0; four < 5; ++four)
    {
      sums[four] += weight.x * weight.y * texelFetch(outputs, ivec3(clamp(corner, vec2(0.0), last), four), 0);
    }
  }
  vec4 hidden[GI_FINE];
  for (int four = 0; four < GI_FINE; ++four)
  {
    hidden[four] = texelFetch(fine, ivec3(pixel, four), 0);
  }
  giAddFine(hidden, sums);
  features = sums[0];
  vec4 bandwidths = softplus(sums[1]);
  vec4 sharpnesses = max(softplus(sums[2]), LEAST_SHARPNESS);
  vec4 trusts = 1.0 / (1.0 + exp(-sums[3]));
  vec4 others = MOST_OTHERS / (1.0 + exp(-sums[4]));
  for (int level = 0; level < 4; ++level)
  {
    counts[level] = vec4(bandwidths[level], sharpnesses[level], trusts[level], others[level]);
  }
}
