#version 430 core
// The window's depth in a format that is quick to read at many places.
layout(binding = 0) uniform sampler2D depthTexture;

layout(location = 0) out float depth;

void main()
{
  depth = texelFetch(depthTexture, ivec2(gl_FragCoord.xy), 0).r;
}
