// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Which probes light a point between them, and how much. Probes stand in grids, a little off their places; of each
// it is known how far surfaces are in every direction, mean and mean square in an octahedral map with a border of
// one texel, and which of its neighbours it sees. What the probes hold is up to the includer. After Majercik et
// al. 2019, Dynamic Diffuse Global Illumination with Ray-Traced Irradiance Fields. The first grid is around
// everything; each later one is a part of it, of smaller cells than those before, and counts where it reaches. Grids that
// move keep their probes where they are: one is stored by its place modulo the grid's size
// (Majercik et al. 2021, Scaling Probe-Based Real-Time Dynamic Global Illumination for Production). Needs
// lib/octahedral.glsl. Coordinates are those of the rays' scene.
#include "shared/probe_field.h"
layout(binding = 5) uniform sampler2D fieldDistance;
layout(binding = 6) uniform sampler2D fieldProbes; // xyz how far a probe stands off its grid's place, w which neighbours it sees

uniform int fieldGrids;
uniform vec3 fieldOrigins[GI_FIELD_GRIDS];  // of each grid's first place
uniform vec3 fieldSpacings[GI_FIELD_GRIDS];
uniform ivec3 fieldCounts[GI_FIELD_GRIDS];  // of its probes
uniform ivec3 fieldWraps[GI_FIELD_GRIDS];   // where in storage its first place is
uniform int fieldBegins[GI_FIELD_GRIDS + 1]; // its first probe; after the last, all of them
uniform int fieldColumns; // maps in a row of their textures
uniform float fieldBias;  // in cells

struct fieldGrid
{
  vec3 origin;
  vec3 spacing;
  ivec3 counts;
  ivec3 wrap;
  int first; // probe
};

fieldGrid fieldGridOf(int number)
{
  return fieldGrid(fieldOrigins[number], fieldSpacings[number], fieldCounts[number], fieldWraps[number], fieldBegins[number]);
}

fieldGrid fieldGridWith(int probe)
{
  int number = 0;
  while (probe >= fieldBegins[number + 1])
  {
    ++number;
  }
  return fieldGridOf(number);
}

float fieldCellSize(fieldGrid grid)
{
  return min(grid.spacing.x, min(grid.spacing.y, grid.spacing.z));
}

int fieldIndex(fieldGrid grid, ivec3 cell)
{
  ivec3 kept = cell + grid.wrap;
  kept -= grid.counts * ivec3(greaterThanEqual(kept, grid.counts));
  return grid.first + kept.x + grid.counts.x * (kept.y + grid.counts.y * kept.z);
}

ivec3 fieldCell(fieldGrid grid, int probe)
{
  int kept = probe - grid.first;
  int row = kept / grid.counts.x;
  ivec3 cell = ivec3(kept % grid.counts.x, row % grid.counts.y, row / grid.counts.y) - grid.wrap;
  return cell + grid.counts * ivec3(lessThan(cell, ivec3(0)));
}

ivec2 fieldTile(int probe)
{
  return ivec2(probe % fieldColumns, probe / fieldColumns);
}

// Where a probe would stand if nothing were in the way.
vec3 fieldHome(fieldGrid grid, int probe)
{
  return grid.origin + grid.spacing * vec3(fieldCell(grid, probe));
}

vec3 fieldPosition(fieldGrid grid, int probe)
{
  return fieldHome(grid, probe) + texelFetch(fieldProbes, fieldTile(probe), 0).xyz;
}

// The offsets of the neighbours that a probe keeps a bit for, and the bit of an offset: those that come after
// the probe, by z, y and x.
ivec3 fieldNeighbour(int bit)
{
  int number = bit + 14;
  return ivec3(number % 3, (number / 3) % 3, number / 9) - 1;
}

int fieldNeighbourBit(ivec3 offset)
{
  return offset.x + 1 + 3 * (offset.y + 1) + 9 * (offset.z + 1) - 14;
}

