#version 430 core
layout(local_size_x = 4) in;
layout(std430, binding = 3) writeonly buffer ResultBlock
{
  float results[];
};
uniform float strength;
uniform float width;

void main()
{
  results[0] = strength + width;
}
