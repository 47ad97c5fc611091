#version 430 core
// Sums over tiles of 16x16 pixels for the fit in slopes.comp, in six texels: weights, normals, their products with themselves and
// with the light, the light, and the number of pixels.
#define GI_LIGHT
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/filter_reach.glsl"
#include "lib/luminance.glsl"
#include "denoising/signal.glsl"
layout(local_size_x = 8, local_size_y = 8) in; // a tile each
layout(binding = 0) uniform usampler2D signalTexture;
layout(rgba32f, binding = 0) writeonly uniform image2DArray sums;

const int TILE = 16;
const float BRIGHTEST = 8.0; // times the mean around it, light counts fully: single bright samples must not tilt the fit

GiSignal signalAt(ivec2 place)
{
  GiSignal signal = giUnpackSignal(texelFetch(signalTexture, place + ivec2(view.Viewport.xy), 0));
  bool broken = any(isnan(signal.value.rgb)) || any(isinf(signal.value.rgb));
  signal.frames = broken ? 0.0 : signal.frames;
  return signal;
}

// Mean luminance between two corners, to which bright pixels contribute little.
float meanOf(ivec2 first, ivec2 end)
{
  vec2 sum = vec2(0.0);
  for (int y = first.y; y < end.y; ++y)
  {
    for (int x = first.x; x < end.x; ++x)
    {
      GiSignal signal = signalAt(ivec2(x, y));
      sum += signal.frames > 0.0 ? vec2(sqrt(giLuminance(signal.value.rgb)), 1.0) : vec2(0.0);
    }
  }
  float root = sum.x / max(sum.y, 1.0);
  return root * root;
}

void main()
{
  ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
  ivec2 first = TILE * tile;
  ivec2 end = min(first + TILE, ivec2(view.Viewport.zw));
  if (any(greaterThanEqual(first, end)))
  {
    return;
  }
  float most = BRIGHTEST * meanOf(first, end);
  vec4 sum[6] = vec4[](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
  for (int y = first.y; y < end.y; ++y)
  {
    for (int x = first.x; x < end.x; ++x)
    {
      GiSignal signal = signalAt(ivec2(x, y));
      float weight = signal.frames;
      if (weight > 0.0)
      {
        vec3 N = giDecodeOctahedral(signal.normal);
        vec3 light = signal.value.rgb * min(most / max(giLuminance(signal.value.rgb), 1e-20), 1.0);
        sum[0] += weight * vec4(N, 1.0);
        sum[1] += weight * vec4(N * N, light.r);
        sum[2] += weight * vec4(N.xxy * N.yzz, light.g);
        sum[3] += weight * vec4(N * light.r, light.b);
        sum[4] += vec4(weight * N * light.g, 1.0);
        sum[5] += vec4(weight * N * light.b, 0.0);
      }
    }
  }
  for (int i = 0; i < 6; ++i)
  {
    imageStore(sums, ivec3(tile, i), sum[i]);
  }
}
