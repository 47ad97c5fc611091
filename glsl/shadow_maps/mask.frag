#version 430 core
// Visibility of up to four lights at a pixel. Variants: those of
// shadow_maps/receive.glsl.
#include "shared/view.h"
#include "shared/shadow.h"
#include "lib/octahedral.glsl"
#include "lib/height.glsl"
#include "lib/reconstruct.glsl"
#include "lib/noise.glsl"

layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D albedoTexture;
layout(binding = 2) uniform sampler2D normalTexture;
layout(binding = 3) uniform sampler2D facetTexture;
layout(binding = 4) uniform sampler2D atlas;

#include "shadow_maps/sheet.glsl"
#include "shadow_maps/filter.glsl"
#include "shadow_maps/receive.glsl"

uniform int firstLight;
uniform int lightCount;

layout(location = 0) out vec4 visibility;

// Error of a 24-bit depth buffer and of the reconstruction from it.
const float DepthError = 2.5e-7;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  visibility = vec4(1.0);
  if (texelFetch(albedoTexture, pixel, 0).a == 0.0)
  {
    return;
  }
  float depth = texelFetch(depthTexture, pixel, 0).r;
  GiShadowed surface;
  surface.P = giViewPosition(gl_FragCoord.xy, depth);
  surface.N = giDecodeOctahedral(texelFetch(normalTexture, pixel, 0).xy);
  vec3 facet = texelFetch(facetTexture, pixel, 0).xyz;
  surface.facet = giDecodeOctahedral(facet.xy);
  surface.bulge = giDecodeHeight(facet.z);
  surface.error =
    length(giViewPosition(gl_FragCoord.xy, max(depth - DepthError, 0.0)) - surface.P);
  float angle = 6.28318531 * giInterleavedNoise(gl_FragCoord.xy, view.Frame.x);
  for (int i = 0; i < lightCount; ++i)
  {
    visibility[i] = giShadowVisibility(shadowLights[firstLight + i], surface, angle);
  }
}
