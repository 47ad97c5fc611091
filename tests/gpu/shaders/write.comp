#version 430 core
layout(local_size_x = 4) in;
layout(r32f, binding = 0) uniform writeonly image2D target;

void main()
{
  imageStore(target, ivec2(0), vec4(1.0));
}
