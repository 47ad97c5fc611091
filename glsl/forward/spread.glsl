// Stands in for a technique that knows indirect light (see forward/indirect.glsl): the share of the lights' strength
// that is spread evenly over all directions. It contains no light of the environment.
uniform vec3 fieldSpread;

vec4 fieldIndirect(vec3 P, vec3 N, vec3 V, float reach)
{
  return vec4(fieldSpread, 0.0);
}

float fieldIndirectCube(vec3 P, vec3 V, float reach, out vec3 cube[6])
{
  for (int side = 0; side < 6; ++side)
  {
    cube[side] = fieldSpread;
  }
  return 1.0;
}

float fieldGrain()
{
  return 1e30;
}
