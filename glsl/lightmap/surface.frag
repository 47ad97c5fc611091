#version 430 core
// Baked light on the pixels that show its surface. Variants: GI_LIGHTMAP_DIRECTIONAL (the map holds first moments
// too, for normals that pictures bend).
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"

layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D normalTexture;
layout(binding = 2) uniform sampler2DArray lightTexture;
layout(binding = 3) uniform sampler2D albedoTexture;

uniform mat3 viewToWorld;
uniform float mapSize;   // diagonal of its surfaces
uniform float intensity;

in vec3 positionVC;
in vec3 normalWC;
in vec2 mapPlace;

layout(location = 0) out vec4 irradiance;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(depthTexture, pixel, 0).r;
  vec3 across = cross(dFdx(positionVC), dFdy(positionVC));
  vec3 facet = dot(across, across) > 0.0 ? normalize(across) : vec3(0.0);
  // What the pixel shows must lie in the triangle's plane, up to rounding of coordinates and of depth; what moves
  // right before it is lit by another technique.
  vec3 shown = giViewPosition(gl_FragCoord.xy, depth);
  float digit = abs(giViewDepth(depth + 2.4e-7) - shown.z); // four of the last of 24 bits
  float rounding = 2e-6 * (mapSize + length(shown)) + 2.0 * digit;
  vec3 N = giDecodeOctahedral(texelFetch(normalTexture, pixel, 0).xy);
  vec3 baked = normalize(normalWC);
  vec3 now = viewToWorld * N;
  if (abs(dot(facet, shown - positionVC)) > rounding || dot(now, baked) < 0.5 ||
    texelFetch(albedoTexture, pixel, 0).a == 0.0)
  {
    discard;
  }
  vec3 light = textureLod(lightTexture, vec3(mapPlace, 0.0), 0.0).rgb;
#ifdef GI_LIGHTMAP_DIRECTIONAL
  // Of irradiance in spherical harmonics, bands 0 and 1 differ between two normals by the mean of radiance times
  // its direction (Ramamoorthi and Hanrahan 2001, An Efficient Representation for Irradiance Environment Maps).
  vec3 bent = now - baked;
  light += bent.x * textureLod(lightTexture, vec3(mapPlace, 1.0), 0.0).rgb +
    bent.y * textureLod(lightTexture, vec3(mapPlace, 2.0), 0.0).rgb +
    bent.z * textureLod(lightTexture, vec3(mapPlace, 3.0), 0.0).rgb;
#endif
  irradiance = vec4(intensity * max(light, vec3(0.0)), 1.0);
}
