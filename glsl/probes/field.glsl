// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Selects and weights the probes that light a point. Probes stand in grids, at an offset from their grid points. Each
// probe has an octahedral map, with a border of one texel, of the mean and mean square distance to surfaces, and a mask
// of the neighbours that it sees. The including shader decides what light the probes hold. After Majercik et
// al. 2019, Dynamic Diffuse Global Illumination with Ray-Traced Irradiance Fields. The first grid encloses the scene.
// Each later one covers a part of it with smaller cells and takes precedence there. When a grid scrolls, its probes
// stay in place: a probe is stored by its position modulo the grid's size (Majercik et al. 2021, Scaling Probe-Based
// Real-Time Dynamic Global Illumination for Production). Needs lib/octahedral.glsl. Coordinates are those of the ray
// scene.
#include "shared/probe_field.h"
layout(binding = 5) uniform sampler2D fieldDistance;
// xyz: a probe's offset from its grid point; w: mask of the neighbours that it sees.
layout(binding = 6) uniform sampler2D fieldProbes;

uniform int fieldGrids;
uniform vec3 fieldOrigins[GI_FIELD_GRIDS];  // first grid point of each grid
uniform vec3 fieldSpacings[GI_FIELD_GRIDS];
uniform ivec3 fieldCounts[GI_FIELD_GRIDS];  // probes along each axis
uniform ivec3 fieldWraps[GI_FIELD_GRIDS];   // storage index of the first grid point
uniform int fieldBegins[GI_FIELD_GRIDS + 1]; // first probe of each grid; the last entry is the number of probes
uniform int fieldColumns; // number of maps per row of their textures
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
  return fieldGrid(
    fieldOrigins[number], fieldSpacings[number], fieldCounts[number], fieldWraps[number], fieldBegins[number]);
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
  ivec3 stored = cell + grid.wrap;
  stored -= grid.counts * ivec3(greaterThanEqual(stored, grid.counts));
  return grid.first + stored.x + grid.counts.x * (stored.y + grid.counts.y * stored.z);
}

ivec3 fieldCell(fieldGrid grid, int probe)
{
  int stored = probe - grid.first;
  int row = stored / grid.counts.x;
  ivec3 cell = ivec3(stored % grid.counts.x, row % grid.counts.y, row / grid.counts.y) - grid.wrap;
  return cell + grid.counts * ivec3(lessThan(cell, ivec3(0)));
}

// One of a cell's corners, 0 to 7.
ivec3 fieldCorner(int number)
{
  return ivec3(number & 1, (number >> 1) & 1, number >> 2);
}

ivec2 fieldTile(int probe)
{
  return ivec2(probe % fieldColumns, probe / fieldColumns);
}

// Grid point of a probe.
vec3 fieldHome(fieldGrid grid, int probe)
{
  return grid.origin + grid.spacing * vec3(fieldCell(grid, probe));
}

vec3 fieldPosition(fieldGrid grid, int probe)
{
  return fieldHome(grid, probe) + texelFetch(fieldProbes, fieldTile(probe), 0).xyz;
}

// Offset of the neighbour that a bit of a probe's mask stands for. The mask has a bit for each neighbour that comes
// after the probe in z, y, x order.
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

// Visibility of a point from a probe: Chebyshev's bound on the share of greater distances (Donnelly and
// Lauritzen 2006, Variance Shadow Maps), cubed, as it is only an upper bound.
float fieldVisibility(int probe, vec3 fromProbe)
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

// Index of the distance map of a probe's grid point, which is kept when the probe is relocated.
int fieldGridPointMap(int probe)
{
  return fieldBegins[fieldGrids] + probe;
}

// Weight of a probe, given the share of the weights that belong to probes that see it.
float fieldAgreement(float part)
{
  return (part * part) * (part * part);
}

// A walk through the grids that cover a point, finest grid first.
struct fieldWalk
{
  fieldGrid grid;
  float share; // weight of this grid
  int next;    // index of the next grid
  float left;  // weight that remains for the next grids
};

fieldWalk fieldWalkFromFinest()
{
  fieldWalk walk;
  walk.next = fieldGrids - 1;
  walk.share = 0.0;
  walk.left = 1.0;
  return walk;
}

// Share of the remaining weight that a grid takes: 1, with a fade to the next coarser grid in its outermost cells.
// There is no fade where the grid extends beyond the scene's bounds, which are half a cell inside the first grid.
float fieldCoverage(fieldGrid grid, vec3 P)
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

// Advances to the next grid. Returns false at the end.
bool fieldStep(inout fieldWalk walk, vec3 P)
{
  while (walk.next >= 0 && walk.left > 0.0)
  {
    walk.grid = fieldGridOf(walk.next);
    walk.share = walk.left * (walk.next > 0 ? fieldCoverage(walk.grid, P) : 1.0);
    walk.left -= walk.share;
    --walk.next;
    if (walk.share > 0.0)
    {
      return true;
    }
  }
  return false;
}

