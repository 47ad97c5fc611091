// Sums of samples and their means. Variants: GI_VISIBLE_SKY (a skybox is behind everything), GI_FILTERED (light is filtered).
layout(binding = 0) uniform sampler2D sumShown;
layout(binding = 1) uniform sampler2D sumEncoded;
layout(binding = 3) uniform sampler2D sumUnlit;
layout(binding = 4) uniform sampler2D sumAlbedo;
#ifdef GI_FILTERED
layout(binding = 7) uniform sampler2D sumCertain;
layout(binding = 8) uniform sampler2D sumFine;
#endif
#ifdef GI_VISIBLE_SKY
#include "lib/sky.glsl"
layout(binding = 5) uniform sampler2D skyTexture;
#endif

uniform float samples;

// Sums over the samples of a pixel that met lit surfaces, and the numbers of these samples.
struct GiLit
{
  vec3 shown; // whose values VTK shows as they are
  float shownCount;
  vec3 encoded; // whose values VTK encodes for display
  float encodedCount;
};

GiLit giLit(ivec2 pixel)
{
  vec4 shown = texelFetch(sumShown, pixel, 0);
  vec4 unlit = texelFetch(sumUnlit, pixel, 0);
  GiLit lit = GiLit(shown.rgb - unlit.rgb, samples - shown.a - unlit.a, texelFetch(sumEncoded, pixel, 0).rgb, shown.a);
#ifdef GI_VISIBLE_SKY
  vec4 sky = texelFetch(skyTexture, pixel, 0);
  float skyCount = sky.a > 0.5 ? samples - texelFetch(sumAlbedo, pixel, 0).a : 0.0;
  lit.encodedCount -= min(skyCount, lit.encodedCount);
  lit.encoded -= skyCount * giSkyRadiance(sky);
#endif
  return lit;
}

vec3 giMeanOf(vec3 sum, float count)
{
  return count > 0.0 ? max(sum / count, 0.0) : vec3(0.0);
}

#ifdef GI_FILTERED
// What light is divided by before it is filtered: the mean colour of the surfaces. Dark ones reflect highlights too.
vec3 giMeanColor(ivec2 pixel)
{
  vec4 albedo = texelFetch(sumAlbedo, pixel, 0);
  return max(albedo.rgb / max(albedo.a, 1.0), 0.02);
}

// What lit surfaces show without chance, see path_tracing/certain.comp.
vec3 giMeanCertain(ivec2 pixel, GiLit lit)
{
  vec4 certain = texelFetch(sumCertain, pixel, 0);
  return giMeanOf(certain.rgb * (samples / max(certain.a, 1.0)), lit.shownCount + lit.encodedCount);
}

// The same at more points, as a difference; 0 where light is broken.
vec3 giFineDifference(ivec2 pixel, GiLit lit)
{
  vec4 fine = texelFetch(sumFine, pixel, 0);
  vec3 difference = fine.rgb / max(fine.a, 1.0) - giMeanCertain(pixel, lit);
  return fine.a > 0.0 && !any(isnan(difference)) && !any(isinf(difference)) ? difference : vec3(0.0);
}

// What they show by chance.
vec3 giMeanReflected(ivec2 pixel, GiLit lit)
{
  return max(giMeanOf(lit.shown + lit.encoded, lit.shownCount + lit.encodedCount) - giMeanCertain(pixel, lit), 0.0);
}

// Mean light on them.
vec3 giMeanLight(ivec2 pixel, GiLit lit)
{
  return giMeanReflected(pixel, lit) / giMeanColor(pixel);
}
#endif
