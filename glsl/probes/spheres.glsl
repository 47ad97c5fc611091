// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Intersects rays with the balls that show probes. Needs probes/field.glsl.
const int SPHERE_CELLS = 512; // maximum number of cells that a ray crosses

// Distance at which a ray enters a probe's ball; negative if it misses or starts inside.
float sphereAt(fieldGrid grid, int probe, vec3 origin, vec3 direction, float radius)
{
  vec3 to = fieldPosition(grid, probe) - origin;
  float along = dot(to, direction);
  float square = radius * radius - dot(to, to) + along * along;
  return square > 0.0 ? along - sqrt(square) : -1.0;
}

// Whether finer grids take the whole weight there, so that this grid's probe is not used.
bool isCoveredByFiner(fieldGrid grid, vec3 P)
{
  fieldWalk walk = fieldWalkFromFinest();
  return fieldStep(walk, P) && walk.share >= 1.0 && walk.grid.first > grid.first;
}

// Finds the first ball of the probes in a range of cells, if it is nearer than the nearest one so far.
void nearestSphere(fieldGrid grid, ivec3 low, ivec3 high, vec3 origin, vec3 direction, float radius,
  inout int nearest, inout float at)
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
        if (here > 0.0 && here < at && !isCoveredByFiner(grid, fieldHome(grid, probe)))
        {
          nearest = probe;
          at = here;
        }
      }
    }
  }
}

// Probe of the first ball of a grid along a ray, or -1. farthest: length of the ray; set to the distance of the ball.
// radius: in world units. strays: maximum distance of a ball from its probe's own cell, in cells. Traverses the cells
// as in Amanatides and Woo 1987, A Fast Voxel Traversal Algorithm for Ray Tracing.
int fieldSphere(fieldGrid grid, vec3 origin, vec3 direction, float radius, int strays, inout float farthest)
{
  // Coordinates in cells, each centred on its grid point: the first cell extends from 0 to 1.
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
      break; // hits in the next cells are farther
    }
    bvec3 along3 = lessThanEqual(next, vec3(t));
    ivec3 axis = along3.x ? ivec3(1, 0, 0) : (along3.y ? ivec3(0, 1, 0) : ivec3(0, 0, 1));
    cell += axis * way;
    next += vec3(axis) / abs(path);
    if (any(lessThan(cell, ivec3(0))) || any(greaterThanEqual(cell, grid.counts)))
    {
      break;
    }
    // Visit only the cells ahead in the neighbourhood; the others have been visited.
    low = cell - strays * (ivec3(1) - axis - axis * way);
    high = cell + strays * (ivec3(1) - axis + axis * way);
  }
  farthest = at;
  return nearest;
}
