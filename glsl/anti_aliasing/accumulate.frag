#version 430 core
// Mean of the still frames so far. GI_FIRST starts a new sum; GI_FROZEN shows the sum as it
// is, without this frame. GI_COVERAGE: edge pixels are blended by their coverage, see coverage.comp. The
// differences this makes are summed separately (GI_FIRST_COVERAGE starts a new sum) and fade out, so that the mean of many frames
// is unbiased.
layout(binding = 0) uniform sampler2D colorTexture;
layout(binding = 0, rgba32f) uniform image2D sums;
uniform float frames; // number of frames in the sum, including this one
uniform float lastWeight; // weight of the last frame in the mean
#ifdef GI_COVERAGE
#include "anti_aliasing/coverage.glsl"
layout(binding = 1) uniform usampler2D coverageTexture;
layout(binding = 1, rgba32f) uniform image2D edges;
uniform float share;  // weight of the differences
uniform bool display; // colours are encoded as VTK shows them

// Difference between the pixel blended by its coverage and its own colour.
vec4 coverageDifference(ivec2 pixel, vec4 own)
{
  uvec2 coverage = texelFetch(coverageTexture, pixel, 0).rg;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < COVERAGE_SAMPLES && isShared(coverage); ++i)
  {
    vec4 source = texelFetch(colorTexture, pixel + sampleOffset(coverage, i), 0);
    vec4 apart = vec4(sampleGain(coverage, i, display) * source.rgb, source.a) - own;
    sum += any(isnan(apart)) || any(isinf(apart)) ? vec4(0.0) : apart;
  }
  return sum / float(COVERAGE_SAMPLES);
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
#ifdef GI_COVERAGE
  vec4 difference = coverageDifference(pixel, own);
  own += share * difference;
#if !GI_FIRST_COVERAGE
  difference += imageLoad(edges, pixel);
#endif
  imageStore(edges, pixel, difference);
  sum = max(sum + share * difference, 0.0);
#endif
  float missing = 1.0 - lastWeight;
  color = (sum - missing * own) / (frames - missing);
}
