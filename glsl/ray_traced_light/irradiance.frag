#version 430 core
// Passes the light that rays found on to the lighting.
#include "shared/view.h"
layout(binding = 0) uniform sampler2D tracedTexture;
layout(binding = 1) uniform sampler2D albedoTexture;

uniform float intensity;

const float BRIGHTEST = 6e4; // what half floats hold

layout(location = 0) out vec4 irradiance;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  bool exists = texelFetch(albedoTexture, pixel, 0).a > 0.0;
  vec3 light = min(intensity * texelFetch(tracedTexture, pixel, 0).rgb, vec3(BRIGHTEST));
  irradiance = exists ? vec4(light, 1.0) : vec4(0.0);
}
