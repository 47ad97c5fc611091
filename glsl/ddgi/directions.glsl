// Directions of a probe's rays in an update: a table of directions distributed evenly over the sphere,
// with a random rotation for each probe and update. Needs lib/sampling.glsl.
// Row 1 is for updates in parts: in each part the directions are evenly distributed, too.
layout(binding = 3) uniform sampler2D fieldDirections;

uniform int parts; // of the update that traces, or has traced, the rays; ray i belongs to part i % parts

// Random rotation: a random z axis, and a random angle about it.
mat3 fieldTurn(int probe, int update)
{
  uint state = giHash(uint(probe) ^ giHash(uint(update)));
  float z = 2.0 * giRandom(state) - 1.0;
  float phi = 6.28318530718 * giRandom(state);
  float turn = 6.28318530718 * giRandom(state);
  float radius = sqrt(max(0.0, 1.0 - z * z));
  mat3 basis = giBasis(vec3(radius * cos(phi), radius * sin(phi), z));
  return basis * mat3(cos(turn), sin(turn), 0.0, -sin(turn), cos(turn), 0.0, 0.0, 0.0, 1.0);
}

vec3 fieldDirection(int ray)
{
  return texelFetch(fieldDirections, ivec2(ray, parts > 1 ? 1 : 0), 0).xyz;
}
