#version 430 core
// Derivative of light with respect to the normal and the concavity: a linear ridge regression over a tile and its neighbours (Hoerl
// and Kennard 1970, Ridge Regression: Biased Estimation for Nonorthogonal Problems). The filter averages the residuals, as in
// Moon, Carr and Yoon 2014, Adaptive Rendering Based on Weighted Local Regression.
#include "shared/view.h"
#include "shared/denoising.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DArray sums; // of slope_sums.comp
layout(rgba32f, binding = 0) writeonly uniform image2DArray slopes; // by the normal's components, and the concavity

// Added to the variance of normals and of concavities, divided by the mean frame count.
const vec4 RIDGE = vec4(0.05, 0.05, 0.05, 0.1);
const vec4 LEAST_RIDGE = vec4(0.0, 0.0, 0.0, 0.025); // light of fine slopes is not linear in their concavity

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
  vec4 sum[8];
  for (int i = 0; i < 8; ++i)
  {
    sum[i] = sumAt(tile, i, last);
  }
  float weight = max(sum[1].w, 1e-6);
  vec4 shape = sum[0] / weight;
  vec3 light = sum[1].rgb / weight;
  vec4 ridge = max(RIDGE * max(sum[3].w, 1.0) / max(weight, 1.0), LEAST_RIDGE);
  vec4 squares = max(sum[2] / weight - shape * shape, vec4(0.0)) + ridge;
  vec3 mixed = sum[3].xyz / weight - shape.xxy * shape.yzz;
  vec3 bent = sum[4].xyz / weight - shape.xyz * shape.w;
  mat4 spread = mat4(squares.x, mixed.x, mixed.y, bent.x, mixed.x, squares.y, mixed.z, bent.y, mixed.y, mixed.z, squares.z, bent.z,
    bent.x, bent.y, bent.z, squares.w);
  mat3x4 found = inverse(spread) * mat3x4(sum[5] / weight - shape * light.r, sum[6] / weight - shape * light.g,
    sum[7] / weight - shape * light.b); // a column for each channel
  for (int i = 0; i < 4; ++i)
  {
    imageStore(slopes, ivec3(tile, i), vec4(found[0][i], found[1][i], found[2][i], 0.0));
  }
}