vec4 fieldFetch(sampler2D maps, int probe, vec3 direction, float texels)
{
  vec2 at = vec2(fieldTile(probe)) * (texels + 2.0) + 1.0 + giEncodeOctahedral(direction) * texels;
  return textureLod(maps, at / vec2(textureSize(maps, 0)), 0.0);
}

// Whether a probe sees a point: Chebyshev's bound on the share of its distances that are greater (Donnelly and
// Lauritzen 2006, Variance Shadow Maps), cubed, as it is but a bound.
float fieldSees(int probe, vec3 fromProbe)
{
  float distance = length(fromProbe);
  vec2 moments = fieldFetch(fieldDistance, probe, fromProbe / max(distance, 1e-20), float(GI_FIELD_DISTANCE)).xy;
  float beyond = distance - moments.x;
  if (beyond <= 0.0)
  {
    return 1.0;
  }
  float variance = max(moments.y - moments.x * moments.x, 0.0);
  float bound = variance / (variance + beyond * beyond);
  return bound * bound * bound;
}

// The map of distances of the place that a probe left.
int fieldLeft(int probe)
{
  return fieldBegins[fieldGrids] + probe;
}

// Of those that count so much together.
float fieldAgreement(float part)
{
  return (part * part) * (part * part);
}

// A walk through the grids that tell of a point, the finest first.
struct fieldWalk
{
  fieldGrid grid;
  float share; // of the point's light, that this grid tells
  int next;    // grid
  float left;  // of the light, for those to come
};

fieldWalk fieldWalkFromFinest()
{
  fieldWalk walk;
  walk.next = fieldGrids - 1;
  walk.share = 0.0;
  walk.left = 1.0;
  return walk;
}

// All of the light that is left, but in a grid's outermost cells, where it fades to that of those around. Not where it
// reaches out of the scene, whose bounds are half a cell within the first grid.
float fieldCovers(fieldGrid grid, vec3 P)
{
  vec3 last = grid.origin + grid.spacing * vec3(grid.counts - 1);
  vec3 lowest = fieldOrigins[0] + 0.5 * fieldSpacings[0];
  vec3 highest = fieldOrigins[0] + fieldSpacings[0] * (vec3(fieldCounts[0]) - 1.5);
  vec3 low = (P - grid.origin) / grid.spacing;
  vec3 high = (last - P) / grid.spacing;
  low += vec3(lessThanEqual(grid.origin, lowest)) * vec3(greaterThanEqual(low, vec3(0.0)));
  high += vec3(greaterThanEqual(last, highest)) * vec3(greaterThanEqual(high, vec3(0.0)));
  vec3 inside = min(low, high);
  return clamp(min(inside.x, min(inside.y, inside.z)), 0.0, 1.0);
}

// False at the end.
bool fieldStep(inout fieldWalk walk, vec3 P)
{
  while (walk.next >= 0 && walk.left > 0.0)
  {
    walk.grid = fieldGridOf(walk.next);
    walk.share = walk.left * (walk.next > 0 ? fieldCovers(walk.grid, P) : 1.0);
    walk.left -= walk.share;
    --walk.next;
    if (walk.share > 0.0)
    {
      return true;
    }
  }
  return false;
}

// Before a block: what it does is done for each grid that tells of a point, by the name of walk. Variant:
// GI_FIELD_NESTED (there are several; software renderers take a fifth longer for a loop that ends after one).
#ifdef GI_FIELD_NESTED
#define fieldEachGrid(P) for (fieldWalk walk = fieldWalkFromFinest(); fieldStep(walk, P);)
#else
#define fieldEachGrid(P) fieldWalk walk = fieldWalk(fieldGridOf(0), 1.0, -1, 0.0);
#endif

// How much a probe at a position tells of a point of a surface, without its share in the grid. off: a little before the
// point.
float fieldTells(int probe, vec3 position, vec3 P, vec3 N, vec3 off)
{
  // Probes behind the surface fade out smoothly.
  float facing = 0.5 + 0.5 * dot(normalize(position - P), N);
  float weight = facing * facing * fieldSees(probe, off - position);
  // Where weights are small they are made smaller, without a step: the light of rooms next door.
  weight *= weight < 0.2 ? weight * weight / 0.04 : 1.0;
  return max(weight, 1e-6);
}

