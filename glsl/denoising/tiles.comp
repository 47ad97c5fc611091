#version 430 core
// Sum of the luminance in tiles of 16x16 pixels, and number of pixels with a surface.
#define GI_LIGHT
#include "shared/view.h"
#include "shared/denoising.h"
#include "lib/octahedral.glsl"
#include "lib/filter_reach.glsl"
#include "lib/luminance.glsl"
#include "denoising/signal.glsl"
layout(local_size_x = 8, local_size_y = 8) in; // a tile each: barriers cost more than they save
layout(binding = 0) uniform usampler2D signalTexture;
layout(rg32f, binding = 0) writeonly uniform image2D tiles;


void main()
{
  ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
  ivec2 first = GI_DENOISING_TILE * tile;
  ivec2 end = min(first + GI_DENOISING_TILE, ivec2(view.Viewport.zw));
  vec2 sum = vec2(0.0);
  for (int y = first.y; y < end.y; ++y)
  {
    for (int x = first.x; x < end.x; ++x)
    {
      GiSignal signal = giUnpackSignal(texelFetch(signalTexture, ivec2(x, y) + ivec2(view.Viewport.xy), 0));
      sum += signal.frames > 0.0 ? vec2(giLuminance(signal.value.rgb), 1.0) : vec2(0.0);
    }
  }
  imageStore(tiles, tile, vec4(sum, 0.0, 0.0)); // ignored outside
}
