#version 430 core
// Bring the picture to a multisampled window, every sample of a pixel alike.
layout(binding = 0) uniform sampler2D colorTexture;
layout(location = 0) out vec4 color;

void main()
{
  color = texelFetch(colorTexture, ivec2(gl_FragCoord.xy), 0);
}
