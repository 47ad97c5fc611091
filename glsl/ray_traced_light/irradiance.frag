#version 430 core
// Passes the light that rays found on to the lighting.
#include "shared/view.h"
layout(binding = 0) uniform sampler2D tracedTexture;
layout(binding = 1) uniform sampler2D albedoTexture;

uniform float intensity;

layout(location = 0) out vec4 irradiance;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  bool exists = texelFetch(albedoTexture, pixel, 0).a > 0.0;
  irradiance = exists ? vec4(intensity * texelFetch(tracedTexture, pixel, 0).rgb, 1.0) : vec4(0.0);
}
