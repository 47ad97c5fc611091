#version 430 core
// Mean of the still frames so far. GI_FIRST starts a new sum; GI_FROZEN shows the sum as it
// is, without this frame.
layout(binding = 0) uniform sampler2D colorTexture;
layout(binding = 0, rgba32f) uniform image2D sums;
uniform float frames; // number of frames in the sum, including this one

layout(location = 0) out vec4 color;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 sum = texelFetch(colorTexture, pixel, 0);
#if GI_FROZEN
  sum = imageLoad(sums, pixel);
#elif !GI_FIRST
  sum += imageLoad(sums, pixel);
#endif
  imageStore(sums, pixel, sum);
  color = sum / frames;
}
