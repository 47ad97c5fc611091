#version 430 core
// Draws the picture of denoising/view.frag.
layout(binding = 0) uniform sampler2D viewTexture;

layout(location = 0) out vec4 color;

void main()
{
  color = texelFetch(viewTexture, ivec2(gl_FragCoord.xy), 0);
}
