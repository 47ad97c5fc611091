#version 430 core
// Averages along rows, or along columns (GI_DOWN), over texels on the same surface: near the plane
// through this one, with a similar normal. The outer two of five texels count half, so that all parts of the sampling
// pattern, which is four texels wide, have the same weight. Variants: GI_STRIDE; GI_AVERAGED (else the value is copied
// unfiltered); GI_PACKED (the result is filtered again or upsampled; else it is final); GI_BENT.
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "ambient_occlusion/raw.glsl"
#include "lib/alike.glsl"

layout(binding = 0) uniform usampler2D rawTexture;

#ifdef GI_PACKED
layout(location = 0) out GI_RAW result;
#else
layout(location = 0) out GI_OPEN result;
#endif

#ifdef GI_DOWN
const ivec2 ALONG = ivec2(0, 1);
#else
const ivec2 ALONG = ivec2(1, 0);
#endif

#ifdef GI_AVERAGED
const int REACH = 2; // texels to either side
#else
const int REACH = 0;
#endif

void main()
{
  ivec2 raw = ivec2(gl_FragCoord.xy);
  GI_RAW centre = GI_RAW_OF(texelFetch(rawTexture, raw, 0));
  float depth = giRawDepth(centre);
  vec2 normal = giRawNormal(centre);
  float openness = 1.0;
  vec3 hidden = vec3(0.0);
  if (depth < 1.0)
  {
    GiSurfel here = giSurfel(vec2(giRawPixel(raw)) + 0.5, depth, normal, float(GI_STRIDE));
    ivec2 low = ivec2(view.Viewport.xy) / GI_STRIDE;
    ivec2 high = ivec2(view.Viewport.xy + view.Viewport.zw - 1.0) / GI_STRIDE;
    float sum = 0.0;
    float weights = 0.0;
    for (int i = -REACH; i <= REACH; ++i)
    {
      ivec2 at = clamp(raw + i * ALONG, low, high);
      GI_RAW other = GI_RAW_OF(texelFetch(rawTexture, at, 0));
      vec2 offset = vec2((at - raw) * GI_STRIDE);
      float weight = (abs(i) == 2 ? 0.5 : 1.0) *
        giSimilarity(here, offset, giRawDepth(other), giRawNormal(other));
      sum += weight * giRawOpenness(other);
      hidden += weight * giRawHidden(other);
      weights += weight;
    }
    openness = sum / max(weights, 1e-6);
    hidden /= max(weights, 1e-6);
  }
#ifdef GI_PACKED
  result = giPackRaw(openness, depth, normal, hidden);
#else
  result = giOpen(openness, giDecodeOctahedral(normal), hidden);
#endif
}