// A grid's eight probes around a point of a surface, and weights that add up to 1, or to less where probes left their
// places (dark: as nothing but what is in the dark was seen from there, which is still known). V: unit, to where the
// point is seen from; reach: how far that is, with nothing between. Where none of a finer grid's probes sees the point, as
// when they are new, it tells nothing of it, and the grids around do.
void fieldWeights(inout fieldWalk walk, vec3 P, vec3 N, vec3 V, float reach, bool dark, out int probes[8], out float weights[8])
{
  fieldGrid grid = walk.grid;
  float cell = fieldCellSize(grid);
  vec3 off = P + 0.2 * N * (fieldBias * cell) + 0.8 * V * min(fieldBias * cell, reach);
  vec3 place = (P - grid.origin) / grid.spacing;
  ivec3 base = clamp(ivec3(floor(place)), ivec3(0), max(grid.counts - 2, ivec3(0)));
  vec3 share = clamp(place - vec3(base), vec3(0.0), vec3(1.0));
  int seen[8];
  float told = 0.0;
  float total = 0.0; // of their squares
  float left = 0.0;  // weights of the places that probes left
  float lefts = 0.0; // squares of those
  int away = 0;      // bits of the probes that left
  for (int i = 0; i < 8; ++i)
  {
    ivec3 corner = ivec3(i & 1, (i >> 1) & 1, i >> 2);
    ivec3 at = min(base + corner, grid.counts - 1);
    int probe = fieldIndex(grid, at);
    probes[i] = probe;
    vec3 shares = mix(1.0 - share, share, vec3(corner));
    float linear = shares.x * shares.y * shares.z;
    vec4 record = texelFetch(fieldProbes, fieldTile(probe), 0);
    vec3 home = grid.origin + grid.spacing * vec3(at);
    weights[i] = linear * fieldTells(probe, home + record.xyz, P, N, off);
    seen[i] = int(record.w);
    told += weights[i];
    total += weights[i] * weights[i];
    away |= dark && record.xyz != vec3(0.0) ? 1 << i : 0;
  }
  for (; away != 0; away &= away - 1)
  {
    int i = findLSB(away);
    ivec3 corner = ivec3(i & 1, (i >> 1) & 1, i >> 2);
    vec3 shares = mix(1.0 - share, share, vec3(corner));
    vec3 home = grid.origin + grid.spacing * vec3(min(base + corner, grid.counts - 1));
    float tells = shares.x * shares.y * shares.z * fieldTells(fieldLeft(probes[i]), home, P, N, off);
    left += tells;
    lefts += tells * tells;
  }
  // A probe counts as far as the others that count see it: one behind a wall may seem to see the point where
  // that is close to the wall, but none of those before the wall sees the probe.
  float agreements[8];
#ifdef GI_FIELD_NESTED
  float known = grid.first > 0 ? min(1e4 * (told + left), 1.0) : 1.0;
  walk.left += (1.0 - known) * walk.share;
  walk.share *= known;
#endif
  total = max(total + lefts, 1e-30);
  float all = left * fieldAgreement(lefts / total);
  for (int i = 0; i < 8; ++i)
  {
    ivec3 corner = ivec3(i & 1, (i >> 1) & 1, i >> 2);
    float agreed = 0.0;
    for (int j = 0; j < 8; ++j)
    {
      int low = min(i, j);
      ivec3 offset = ivec3(j & 1, (j >> 1) & 1, j >> 2) - corner;
      offset = j < i ? -offset : offset;
      bool sees = i == j || (seen[low] >> fieldNeighbourBit(offset) & 1) != 0;
      agreed += sees ? weights[j] * weights[j] : 0.0;
    }
    agreements[i] = fieldAgreement(agreed / total);
    all += weights[i] * agreements[i];
  }
  for (int i = 0; i < 8; ++i)
  {
    weights[i] *= agreements[i] / max(all, 1e-30);
  }
}
