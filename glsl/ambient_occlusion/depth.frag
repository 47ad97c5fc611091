#version 430 core
// Copies the window's depth to a format that is fast to sample.
layout(binding = 0) uniform sampler2D depthTexture;

layout(location = 0) out float depth;

void main()
{
  depth = texelFetch(depthTexture, ivec2(gl_FragCoord.xy), 0).r;
}
