// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Balls at probes, to look at them. A ball lies within the cell around its probe's place in the grid, so that a
// ray meets it in no other. Needs probes/field.glsl.
const int SPHERE_CELLS = 512; // that a ray may cross

// The first ball along a ray, or -1; N: unit, there. radius: world units. Cells are walked through as in Amanatides
// and Woo 1987, A Fast Voxel Traversal Algorithm for Ray Tracing.
int fieldSphere(vec3 origin, vec3 direction, float farthest, float radius, out vec3 N)
{
  N = vec3(0.0);
  // In cells around the places: the first from 0 to 1.
  vec3 start = (origin - fieldOrigin) / fieldSpacing + 0.5;
  vec3 path = direction / fieldSpacing;
  path = mix(path, vec3(1e-20), lessThan(abs(path), vec3(1e-20)));
  vec3 t0 = -start / path;
  vec3 t1 = (vec3(fieldCounts) - start) / path;
  vec3 enter = min(t0, t1);
  vec3 leave = max(t0, t1);
  float t = max(0.0, max(enter.x, max(enter.y, enter.z)));
  float end = min(farthest, min(leave.x, min(leave.y, leave.z)));
  ivec3 cell = clamp(ivec3(floor(start + t * path)), ivec3(0), fieldCounts - 1);
  ivec3 way = ivec3(sign(path));
  vec3 next = (vec3(cell + max(way, ivec3(0))) - start) / path;
  for (int i = 0; i < SPHERE_CELLS && t < end; ++i)
  {
    int probe = fieldIndex(cell);
    vec3 to = fieldPosition(probe) - origin;
    float along = dot(to, direction);
    float square = radius * radius - dot(to, to) + along * along;
    float at = along - sqrt(max(square, 0.0));
    if (square > 0.0 && at > 0.0 && at < farthest)
    {
      N = (at * direction - to) / radius;
      return probe;
    }
    t = min(next.x, min(next.y, next.z));
    bvec3 along3 = lessThanEqual(next, vec3(t));
    ivec3 axis = along3.x ? ivec3(1, 0, 0) : (along3.y ? ivec3(0, 1, 0) : ivec3(0, 0, 1));
    cell += axis * way;
    next += vec3(axis) / abs(path);
    if (any(lessThan(cell, ivec3(0))) || any(greaterThanEqual(cell, fieldCounts)))
    {
      break;
    }
  }
  return -1;
}
