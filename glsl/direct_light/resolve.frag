#version 430 core
// Lights the G-buffer. Variants: GI_EXTENDED (textures, PBR), GI_SPECULAR (some Phong
// highlights), GI_HEADLIGHT (a single headlight, lit by VTK's shorter formula),
// GI_POSITIONAL (some positional lights), GI_AREA (some spheres, discs or rectangles), GI_AMBIENT (some surfaces may have an ambient
// term), GI_DIRECT_VISIBILITY, GI_AMBIENT_VISIBILITY,
// GI_IRRADIANCE (indirect light is known), GI_SURROUNDINGS (the highlights' reflection of the environment is known
// separately), GI_LAMP_LIGHT (diffuse light from lights that do not follow the camera is known), GI_INTERREFLECTION
// (occluders of ambient light reflect it too), GI_CATCHER (some surfaces show the background), GI_COVERAGE (fragments
// that cover a pixel partly, to be blended), GI_RADIANCE (write linear radiance instead of the colour for display),
// GI_LIT (write both), GI_LIT_PARTS (also write resource::LitShown and LitEncoded), GI_DATA_COLORS (surfaces coloured by
// data are lit by lib/data_colors.glsl), GI_DISPLAY (the colour is mapped by tone_mapping/forward.glsl), GI_PRESENT_DEPTH
// (also write the depth as the window's).
#include "shared/view.h"
#include "shared/light.h"
#include "shared/material.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/phong.glsl"
#include "lib/pbr.glsl"
#include "lib/lights.glsl"
#include "lib/compensation.glsl"
#include "lib/interreflection.glsl"
#ifdef GI_AREA
#include "lib/sampling.glsl"
#include "lib/area_lights.glsl"
#include "lib/area_highlights.glsl"
#endif
#ifdef GI_DATA_COLORS
#include "lib/data_colors.glsl"
#endif
#ifdef GI_DISPLAY
#include "tone_mapping/forward.glsl"
#endif

layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D albedoTexture;
layout(binding = 2) uniform sampler2D normalTexture;
layout(binding = 3) uniform sampler2D ambientTexture;
layout(binding = 4) uniform sampler2D surfaceTexture;
layout(binding = 5) uniform sampler2D emissionTexture;
layout(binding = 6) uniform sampler2DArray directVisibility;
layout(binding = 7) uniform sampler2D ambientVisibility;
layout(binding = 8) uniform sampler2D irradianceTexture;
layout(binding = 9) uniform sampler2D surroundingsTexture;
layout(binding = 10) uniform sampler2D lampLightTexture;
#include "lib/direct_visibility.glsl"

#ifdef GI_PRESENT_DEPTH
#include "direct_light/window_depth.glsl"
#endif

uniform int lightCount;
uniform int catcher; // material of what shows the background
uniform float interreflection; // share of the surfaces' reflectance
uniform vec3 ambientLight; // radiance that a white diffuse surface reflects from uniform surroundings

layout(location = 0) out vec4 color;
#ifdef GI_LIT
layout(location = 1) out vec4 lit;
#define GI_FIRST_PART 2
#define GI_SECOND_PART 3
#else
#define GI_FIRST_PART 1
#define GI_SECOND_PART 2
#endif
#ifdef GI_LIT_PARTS
layout(location = GI_FIRST_PART) out vec4 litShown;
layout(location = GI_SECOND_PART) out vec4 litEncoded;
#endif

// Radiance as the display shows it.
vec3 displayed(vec3 radiance, int index, bool encoded)
{
#ifdef GI_DISPLAY
  return index == GI_MATERIAL_AS_DRAWN ? radiance : giDisplayed(radiance, encoded);
#else
  return radiance;
#endif
}

