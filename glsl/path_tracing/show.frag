#version 430 core
// Mean of the samples so far. Variants: GI_RADIANCE (linear radiance, not the colour for display), GI_LIT_PARTS
// (resource::LitShown and LitEncoded), GI_FILTERED (with resource::PathLight), and those of path_tracing/means.glsl.
#include "lib/filter_reach.glsl"
#include "path_tracing/means.glsl"
layout(binding = 2) uniform sampler2D colorTexture;
#ifdef GI_FILTERED
layout(binding = 6) uniform sampler2D pathLight;
#endif

const float NEVER = 1e9;
const float LAST = 256.0; // samples from which the mean is shown as it is, as by the filter

layout(location = 0) out vec4 color;
#ifdef GI_LIT_PARTS
layout(location = 1) out vec4 secondPart;
#endif

// What filtering adds to each sample of a lit surface: exactly 0 where nothing is filtered.
vec3 addedTo(ivec2 pixel, GiLit lit)
{
#ifdef GI_FILTERED
  vec3 filtered = (texelFetch(pathLight, pixel, 0).rgb - giMeanLight(pixel, lit)) * giMeanColor(pixel);
  return filtered + giReachAfter(vec4(samples), NEVER, LAST).x * giFineDifference(pixel, lit);
#else
  return vec3(0.0);
#endif
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 shown = texelFetch(sumShown, pixel, 0);
  vec3 encoded = texelFetch(sumEncoded, pixel, 0).rgb;
  GiLit lit = giLit(pixel);
  vec3 added = addedTo(pixel, lit);
#ifdef GI_RADIANCE
  color.rgb = (shown.rgb + encoded + added * (lit.shownCount + lit.encodedCount)) / samples;
  color.a = texelFetch(colorTexture, pixel, 0).a;
#else
  lit.shown += added * lit.shownCount;
#ifdef GI_LIT_PARTS
  lit.encoded += added * lit.encodedCount;
  color = vec4(lit.shownCount * giMeanOf(lit.shown, lit.shownCount), lit.shownCount) / samples;
  secondPart = vec4(lit.encodedCount * giMeanOf(lit.encoded, lit.encodedCount), lit.encodedCount) / samples;
#else
  // The part of the pixel that PBR surfaces cover is averaged first and then encoded as in VTK. No surface is brighter
  // than white, as in the rasterizer's averages.
  encoded += added * lit.encodedCount;
  vec3 mean = min(pow(giMeanOf(encoded, shown.a), vec3(1.0 / 2.2)), 1.0);
  vec3 unlit = texelFetch(sumUnlit, pixel, 0).rgb;
  color.rgb = (unlit + lit.shownCount * min(giMeanOf(lit.shown, lit.shownCount), 1.0) + shown.a * mean) / samples;
  color.a = texelFetch(colorTexture, pixel, 0).a;
#endif
#endif
}
