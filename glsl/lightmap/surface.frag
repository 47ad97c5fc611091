#version 430 core
// Baked light on the pixels that show its surface. Variants: GI_LIGHTMAP_DIRECTIONAL (the map holds first moments
// too, for normals that pictures bend).
#include "lightmap/nearer.glsl"
layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2DArray lightTexture;
#ifdef GI_LIGHTMAP_DIRECTIONAL
#include "lib/octahedral.glsl"
layout(binding = 2) uniform sampler2D normalTexture;
uniform mat3 viewToWorld;
in vec3 normalWC;
#endif

uniform float intensity;

in vec2 mapPlace;

layout(location = 0) out vec4 irradiance;

// Of a depth buffer of 24 bits, which another program fills: four of its last digits, and what rounding of corners
// to a fraction of a pixel comes to on a slope.
const float DIGITS = 2.4e-7;
const float PIXELS = 0.02;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  // What moves right before the surface is lit by another technique.
  float apart = abs(texelFetch(depthTexture, pixel, 0).r - (gl_FragCoord.z + GI_LIGHTMAP_NEARER));
  if (apart > DIGITS + PIXELS * fwidth(gl_FragCoord.z))
  {
    discard;
  }
  vec3 light = textureLod(lightTexture, vec3(mapPlace, 0.0), 0.0).rgb;
#ifdef GI_LIGHTMAP_DIRECTIONAL
  // Of irradiance in spherical harmonics, bands 0 and 1 differ between two normals by the mean of radiance times
  // its direction (Ramamoorthi and Hanrahan 2001, An Efficient Representation for Irradiance Environment Maps).
  vec3 now = viewToWorld * giDecodeOctahedral(texelFetch(normalTexture, pixel, 0).xy);
  vec3 bent = now - normalize(normalWC);
  light += bent.x * textureLod(lightTexture, vec3(mapPlace, 1.0), 0.0).rgb +
    bent.y * textureLod(lightTexture, vec3(mapPlace, 2.0), 0.0).rgb +
    bent.z * textureLod(lightTexture, vec3(mapPlace, 3.0), 0.0).rgb;
  light = max(light, vec3(0.0));
#endif
  irradiance = vec4(intensity * light, 1.0);
}
