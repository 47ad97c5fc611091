#version 430 core
// Adds reflections to the picture: where rays hit something, they replace the light of the surroundings
// that VTK reflects there. Variants: GI_EXTENDED (textures, PBR), GI_SURROUNDINGS (VTK's image-based
// reflection is known separately), GI_IRRADIANCE (a technique supplies indirect light),
// GI_AMBIENT_VISIBILITY, GI_RADIANCE (linear radiance, not the colour for display),
// GI_LIT_PARTS (resource::LitShown or LitEncoded), GI_DATA_COLORS (as in direct_light/resolve.frag), GI_DEBUG (show how
// rays ended).
#include "shared/view.h"
#include "shared/material.h"
#include "shared/reflection.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/pbr.glsl"
#include "lib/sampling.glsl"
#include "screen_space_reflections/lobe.glsl"

layout(binding = 5) uniform sampler2D before;  // the picture
layout(binding = 6) uniform sampler2D litTexture;
layout(binding = 7) uniform sampler2D reflectionTexture;
#ifdef GI_SURROUNDINGS
layout(binding = 8) uniform sampler2D surroundingsTexture;
#endif
#ifdef GI_AMBIENT_VISIBILITY
layout(binding = 9) uniform sampler2D ambientVisibility;
#endif
#if defined(GI_IRRADIANCE) && !defined(GI_SURROUNDINGS)
layout(binding = 11) uniform sampler2D irradianceTexture;
#endif
#ifdef GI_DEBUG
layout(binding = 10) uniform sampler2D endTexture;
uniform int debugView; // 1: reasons, 2: confidence
#endif

uniform vec3 ambientLight; // radiance that a white diffuse surface reflects from uniform surroundings
uniform float keep;        // 1: the light of the surroundings replaces missing reflections; 0: nothing does

layout(location = 0) out vec4 color;

vec3 withReflection(ivec2 window, vec3 radiance, Lobe lobe)
{
  vec4 reflection = texelFetch(reflectionTexture, window, 0);
  float known = mix(1.0, reflection.a, keep);
  float openness = 1.0;
#ifdef GI_AMBIENT_VISIBILITY
  openness = texelFetch(ambientVisibility, window, 0).r;
#endif
  vec3 surroundings = vec3(0.0); // the part that direct_light/resolve.frag has added
#ifdef GI_SURROUNDINGS
  surroundings = texelFetch(surroundingsTexture, window, 0).rgb;
#endif
  float lit = 1.0; // factor of reflected light
  vec3 light = ambientLight;
  vec3 indirect = vec3(0.0); // light that metal reflects as if it were matte, as long as no reflection is known
#if defined(GI_IRRADIANCE) && !defined(GI_SURROUNDINGS)
  indirect = texelFetch(irradianceTexture, window, 0).rgb;
#endif
#ifdef GI_DATA_COLORS
  vec4 normal = texelFetch(normalTexture, window, 0);
  if ((materials[int(normal.z * 65535.0 + 0.5)].Model.y & GI_MATERIAL_DATA) != 0)
  {
    reflection.rgb = giDataLight(reflection.rgb);
    light = giDataLight(light);
    indirect = giDataLight(indirect);
    vec3 albedo = texelFetch(albedoTexture, window, 0).rgb;
#ifdef GI_EXTENDED
    float metallic = lobe.pbr ? texelFetch(surfaceTexture, window, 0).r : 0.0;
    vec3 reflectance = (1.0 - metallic) * (1.0 - lobe.f0) * albedo + lobe.f0;
    surroundings = giDataReflected(surroundings, reflectance);
#endif
    lit = giDataLit(lobe.pbr);
  }
#endif
#ifdef GI_EXTENDED
  surroundings += lobe.pbr ? texelFetch(surfaceTexture, window, 0).g * (light / GI_PI + indirect) * lobe.f0 : vec3(0.0);
#endif
  vec3 missing = lobe.pbr ? vec3(0.0) : (1.0 - known) * lobe.color * light;
  return max(
    radiance + lit * (lobe.color * reflection.rgb + openness * (missing - known * surroundings)), 0.0);
}

#ifdef GI_DEBUG
// The legend is in docs/techniques/screen-space-reflections.md.
const vec3 LEGEND[GI_REFLECTION_ENDS] = vec3[](vec3(0.0), vec3(0.1, 0.7, 0.1), vec3(0.9, 0.2, 0.2),
  vec3(0.6, 0.2, 0.8), vec3(1.0, 1.0, 1.0), vec3(0.5, 0.35, 0.2), vec3(0.95, 0.85, 0.1),
  vec3(0.2, 0.4, 0.95), vec3(0.95, 0.55, 0.1), vec3(0.35, 0.35, 0.35), vec3(0.0, 0.0, 0.0),
  vec3(0.1, 0.8, 0.85));

vec3 painted(ivec2 window, vec3 shown)
{
  vec4 end = texelFetch(endTexture, window, 0);
  int reason = int(end.z);
  vec3 grey = vec3(0.25 + 0.35 * giLuminance(shown));
  return debugView == 2 ? vec3(texelFetch(reflectionTexture, window, 0).a)
    : reason == GI_REFLECTION_NONE ? grey
    : LEGEND[reason] * (reason == GI_REFLECTION_HIT ? 0.3 + 0.7 * end.w : 1.0);
}
#endif

void main()
{
  ivec2 window = ivec2(gl_FragCoord.xy);
  color = texelFetch(before, window, 0);
  if (texelFetch(albedoTexture, window, 0).a == 0.0)
  {
    return;
  }
  vec3 P = giViewPosition(gl_FragCoord.xy, texelFetch(depthTexture, window, 0).r);
  Lobe lobe = lobeAt(window, P);
#ifdef GI_DEBUG
  color.rgb = painted(window, color.rgb);
  return;
#endif
  if (isTraced(lobe))
  {
    vec3 radiance = withReflection(window, texelFetch(litTexture, window, 0).rgb, lobe);
#if defined(GI_LIT_PARTS)
    color.rgb = color.a * radiance; // a: share of the pixel
#elif defined(GI_RADIANCE)
    color.rgb = radiance;
#else
    color.rgb = lobe.pbr ? pow(radiance, vec3(1.0 / 2.2)) : radiance;
#endif
  }
}
