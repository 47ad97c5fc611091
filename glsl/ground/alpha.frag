#version 430 core
// Gives the picture the mean alpha of ground/trace.frag.
layout(binding = 0) uniform sampler2D before;
layout(binding = 1) uniform sampler2D alphas;
layout(location = 0) out vec4 color;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  color = texelFetch(before, pixel, 0);
  vec2 sum = texelFetch(alphas, pixel, 0).ra;
  color.a = sum.x / sum.y;
}
