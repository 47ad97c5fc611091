#version 430 core
// Applies baked light to the pixels that show its surface. Variants: GI_LIGHTMAP_DIRECTIONAL (the map also holds first
// moments, for normal maps), GI_LIGHTMAP_LAMPS (and the lights' direct light), GI_LIGHTMAP_HOLES (some
// surfaces may have holes; else a depth test has left only pixels that show the map's surface).
#ifdef GI_LIGHTMAP_HOLES
layout(binding = 0) uniform sampler2D depthTexture;
#endif
layout(binding = 1) uniform sampler2DArray lightTexture;
#ifdef GI_LIGHTMAP_DIRECTIONAL
#include "lib/octahedral.glsl"
layout(binding = 2) uniform sampler2D normalTexture;
uniform mat3 viewToWorld;
in vec3 normalWC;
const int LAYERS = 4; // per kind of light
#else
const int LAYERS = 1;
#endif

uniform float intensity;

in vec2 mapPlace;

layout(location = 0) out vec4 irradiance;
#ifdef GI_LIGHTMAP_LAMPS
layout(location = 1) out vec4 lampLight;
#endif

#ifdef GI_LIGHTMAP_HOLES
// Tolerances of a 24-bit depth buffer that another program filled: four units in the last place, and the effect
// on slopes of rounding corners to a fraction of a pixel.
const float DIGITS = 2.4e-7;
const float PIXELS = 0.02;
#endif

vec3 layer(int number)
{
  return textureLod(lightTexture, vec3(mapPlace, float(number)), 0.0).rgb;
}

#ifdef GI_LIGHTMAP_DIRECTIONAL
// First moment along a vector.
vec3 along(vec3 direction, int first)
{
  return direction.x * layer(first + 1) + direction.y * layer(first + 2) + direction.z * layer(first + 3);
}

// Difference of the light at a shading normal from the light at the baked normal. To first order it is twice the moment
// along the change of the normal, as light that sinks below the horizon had no share in the baked light. To second
// order the cosine reduces it, except for light that has sunk. The moment along the baked normal tells how much, at
// most as if no light could sink.
vec3 differenceAt(vec3 shadingNormal, vec3 bakedNormal, vec3 light, int first)
{
  float cosine = dot(shadingNormal, bakedNormal);
  vec3 lost = 2.0 * clamp(along(bakedNormal, first), vec3(0.0), 0.5 * light);
  return 2.0 * along(shadingNormal - cosine * bakedNormal, first) - (1.0 - cosine) * lost;
}

// Light plus its difference, never below 0. It falls between linearly, as light from a point does, and as a parabola,
// as light from half the sky does.
vec3 addDifference(vec3 light, vec3 difference)
{
  vec3 kept = max(light + min(difference, 0.0) / 1.5, 0.0);
  return kept * sqrt(kept / max(light, 1e-9)) + max(difference, 0.0);
}
#endif

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef GI_LIGHTMAP_HOLES
  // Surfaces in front of the baked one, however close, and surfaces seen through its holes are lit by other techniques.
  float apart = abs(texelFetch(depthTexture, pixel, 0).r - gl_FragCoord.z);
  if (apart > DIGITS + PIXELS * fwidth(gl_FragCoord.z))
  {
    discard;
  }
#endif
  vec3 light = layer(0);
#ifdef GI_LIGHTMAP_LAMPS
  vec3 lamps = layer(LAYERS);
#endif
#ifdef GI_LIGHTMAP_DIRECTIONAL
  vec3 bakedNormal = normalize(normalWC);
  vec3 shadingNormal = viewToWorld * giDecodeOctahedral(texelFetch(normalTexture, pixel, 0).xy);
  light = addDifference(light, differenceAt(shadingNormal, bakedNormal, light, 0));
#ifdef GI_LIGHTMAP_LAMPS
  // Light from a single direction falls linearly with the cosine to zero.
  lamps = max(lamps + differenceAt(shadingNormal, bakedNormal, lamps, LAYERS), vec3(0.0));
#endif
#endif
  irradiance = vec4(intensity * light, 1.0);
#ifdef GI_LIGHTMAP_LAMPS
  lampLight = vec4(lamps, 1.0);
#endif
}
