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
// The first moments along a vector.
vec3 along(vec3 direction, int first)
{
  return direction.x * layer(first + 1) + direction.y * layer(first + 2) + direction.z * layer(first + 3);
}

// What a normal meets more than the baked one. To first order that is twice the moments along its turn, as what sinks below
// the horizon had no share in the baked light. To second order the cosine takes from it, but nothing from light that has
// sunk: the moment along the baked normal knows how much, at most as if none could sink.
vec3 gained(vec3 now, vec3 baked, vec3 light, int first)
{
  float cosine = dot(now, baked);
  vec3 lost = 2.0 * clamp(along(baked, first), vec3(0.0), 0.5 * light);
  return 2.0 * along(now - cosine * baked, first) - (1.0 - cosine) * lost;
}

// Light with what it gains. It never falls below 0: between a straight line, as a point's light falls, and a parabola, as that of
// half the sky does.
vec3 turned(vec3 light, vec3 gain)
{
  vec3 kept = max(light + min(gain, 0.0) / 1.5, 0.0);
  return kept * sqrt(kept / max(light, 1e-9)) + max(gain, 0.0);
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
  vec3 baked = normalize(normalWC);
  vec3 now = viewToWorld * giDecodeOctahedral(texelFetch(normalTexture, pixel, 0).xy);
  light = turned(light, gained(now, baked, light, 0));
#ifdef GI_LIGHTMAP_LAMPS
  // A lamp's light falls with the cosine until it is gone.
  lamps = max(lamps + gained(now, baked, lamps, LAYERS), vec3(0.0));
#endif
#endif
  irradiance = vec4(intensity * light, 1.0);
#ifdef GI_LIGHTMAP_LAMPS
  lampLight = vec4(lamps, 1.0);
#endif
}
