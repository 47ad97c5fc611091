#version 430 core
// The average of the still frames so far. GI_FIRST starts a new sum; GI_FROZEN shows the sum as it
// is, without this frame.
#include "shared/view.h"

layout(binding = 0) uniform sampler2D colorTexture;
layout(binding = 0, rgba32f) uniform image2D sums; // rgb: sum of frames; a: their number
layout(location = 0) out vec4 color;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 current = texelFetch(colorTexture, pixel, 0);
#if GI_FIRST
  vec4 sum = vec4(current.rgb, 1.0);
#elif GI_FROZEN
  vec4 sum = imageLoad(sums, pixel);
#else
  vec4 sum = imageLoad(sums, pixel) + vec4(current.rgb, 1.0);
#endif
  imageStore(sums, pixel, sum);
  color = vec4(sum.rgb / sum.a, current.a);
}
