#version 430 core
// Copies the depth of captured props to a multisampled window. All samples of a pixel get the same value.
layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D albedoTexture;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (texelFetch(albedoTexture, pixel, 0).a == 0.0)
  {
    discard;
  }
  gl_FragDepth = texelFetch(depthTexture, pixel, 0).r;
}
