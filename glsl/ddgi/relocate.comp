#version 430 core
// Chooses where a probe stands. A dark probe that no lit neighbour sees is inside an object. It moves in front of the
// nearest surface that such a neighbour sees. Neither the winding of polygons nor whether
// surfaces are closed matters for that. Variants: those of rays/passage.glsl.
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/sampling.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"
#include "ddgi/field.glsl"
#include "ddgi/directions.glsl"
#include "ddgi/states.glsl"

layout(local_size_x = 64) in;

// w: 0 if the probe stays, 1 + its witness if it moves, -1 if it moves without one.
layout(rgba32f, binding = 0) uniform writeonly image2D places;
layout(binding = 0) uniform sampler2D foundTexture; // of the last update: radiance, distance; one row per probe

uniform int probeCount;
uniform int rays;
uniform int update; // the last one
uniform bool geometryMoves;

const float DARK = 0.02;      // maximum brightness of a dark probe, relative to the brightest neighbour
const float LIT = 0.1;        // minimum brightness of a lit neighbour, likewise
const float CLEARANCE = 0.2; // distance from a surface, in cells
const float NARROW = 1.4;     // maximum mean free path inside objects, in cells; in rooms it is longer
const float SAME = 0.1;       // minimum distance of a move, in cells

float brightness(int probe)
{
  vec3 sum = vec3(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    vec3 direction = vec3(0.0);
    direction[axis] = 1.0;
    sum += fieldFetch(fieldLight, probe, direction, float(GI_FIELD_LIGHT)).rgb;
    sum += fieldFetch(fieldLight, probe, -direction, float(GI_FIELD_LIGHT)).rgb;
  }
  return sum.r + sum.g + sum.b;
}

bool isAtGridPoint(int probe)
{
  return texelFetch(fieldProbes, fieldTile(probe), 0).xyz == vec3(0.0);
}

// One of the 26 neighbours, at an offset of -1, 0 or 1 along each axis; -1 if there is none.
int neighbour(fieldGrid grid, ivec3 cell, int number)
{
  ivec3 other = cell + ivec3(number % 3, (number / 3) % 3, number / 9) - 1;
  bool outside = any(lessThan(other, ivec3(0))) || any(greaterThanEqual(other, grid.counts));
  return outside || number == 13 ? -1 : fieldIndex(grid, other);
}

// Mean distance that the last update's rays travelled, each up to a limit.
float meanDistance(int probe, float limit)
{
  float sum = 0.0;
  for (int i = 0; i < rays; ++i)
  {
    sum += min(texelFetch(foundTexture, ivec2(i, probe), 0).a, limit);
  }
  return sum / float(rays);
}

// Offset from the probe's grid point at which it should stand. witness: a lit neighbour that sees it there, or -1.
vec3 chooseOffset(fieldGrid grid, int probe, out int witness)
{
  witness = -1;
  ivec3 cell = fieldCell(grid, probe);
  vec3 home = grid.origin + grid.spacing * vec3(cell);
  vec3 currentOffset = texelFetch(fieldProbes, fieldTile(probe), 0).xyz;
  float lights[27];
  float brightest = 0.0;
  for (int i = 0; i < 27; ++i)
  {
    int other = neighbour(grid, cell, i);
    lights[i] = other >= 0 && isAtGridPoint(other) ? brightness(other) : 0.0;
    brightest = max(brightest, lights[i]);
  }
  if (brightest <= 0.0 || (isAtGridPoint(probe) && brightness(probe) > DARK * brightest))
  {
    return vec3(0.0);
  }
  float size = fieldCellSize(grid);
  if (isAtGridPoint(probe) && meanDistance(probe, 4.0 * size) > NARROW * size)
  {
    return vec3(0.0);
  }
  uint state = giHash(uint(probe));
  vec3 best = vec3(0.0);
  float nearest = RAY_FAR;
  for (int i = 0; i < 27; ++i)
  {
    if (lights[i] <= LIT * brightest)
    {
      continue;
    }
    int other = neighbour(grid, cell, i);
    vec3 from = fieldPosition(grid, other);
    float reach = length(home - from);
    vec3 direction = (home - from) / reach;
    Ray ray = Ray(from, 0.0, direction, reach);
    RaySurfacePoint at;
    float first;
    if (traceThrough(ray, at, first, state).instance < 0)
    {
      witness = other;
      return vec3(0.0); // a lit neighbour sees the grid point
    }
    float hit = length(at.position - from);
    if (reach - hit < nearest)
    {
      nearest = reach - hit;
      witness = other;
      // Keep the same distance from the surface at any angle.
      float off = CLEARANCE * size / max(0.2, abs(dot(at.normal, direction)));
      best = from + direction * max(hit - off, 0.5 * hit) - home;
    }
  }
  return length(best - currentOffset) < SAME * size ? currentOffset : best;
}

// Whether the last update's rays hit a surface in one of the cells around the probe.
bool nearSurfaces(fieldGrid grid, int probe)
{
  vec3 off = texelFetch(fieldProbes, fieldTile(probe), 0).xyz;
  mat3 turn = fieldTurn(probe, update);
  for (int i = 0; i < rays; ++i)
  {
    vec3 place = off + turn * fieldDirection(i) * min(texelFetch(foundTexture, ivec2(i, probe), 0).a, 1e15);
    if (all(lessThan(abs(place), 1.1 * grid.spacing)))
    {
      return true;
    }
  }
  return false;
}

void main()
{
  int probe = int(gl_GlobalInvocationID.x);
  if (probe >= probeCount)
  {
    return;
  }
  fieldGrid grid = fieldGridWith(probe);
  ProbeState state = probeState(probe);
  vec3 before = texelFetch(fieldProbes, fieldTile(probe), 0).xyz;
  if (!probeRests(probe, update, state) && (state.idle > 0.0 || geometryMoves))
  {
    state.idle = nearSurfaces(grid, probe) ? 0.0 : state.idle + 1.0;
  }
  int witness;
  vec3 off = chooseOffset(grid, probe, witness);
  if (off != before)
  {
    state = ProbeState(0.0, 0.0, 0.0);
  }
  setProbeState(probe, state);
  float moves = off != before ? (witness < 0 ? -1.0 : float(witness + 1)) : 0.0;
  imageStore(places, fieldTile(probe), vec4(off, moves));
}
