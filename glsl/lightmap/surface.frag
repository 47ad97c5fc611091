#version 430 core
// Baked light on the pixels that show its surface. Variants: GI_LIGHTMAP_DIRECTIONAL (the map holds first moments
// too, for normals that pictures bend), GI_LIGHTMAP_LAMPS (and light straight from lamps), GI_LIGHTMAP_HOLES (some
// surface may be seen through; else a depth test has left only pixels that show the map's).
#ifdef GI_LIGHTMAP_HOLES
layout(binding = 0) uniform sampler2D depthTexture;
#endif
layout(binding = 1) uniform sampler2DArray lightTexture;
#ifdef GI_LIGHTMAP_DIRECTIONAL
#include "lib/octahedral.glsl"
layout(binding = 2) uniform sampler2D normalTexture;
uniform mat3 viewToWorld;
in vec3 normalWC;
const int LAYERS = 4; // of one kind of light
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
// Of a depth buffer of 24 bits, which another program fills: four of its last digits, and what rounding of corners
// to a fraction of a pixel comes to on a slope.
const float DIGITS = 2.4e-7;
const float PIXELS = 0.02;
#endif

vec3 layer(int number)
{
  return textureLod(lightTexture, vec3(mapPlace, float(number)), 0.0).rgb;
}

#ifdef GI_LIGHTMAP_DIRECTIONAL
// By how much more light along the bent normal than along the baked one, by first moments.
vec3 turned(vec3 bent, int first)
{
  return bent.x * layer(first + 1) + bent.y * layer(first + 2) + bent.z * layer(first + 3);
}
#endif

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef GI_LIGHTMAP_HOLES
  // What hides the surface, be it by a hair, is lit by another technique, and so is what is seen through it.
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
  vec3 now = viewToWorld * giDecodeOctahedral(texelFetch(normalTexture, pixel, 0).xy);
  vec3 bent = now - normalize(normalWC);
  // Of irradiance in spherical harmonics, bands 0 and 1 differ between two normals by the mean of radiance times
  // its direction (Ramamoorthi and Hanrahan 2001, An Efficient Representation for Irradiance Environment Maps).
  light = max(light + turned(bent, 0), vec3(0.0));
#ifdef GI_LIGHTMAP_LAMPS
  // A lamp's grows with the cosine: by twice the mean, as long as the lamp is above the surface.
  lamps = max(lamps + 2.0 * turned(bent, LAYERS), vec3(0.0));
#endif
#endif
  irradiance = vec4(intensity * light, 1.0);
#ifdef GI_LIGHTMAP_LAMPS
  lampLight = vec4(lamps, 1.0);
#endif
}
