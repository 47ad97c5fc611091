#version 430 core
// Sums over tiles for the regression in slopes.comp, in eight texels: of normals and concavities, of light and weight, of squares,
// of products of the normal's components with each other and the pixel count, of their products with concavities, and of all with
// light's channels.
#define GI_LIGHT
#include "shared/view.h"
#include "shared/denoising.h"
#include "lib/octahedral.glsl"
#include "lib/filter_reach.glsl"
#include "lib/luminance.glsl"
#include "denoising/signal.glsl"
layout(local_size_x = 8, local_size_y = 8) in; // a tile each
layout(binding = 0) uniform usampler2D signalTexture;
layout(rgba32f, binding = 0) writeonly uniform image2DArray sums;

const float MAXIMUM_LIGHT = 8.0; // of a pixel, as a multiple of the tile's mean: limits the influence of outliers

GiSignal signalAt(ivec2 place)
{
  GiSignal signal = giUnpackSignal(texelFetch(signalTexture, place + ivec2(view.Viewport.xy), 0));
  bool broken = any(isnan(signal.value.rgb)) || any(isinf(signal.value.rgb));
  signal.frames = broken ? 0.0 : signal.frames;
  return signal;
}

// Mean luminance of a tile, robust against outliers: the square of the mean square root.
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
  ivec2 first = GI_DENOISING_TILE * tile;
  ivec2 end = min(first + GI_DENOISING_TILE, ivec2(view.Viewport.zw));
  if (any(greaterThanEqual(first, end)))
  {
    return;
  }
  float most = MAXIMUM_LIGHT * meanOf(first, end);
  vec4 sum[8];
  for (int i = 0; i < 8; ++i)
  {
    sum[i] = vec4(0.0);
  }
  for (int y = first.y; y < end.y; ++y)
  {
    for (int x = first.x; x < end.x; ++x)
    {
      GiSignal signal = signalAt(ivec2(x, y));
      float weight = signal.frames;
      if (weight > 0.0)
      {
        vec4 shape = vec4(giDecodeOctahedral(signal.normal), signal.concavity);
        vec3 light = signal.value.rgb * min(most / max(giLuminance(signal.value.rgb), 1e-20), 1.0);
        sum[0] += weight * shape;
        sum[1] += weight * vec4(light, 1.0);
        sum[2] += weight * shape * shape;
        sum[3] += vec4(weight * shape.xxy * shape.yzz, 1.0);
        sum[4] += weight * vec4(shape.xyz * shape.w, 0.0);
        sum[5] += weight * shape * light.r;
        sum[6] += weight * shape * light.g;
        sum[7] += weight * shape * light.b;
      }
    }
  }
  for (int i = 0; i < 8; ++i)
  {
    imageStore(sums, ivec3(tile, i), sum[i]);
  }
}
