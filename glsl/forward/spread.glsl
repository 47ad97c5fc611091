// In place of a technique that knows indirect light (see forward/indirect.glsl): the share of the lights that is spread
// evenly over all directions. None of what the environment sends is in it.
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
