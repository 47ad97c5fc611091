#version 430 core
// Bring colour and depth to a multisampled window, every sample of a pixel alike.
layout(binding = 0) uniform sampler2D colorTexture;
layout(binding = 1) uniform sampler2D depthTexture;
layout(location = 0) out vec4 color;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  color = texelFetch(colorTexture, pixel, 0);
  gl_FragDepth = texelFetch(depthTexture, pixel, 0).r;
}
