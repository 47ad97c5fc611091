#version 430 core
// Mean of the still frames so far. GI_FIRST starts a new sum; GI_FROZEN shows the sum as it
// is, without this frame. GI_PICKED: pixels at edges get the colours of what covers them, see pick.comp; differences to these
// have a sum of their own (GI_FIRST_PICKED: a new one), which fades out, so that the mean of many frames is that of what the pixels
// themselves show.
layout(binding = 0) uniform sampler2D colorTexture;
layout(binding = 0, rgba32f) uniform image2D sums;
uniform float frames; // number of frames in the sum, including this one
#ifdef GI_PICKED
#include "anti_aliasing/picks.glsl"
layout(binding = 1) uniform usampler2D picksTexture;
layout(binding = 1, rgba32f) uniform image2D edges;
uniform float share; // of the differences

// Difference of what covers a pixel from what its own sample shows.
vec4 coverDifference(ivec2 pixel, vec4 own)
{
  uint picks = texelFetch(picksTexture, pixel, 0).r;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < PICK_POINTS && hasPicks(picks); ++i)
  {
    vec4 apart = texelFetch(colorTexture, pixel + offsetOfPick(picks, i), 0) - own;
    sum += any(isnan(apart)) || any(isinf(apart)) ? vec4(0.0) : apart;
  }
  return sum / float(PICK_POINTS);
}
#endif

layout(location = 0) out vec4 color;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 own = texelFetch(colorTexture, pixel, 0);
  vec4 sum = own;
#if GI_FROZEN
  sum = imageLoad(sums, pixel);
#elif !GI_FIRST
  sum += imageLoad(sums, pixel);
#endif
  imageStore(sums, pixel, sum);
#ifdef GI_PICKED
  vec4 difference = coverDifference(pixel, own);
#if !GI_FIRST_PICKED
  difference += imageLoad(edges, pixel);
#endif
  imageStore(edges, pixel, difference);
  sum = max(sum + share * difference, 0.0);
#endif
  color = sum / frames;
}
