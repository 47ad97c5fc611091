#version 430 core
// Derivative of light with respect to the normal: a linear ridge regression over a tile and its neighbours (Hoerl and Kennard 1970,
// Ridge Regression: Biased Estimation for Nonorthogonal Problems). The filter averages the residuals, as in Moon, Carr and Yoon
// 2014, Adaptive Rendering Based on Weighted Local Regression.
#include "shared/view.h"
#include "shared/denoising.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DArray sums; // of slope_sums.comp
layout(rgba32f, binding = 0) writeonly uniform image2DArray slopes; // a layer for each component of the normal

const float RIDGE = 0.05; // added to the variance of normals, divided by the mean frame count

vec4 sumAt(ivec2 tile, int part, ivec2 last)
{
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 9; ++i)
  {
    ivec2 offset = ivec2(i % 3, i / 3) - 1;
    ivec2 at = tile + offset;
    vec2 share = 1.0 - 0.5 * vec2(abs(offset));
    sum += at == clamp(at, ivec2(0), last) ? share.x * share.y * texelFetch(sums, ivec3(at, part), 0) : vec4(0.0);
  }
  return sum;
}

void main()
{
  ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last = ivec2(ceil(view.Viewport.zw / float(GI_DENOISING_TILE))) - 1;
  if (any(greaterThan(tile, last)))
  {
    return;
  }
  vec4 sum[6];
  for (int i = 0; i < 6; ++i)
  {
    sum[i] = sumAt(tile, i, last);
  }
  float weight = max(sum[0].w, 1e-6);
  vec3 N = sum[0].xyz / weight;
  vec3 light = vec3(sum[1].w, sum[2].w, sum[3].w) / weight;
  vec3 squares = sum[1].xyz / weight - N * N;
  vec3 mixed = sum[2].xyz / weight - N.xxy * N.yzz;
  float ridge = RIDGE * max(sum[4].w, 1.0) / max(weight, 1.0);
  squares = max(squares, vec3(0.0)) + ridge;
  mat3 spread = mat3(squares.x, mixed.x, mixed.y, mixed.x, squares.y, mixed.z, mixed.y, mixed.z, squares.z);
  mat3 found = inverse(spread) * mat3(sum[3].xyz / weight - N * light.r, sum[4].xyz / weight - N * light.g,
    sum[5].xyz / weight - N * light.b); // a column for each channel
  for (int i = 0; i < 3; ++i)
  {
    imageStore(slopes, ivec3(tile, i), vec4(found[0][i], found[1][i], found[2][i], 0.0));
  }
}
