#version 430 core
// Bring the depth of what was captured to a multisampled window, every sample of a pixel alike.
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
