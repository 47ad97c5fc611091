#version 430 core
layout(local_size_x = 4) in;
layout(std430, binding = 3) writeonly buffer ResultBlock
{
  float results[];
};
layout(binding = 0) uniform sampler2D source;

void main()
{
  results[0] = texelFetch(source, ivec2(0), 0).r;
}