// Factor of the ambient light.
vec3 ambientFactor(float openness, vec3 reflectance)
{
#ifdef GI_INTERREFLECTION
  return giInterreflected(openness, interreflection * reflectance);
#else
  return vec3(openness);
#endif
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 albedo = texelFetch(albedoTexture, pixel, 0);
  if (albedo.a == 0.0)
  {
    discard;
  }
  vec4 packedNormal = texelFetch(normalTexture, pixel, 0);
  vec3 ambient = vec3(0.0);
#ifdef GI_AMBIENT
  ambient = texelFetch(ambientTexture, pixel, 0).rgb;
#endif
#ifdef GI_COVERAGE
  // The values were blended over black and are thus multiplied by the coverage.
  albedo.rgb /= albedo.a;
  ambient /= albedo.a;
#endif
  int index = int(packedNormal.z * 65535.0 + 0.5);
#ifdef GI_CATCHER
  if (index == catcher)
  {
    discard;
  }
#endif
#ifdef GI_PRESENT_DEPTH
  gl_FragDepth = giWindowDepth(texelFetch(depthTexture, pixel, 0).r);
#endif
  float openness = 1.0;
#ifdef GI_AMBIENT_VISIBILITY
  openness = index == GI_MATERIAL_AS_DRAWN ? 1.0 : texelFetch(ambientVisibility, pixel, 0).r;
#endif

  vec4 indirect = vec4(0.0); // a: share of the light that is known
#ifdef GI_IRRADIANCE
  indirect = texelFetch(irradianceTexture, pixel, 0);
#endif

  vec3 N = giDecodeOctahedral(packedNormal.xy);
#if defined(GI_POSITIONAL) || defined(GI_SPECULAR) || defined(GI_EXTENDED)
  vec3 P = giViewPosition(gl_FragCoord.xy, texelFetch(depthTexture, pixel, 0).r);
  vec3 V = normalize(-P); // in a parallel projection too, as in VTK
#else
  vec3 P = vec3(0.0);
  vec3 V = vec3(0.0, 0.0, 1.0);
#endif
#if defined(GI_SPECULAR) || defined(GI_EXTENDED) || defined(GI_DATA_COLORS)
  MaterialData material = materials[index];
#endif

  vec3 around = ambientLight;
  vec3 ownColor = albedo.rgb; // reflectance of occluders of ambient light
#ifdef GI_DATA_COLORS
  bool data = (material.Model.y & GI_MATERIAL_DATA) != 0;
  around = data ? giDataLight(around) : around;
  indirect.rgb = data ? giDataLight(indirect.rgb) : indirect.rgb;
  ownColor = data ? giDataLight(ownColor) : ownColor;
#endif
  vec4 lampLight = vec4(0.0); // a: share of the lights' diffuse light that is known
#ifdef GI_LAMP_LIGHT
  lampLight = texelFetch(lampLightTexture, pixel, 0);
#endif

  vec3 diffuseLight = lampLight.rgb; // arriving light for the diffuse reflection
  vec3 gloss = vec3(0.0); // light for a Phong highlight; all reflected light for PBR
#ifdef GI_EXTENDED
  bool pbr = material.Model.x == GI_MATERIAL_PBR;
  vec3 boost = vec3(1.0);
  vec4 surface = texelFetch(surfaceTexture, pixel, 0);
  vec3 f0 = mix(vec3(material.Specular.w), albedo.rgb, surface.r);
  vec3 f90 = mix(vec3(clamp(dot(f0, vec3(50.0 * 0.33)), 0.0, 1.0)), material.Specular.rgb, surface.r);
  if (giCompensates)
  {
    boost = giCompensation(f0, giHighlightShare(clamp(dot(N, V), 1e-5, 1.0), surface.b));
  }
#endif
  for (int i = 0; i < lightCount; ++i)
  {
    LightData light = lights[i];
    float diffuseShare = 1.0; // share of the light that is not in lampLight
#ifdef GI_LAMP_LIGHT
    diffuseShare = light.Kind.w != 0 ? 1.0 - lampLight.a : 1.0;
#if !defined(GI_SPECULAR) && !defined(GI_EXTENDED)
    if (diffuseShare == 0.0)
    {
      continue;
    }
#endif
#endif
    vec3 strength = light.Color.rgb * giDirectVisibility(pixel, light.Kind.y);
#ifdef GI_EXTENDED
    if (pbr)
    {
#ifdef GI_HEADLIGHT
      vec3 L = V;
#else
      GiIncident incident = giIncident(light, P);
      strength *= incident.Attenuation;
      vec3 L = -incident.Travel;
#ifdef GI_AREA
      if (giHasArea(light))
      {
        float lit = giAreaFacing(light, P, N);
        gloss += lit > 0.0
          ? strength * giAreaPBR(light, P, N, V, lit, albedo.rgb, surface.r, surface.b, f0, f90, boost, diffuseShare)
          : vec3(0.0);
        continue;
      }
#endif
#endif
      gloss += strength * giReflectPBR(N, V, L, albedo.rgb, surface.r, surface.b, f0, f90, boost, diffuseShare);
      continue;
    }
#endif
#ifdef GI_HEADLIGHT
    float facing = max(0.000001, N.z);
    diffuseLight += diffuseShare * facing * strength;
#ifdef GI_SPECULAR
    gloss += pow(facing, material.Specular.w) * strength;
#endif
#else
    GiIncident incident = giIncident(light, P);
    float facing = max(0.0, incident.Attenuation * dot(N, -incident.Travel));
#ifdef GI_AREA
    facing = giHasArea(light) ? incident.Attenuation * giAreaFacing(light, P, N) : facing;
#endif
    diffuseLight += diffuseShare * facing * strength;
#if defined(GI_SPECULAR) && defined(GI_AREA)
    if (giHasArea(light))
    {
      gloss += facing > 0.0
        ? incident.Attenuation * giAreaPhong(light, P, N, V, material.Specular.w) * strength
        : vec3(0.0);
      continue;
    }
#endif
#ifdef GI_SPECULAR
    gloss += facing > 0.0
      ? incident.Attenuation * giPhongSpecular(N, incident.Travel, V, material.Specular.w) * strength
      : vec3(0.0);
#endif
#endif
  }

#ifdef GI_EXTENDED
  vec3 emission = texelFetch(emissionTexture, pixel, 0).rgb;
#ifdef GI_COVERAGE
  emission /= albedo.a;
#endif
  vec3 result;
  if (pbr)
  {
    // VTK's PBR materials reflect 1 / pi of the light that its Phong materials reflect.
    vec3 matte = (1.0 - surface.r) * (1.0 - f0) * albedo.rgb;
    vec3 reflectance = matte + f0;
    vec3 surroundings = around / GI_PI * reflectance;
#ifdef GI_LAMP_LIGHT
    gloss += diffuseLight / GI_PI * matte;
#endif
#ifdef GI_SURROUNDINGS
    // The known indirect light contains the diffusely reflected light of the environment.
    ambient = mix(ambient, texelFetch(surroundingsTexture, pixel, 0).rgb, indirect.a);
    surroundings += indirect.rgb * matte;
#else
    surroundings += indirect.rgb * reflectance;
#endif
    vec3 occluders = reflectance;
#ifdef GI_DATA_COLORS
    ambient = data ? giDataReflected(ambient, reflectance) : ambient;
    occluders = data ? giDataLight(reflectance) : reflectance;
#endif
    result = ambientFactor(openness, occluders) * (ambient + surface.g * surroundings) +
      surface.g * gloss + emission;
#ifdef GI_DATA_COLORS
    result = data ? mix(albedo.rgb, result, giDataLit(true)) : result;
#endif
    color.rgb = pow(max(displayed(result, index, true), 0.0), vec3(1.0 / 2.2));
  }
  else
  {
    result = ambientFactor(openness, ownColor) * (ambient + albedo.rgb * (around + indirect.rgb)) +
      albedo.rgb * diffuseLight + material.Specular.rgb * surface.rgb * gloss + emission;
#ifdef GI_DATA_COLORS
    result = data ? mix(albedo.rgb, result, giDataLit(false)) : result;
#endif
    color.rgb = displayed(result, index, false);
  }
#else
  vec3 result = ambientFactor(openness, ownColor) * (ambient + albedo.rgb * (around + indirect.rgb)) +
    albedo.rgb * diffuseLight;
#ifdef GI_SPECULAR
  result += material.Specular.rgb * gloss;
#endif
#ifdef GI_DATA_COLORS
  result = data ? mix(albedo.rgb, result, giDataLit(false)) : result;
#endif
  color.rgb = displayed(result, index, false);
#endif
#ifdef GI_RADIANCE
  color.rgb = result;
#endif
  color.a = 1.0;
#ifdef GI_COVERAGE
  color.a = albedo.a;
#endif
#ifdef GI_LIT
  lit = vec4(result, color.a);
#endif
#ifdef GI_LIT_PARTS
  vec4 part = index == GI_MATERIAL_AS_DRAWN ? vec4(0.0) : vec4(result, color.a);
#ifdef GI_EXTENDED
  litShown = pbr ? vec4(0.0) : part;
  litEncoded = pbr ? part : vec4(0.0);
#else
  litShown = part;
  litEncoded = vec4(0.0);
#endif
#endif
}
