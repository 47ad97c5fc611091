#version 430 core
layout(local_size_x = 4) in;
layout(std430, binding = 3) writeonly buffer ResultBlock
{
  float results[];
};
uniform bool flag;
uniform int whole;
uniform float real;
uniform vec2 two;
uniform vec3 three;
uniform vec4 four;
uniform ivec2 pair;
uniform ivec3 triple;
uniform mat3 turn;
uniform mat4 place;
uniform int wholes[3];
uniform vec3 places[2];
uniform ivec2 pairs[2];
uniform ivec3 triples[2];

void main()
{
  results[0] = flag ? 1.0 : 0.0;
  results[1] = float(whole);
  results[2] = real;
  results[3] = two.y;
  results[4] = three.z;
  results[5] = four.w;
  results[6] = float(pair.y);
  results[7] = float(triple.z);
  results[8] = turn[2][1];
  results[9] = place[3][2];
  results[10] = float(wholes[2]);
  results[11] = places[1].y;
  results[12] = float(pairs[1].x);
  results[13] = float(triples[1].z);
}