// Runs the following block for each grid that covers a point, as the variable `walk`. Variant:
// GI_FIELD_NESTED (there are several grids; in software renderers a loop of one iteration costs a fifth more time).
#ifdef GI_FIELD_NESTED
#define fieldEachGrid(P) for (fieldWalk walk = fieldWalkFromFinest(); fieldStep(walk, P);)
#else
#define fieldEachGrid(P) fieldWalk walk = fieldWalk(fieldGridOf(0), 1.0, -1, 0.0);
#endif

// Weight of a probe at a point of a surface, without its trilinear weight. off: the point, offset from its surface.
float fieldProbeWeight(int probe, vec3 position, vec3 P, vec3 N, vec3 off)
{
  // Probes behind the surface fade out smoothly.
  float facing = 0.5 + 0.5 * dot(normalize(position - P), N);
  float weight = facing * facing * fieldVisibility(probe, off - position);
  // Crush small weights, continuously: they are light that leaks from adjacent rooms.
  weight *= weight < 0.2 ? weight * weight / 0.04 : 1.0;
  return max(weight, 1e-6);
}

// The eight probes of a grid around a point of a surface, and their weights. The weights add up to 1, or to less with
// `dark` if probes were relocated: the grid points that they left still count, as dark, since only dark surfaces
// are visible from there. V: unit vector to the viewpoint; reach: unoccluded distance to it. If no probe of a finer
// grid sees the point, for example because the probes are new, the coarser grids get the grid's weight.
void fieldWeights(inout fieldWalk walk, vec3 P, vec3 N, vec3 V, float reach, bool dark, out int probes[8],
  out float weights[8])
{
  fieldGrid grid = walk.grid;
  float cell = fieldCellSize(grid);
  vec3 off = P + 0.2 * N * (fieldBias * cell) + 0.8 * V * min(fieldBias * cell, reach);
  vec3 place = (P - grid.origin) / grid.spacing;
  ivec3 base = clamp(ivec3(floor(place)), ivec3(0), max(grid.counts - 2, ivec3(0)));
  vec3 share = clamp(place - vec3(base), vec3(0.0), vec3(1.0));
  int seen[8];
  float weightSum = 0.0;
  float squareSum = 0.0; // sum of their squares
  float vacatedSum = 0.0; // sum of the weights of vacated grid points
  float vacatedSquares = 0.0; // sum of their squares
  int relocated = 0; // mask of the relocated probes
  for (int i = 0; i < 8; ++i)
  {
    ivec3 corner = fieldCorner(i);
    ivec3 at = min(base + corner, grid.counts - 1);
    int probe = fieldIndex(grid, at);
    probes[i] = probe;
    vec3 shares = mix(1.0 - share, share, vec3(corner));
    float linear = shares.x * shares.y * shares.z;
    vec4 record = texelFetch(fieldProbes, fieldTile(probe), 0);
    vec3 home = grid.origin + grid.spacing * vec3(at);
    weights[i] = linear * fieldProbeWeight(probe, home + record.xyz, P, N, off);
    seen[i] = int(record.w);
    weightSum += weights[i];
    squareSum += weights[i] * weights[i];
    relocated |= dark && record.xyz != vec3(0.0) ? 1 << i : 0;
  }
  for (; relocated != 0; relocated &= relocated - 1)
  {
    int i = findLSB(relocated);
    ivec3 corner = fieldCorner(i);
    vec3 shares = mix(1.0 - share, share, vec3(corner));
    vec3 home = grid.origin + grid.spacing * vec3(min(base + corner, grid.counts - 1));
    float vacatedWeight =
      shares.x * shares.y * shares.z * fieldProbeWeight(fieldGridPointMap(probes[i]), home, P, N, off);
    vacatedSum += vacatedWeight;
    vacatedSquares += vacatedWeight * vacatedWeight;
  }
  // A probe's weight depends on how many of the other contributing probes see it. A probe behind a wall may seem to
  // see a point close to the wall, but no probe in front of the wall sees the probe.
  float agreements[8];
#ifdef GI_FIELD_NESTED
  float known = grid.first > 0 ? min(1e4 * (weightSum + vacatedSum), 1.0) : 1.0;
  walk.left += (1.0 - known) * walk.share;
  walk.share *= known;
#endif
  squareSum = max(squareSum + vacatedSquares, 1e-30);
  float all = vacatedSum * fieldAgreement(vacatedSquares / squareSum);
  for (int i = 0; i < 8; ++i)
  {
    ivec3 corner = fieldCorner(i);
    float agreed = 0.0;
    for (int j = 0; j < 8; ++j)
    {
      int low = min(i, j);
      ivec3 offset = fieldCorner(j) - corner;
      offset = j < i ? -offset : offset;
      bool sees = i == j || (seen[low] >> fieldNeighbourBit(offset) & 1) != 0;
      agreed += sees ? weights[j] * weights[j] : 0.0;
    }
    agreements[i] = fieldAgreement(agreed / squareSum);
    all += weights[i] * agreements[i];
  }
  for (int i = 0; i < 8; ++i)
  {
    weights[i] *= agreements[i] / max(all, 1e-30);
  }
}
