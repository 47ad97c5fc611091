// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Balls at probes, to look at them. Needs probes/field.glsl.
const int SPHERE_CELLS = 512; // that a ray may cross

// How far along a ray it enters a probe's ball; negative where it passes by or begins within.
float sphereAt(fieldGrid grid, int probe, vec3 origin, vec3 direction, float radius)
{
  vec3 to = fieldPosition(grid, probe) - origin;
  float along = dot(to, direction);
  float square = radius * radius - dot(to, to) + along * along;
  return square > 0.0 ? along - sqrt(square) : -1.0;
}

// Whether finer grids tell all of the light there, so that a grid's probe is not asked.
bool isToldByFiner(fieldGrid grid, vec3 P)
{
  fieldWalk walk = fieldWalkFromFinest();
  return fieldStep(walk, P) && walk.share >= 1.0 && walk.grid.first > grid.first;
}

// The first ball of the probes of a range of cells, where that is nearer than the nearest known.
void nearestSphere(fieldGrid grid, ivec3 low, ivec3 high, vec3 origin, vec3 direction, float radius, inout int nearest, inout float at)
{
  low = max(low, ivec3(0));
  high = min(high, grid.counts - 1);
  for (int z = low.z; z <= high.z; ++z)
  {
    for (int y = low.y; y <= high.y; ++y)
    {
      for (int x = low.x; x <= high.x; ++x)
      {
        int probe = fieldIndex(grid, ivec3(x, y, z));
        float here = sphereAt(grid, probe, origin, direction, radius);
        if (here > 0.0 && here < at && !isToldByFiner(grid, fieldHome(grid, probe)))
        {
          nearest = probe;
          at = here;
        }
      }
    }
  }
}

// A grid's first ball along a ray, or -1. farthest: how far to look, then how far it is. radius: world units. A ball lies within so many cells (strays)
// of its probe's own, the cell around its place in the grid. Cells are walked through as in Amanatides and Woo
// 1987, A Fast Voxel Traversal Algorithm for Ray Tracing.
int fieldSphere(fieldGrid grid, vec3 origin, vec3 direction, float radius, int strays, inout float farthest)
{
  // In cells around the places: the first from 0 to 1.
  vec3 start = (origin - grid.origin) / grid.spacing + 0.5;
  vec3 path = direction / grid.spacing;
  path = mix(path, vec3(1e-20), lessThan(abs(path), vec3(1e-20)));
  vec3 t0 = -start / path;
  vec3 t1 = (vec3(grid.counts) - start) / path;
  vec3 enter = min(t0, t1);
  vec3 leave = max(t0, t1);
  float t = max(0.0, max(enter.x, max(enter.y, enter.z)));
  float end = min(farthest, min(leave.x, min(leave.y, leave.z)));
  ivec3 cell = clamp(ivec3(floor(start + t * path)), ivec3(0), grid.counts - 1);
  ivec3 way = ivec3(sign(path));
  vec3 next = (vec3(cell + max(way, ivec3(0))) - start) / path;
  int nearest = -1;
  float at = farthest;
  ivec3 low = cell - strays;
  ivec3 high = cell + strays;
  for (int i = 0; i < SPHERE_CELLS && t < end; ++i)
  {
    nearestSphere(grid, low, high, origin, direction, radius, nearest, at);
    t = min(next.x, min(next.y, next.z));
    if (at <= t)
    {
      break; // what is met in cells to come is farther
    }
    bvec3 along3 = lessThanEqual(next, vec3(t));
    ivec3 axis = along3.x ? ivec3(1, 0, 0) : (along3.y ? ivec3(0, 1, 0) : ivec3(0, 0, 1));
    cell += axis * way;
    next += vec3(axis) / abs(path);
    if (any(lessThan(cell, ivec3(0))) || any(greaterThanEqual(cell, grid.counts)))
    {
      break;
    }
    // Of the cells around, those ahead: the others are known.
    low = cell - strays * (ivec3(1) - axis - axis * way);
    high = cell + strays * (ivec3(1) - axis + axis * way);
  }
  farthest = at;
  return nearest;
}
