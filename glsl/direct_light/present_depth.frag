#version 430 core
// Copies the depth of captured surfaces to a window. All samples of a pixel get the same value. What shows the background
// has no depth there.
layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D albedoTexture;
layout(binding = 2) uniform sampler2D normalTexture;

#include "direct_light/window_depth.glsl"

uniform int catcher;      // material of what shows the background

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int index = int(texelFetch(normalTexture, pixel, 0).z * 65535.0 + 0.5);
  if (texelFetch(albedoTexture, pixel, 0).a == 0.0 || index == catcher)
  {
    discard;
  }
  gl_FragDepth = giWindowDepth(texelFetch(depthTexture, pixel, 0).r);
}
