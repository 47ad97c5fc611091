#version 430 core
// Blends the ground into the background at its rim. Variants: GI_RADIANCE (linear radiance, not the colour for display),
// GI_SKY (a skybox is behind everything).
#include "shared/view.h"
#include "shared/material.h"
#include "lib/reconstruct.glsl"
#include "lib/sky.glsl"
#include "ground/plane.glsl"

layout(binding = 0) uniform sampler2D albedoTexture;
layout(binding = 1) uniform sampler2D normalTexture;
layout(binding = 2) uniform sampler2D before; // the picture
layout(binding = 3) uniform sampler2D backdropTexture;
layout(binding = 4) uniform sampler2D skyTexture;

uniform int material;
uniform float strength;

layout(location = 0) out vec4 color;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  color = texelFetch(before, pixel, 0);
  if (texelFetch(albedoTexture, pixel, 0).a > 0.0 &&
    int(texelFetch(normalTexture, pixel, 0).z * 65535.0 + 0.5) == material)
  {
    vec4 behind = texelFetch(backdropTexture, pixel, 0);
#if defined(GI_RADIANCE) && defined(GI_SKY)
    behind = vec4(giSkyRadiance(texelFetch(skyTexture, pixel, 0)), 1.0);
#endif
    color = mix(behind, color, strength * giGroundAt(gl_FragCoord.xy).opacity);
  }
}
