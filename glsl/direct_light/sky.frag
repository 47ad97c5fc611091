#version 430 core
// Radiance of a visible sky, behind everything else.
#include "lib/sky.glsl"
layout(binding = 0) uniform sampler2D skyTexture;
layout(location = 0) out vec4 radiance;

void main()
{
  radiance = vec4(giSkyRadiance(texelFetch(skyTexture, ivec2(gl_FragCoord.xy), 0)), 1.0);
}
