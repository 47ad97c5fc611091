#version 430 core
// Where a probe should stand. One in the dark, which no neighbour in the light sees, is within something: it goes
// to the nearest surface that such a neighbour sees, before it. Neither the winding of polygons nor whether
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

layout(rgba32f, binding = 0) uniform writeonly image2D places; // w: 0 where the probe stays, else 1 and the neighbour in the light that sees it there, or -1
layout(binding = 0) uniform sampler2D foundTexture; // of the last update: radiance, distance; a row for each probe

uniform int probeCount;
uniform int rays;
uniform int update; // the last
uniform bool geometryMoves;

const float DARK = 0.02;      // of the brightest neighbour's light
const float LIT = 0.1;        // likewise
const float CLEARANCE = 0.2; // of a cell, before a surface
const float NARROW = 1.4;     // mean free way in cells, at most, within things; in rooms it is more
const float SAME = 0.1;       // of a cell: a place that is not worth going to from another

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

bool atHome(int probe)
{
  return texelFetch(fieldProbes, fieldTile(probe), 0).xyz == vec3(0.0);
}

// The neighbour at an offset of -1, 0 or 1 along each axis, from 27; -1 where there is none.
int neighbour(fieldGrid grid, ivec3 cell, int number)
{
  ivec3 other = cell + ivec3(number % 3, (number / 3) % 3, number / 9) - 1;
  bool outside = any(lessThan(other, ivec3(0))) || any(greaterThanEqual(other, grid.counts));
  return outside || number == 13 ? -1 : fieldIndex(grid, other);
}

// Of the last update's rays; surfaces further off than a limit count as if they were there.
float meanDistance(int probe, float limit)
{
  float sum = 0.0;
  for (int i = 0; i < rays; ++i)
  {
    sum += min(texelFetch(foundTexture, ivec2(i, probe), 0).a, limit);
  }
  return sum / float(rays);
}

// How far off its home the probe should stand. witness: a neighbour in the light that sees it there.
vec3 offHome(fieldGrid grid, int probe, out int witness)
{
  witness = -1;
  ivec3 cell = fieldCell(grid, probe);
  vec3 home = grid.origin + grid.spacing * vec3(cell);
  vec3 now = texelFetch(fieldProbes, fieldTile(probe), 0).xyz;
  float lights[27];
  float brightest = 0.0;
  for (int i = 0; i < 27; ++i)
  {
    int other = neighbour(grid, cell, i);
    lights[i] = other >= 0 && atHome(other) ? brightness(other) : 0.0;
    brightest = max(brightest, lights[i]);
  }
  if (brightest <= 0.0 || (atHome(probe) && brightness(probe) > DARK * brightest))
  {
    return vec3(0.0);
  }
  float size = fieldCellSize(grid);
  if (atHome(probe) && meanDistance(probe, 4.0 * size) > NARROW * size)
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
      return vec3(0.0); // home is in the light
    }
    float hit = length(at.position - from);
    if (reach - hit < nearest)
    {
      nearest = reach - hit;
      witness = other;
      // Off the surface by the same, however slanting it is seen.
      float off = CLEARANCE * size / max(0.2, abs(dot(at.normal, direction)));
      best = from + direction * max(hit - off, 0.5 * hit) - home;
    }
  }
  return length(best - now) < SAME * size ? now : best;
}

// Whether the last update's rays found a surface in one of the cells around the probe.
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
  vec3 off = offHome(grid, probe, witness);
  if (off != before)
  {
    state = ProbeState(0.0, 0.0, 0.0);
  }
  setProbeState(probe, state);
  float moves = off != before ? (witness < 0 ? -1.0 : float(witness + 1)) : 0.0;
  imageStore(places, fieldTile(probe), vec4(off, moves));
}
