#version 430 core
// Copies a picture. All samples of a pixel of a multisampled target get the same value.
layout(binding = 0) uniform sampler2D colorTexture;
layout(location = 0) out vec4 color;

void main()
{
  color = texelFetch(colorTexture, ivec2(gl_FragCoord.xy), 0);
}
