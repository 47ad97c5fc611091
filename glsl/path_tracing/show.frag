#version 430 core
// Mean of the samples so far. Variants: GI_RADIANCE (linear radiance, not the colour for display), GI_LIT_PARTS
// (resource::LitShown and LitEncoded), GI_VISIBLE_SKY (a skybox is behind everything).
layout(binding = 0) uniform sampler2D sumShown;
layout(binding = 1) uniform sampler2D sumEncoded;
layout(binding = 2) uniform sampler2D colorTexture;
layout(binding = 3) uniform sampler2D sumUnlit;
#ifdef GI_LIT_PARTS
layout(binding = 4) uniform sampler2D sumAlbedo;
#ifdef GI_VISIBLE_SKY
#include "lib/sky.glsl"
layout(binding = 5) uniform sampler2D skyTexture;
#endif
#endif

uniform float samples;

layout(location = 0) out vec4 color;
#ifdef GI_LIT_PARTS
layout(location = 1) out vec4 secondPart;
#endif

vec3 meanOf(vec3 sum, float count)
{
  return count > 0.0 ? max(sum / count, 0.0) : vec3(0.0);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 shown = texelFetch(sumShown, pixel, 0);
  vec3 encoded = texelFetch(sumEncoded, pixel, 0).rgb;
#ifdef GI_RADIANCE
  color.rgb = (shown.rgb + encoded) / samples;
  color.a = texelFetch(colorTexture, pixel, 0).a;
#else
  vec4 unlit = texelFetch(sumUnlit, pixel, 0);
  float shownCount = samples - shown.a - unlit.a; // of lit surfaces whose values VTK shows as they are
  vec3 shownSum = shown.rgb - unlit.rgb;
#ifdef GI_LIT_PARTS
  float encodedCount = shown.a;
#ifdef GI_VISIBLE_SKY
  vec4 sky = texelFetch(skyTexture, pixel, 0);
  float skyCount = sky.a > 0.5 ? samples - texelFetch(sumAlbedo, pixel, 0).a : 0.0;
  encodedCount -= min(skyCount, encodedCount);
  encoded -= skyCount * giSkyRadiance(sky);
#endif
  color = vec4(shownCount * meanOf(shownSum, shownCount), shownCount) / samples;
  secondPart = vec4(encodedCount * meanOf(encoded, encodedCount), encodedCount) / samples;
#else
  // The part of the pixel that PBR surfaces cover is averaged first and then encoded as in VTK. No surface is brighter
  // than white, as in the rasterizer's averages.
  vec3 mean = min(pow(meanOf(encoded, shown.a), vec3(1.0 / 2.2)), 1.0);
  color.rgb = (unlit.rgb + shownCount * min(meanOf(shownSum, shownCount), 1.0) + shown.a * mean) / samples;
  color.a = texelFetch(colorTexture, pixel, 0).a;
#endif
#endif
}
