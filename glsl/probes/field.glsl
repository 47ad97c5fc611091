// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Which probes light a point between them, and how much. Probes stand in a grid, a little off its places; of each
// it is known how far surfaces are in every direction, mean and mean square in an octahedral map with a border of
// one texel, and which of its neighbours it sees. What the probes hold is up to the includer. After Majercik et
// al. 2019, Dynamic Diffuse Global Illumination with Ray-Traced Irradiance Fields. Needs lib/octahedral.glsl.
// Coordinates are those of the rays' scene.
#define GI_FIELD_DISTANCE 16 // texels across a map of distances, without its border
layout(binding = 5) uniform sampler2D fieldDistance;
layout(binding = 6) uniform sampler2D fieldProbes; // xyz how far a probe stands off its grid's place, w which neighbours it sees

uniform vec3 fieldOrigin;  // of the first probe's place
uniform vec3 fieldSpacing;
uniform ivec3 fieldCounts;
uniform int fieldColumns;  // maps in a row of their textures
uniform float fieldBias;   // in cells

int fieldIndex(ivec3 cell)
{
  return cell.x + fieldCounts.x * (cell.y + fieldCounts.y * cell.z);
}

ivec3 fieldCell(int probe)
{
  int row = probe / fieldCounts.x;
  return ivec3(probe % fieldCounts.x, row % fieldCounts.y, row / fieldCounts.y);
}

ivec2 fieldTile(int probe)
{
  return ivec2(probe % fieldColumns, probe / fieldColumns);
}

vec3 fieldPosition(int probe)
{
  return fieldOrigin + fieldSpacing * vec3(fieldCell(probe)) +
    texelFetch(fieldProbes, fieldTile(probe), 0).xyz;
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

// The eight probes around a point of a surface, and weights that add up to 1, or to less where probes left dark places
// (emptiness: the weight of such a place, which counts where no probe sees the point). V: unit, to where it is seen
// from; reach: how far that is, with nothing between.
void fieldWeights(vec3 P, vec3 N, vec3 V, float reach, float emptiness, out int probes[8], out float weights[8])
{
  float cell = min(fieldSpacing.x, min(fieldSpacing.y, fieldSpacing.z));
  vec3 off = P + 0.2 * N * (fieldBias * cell) + 0.8 * V * min(fieldBias * cell, reach);
  vec3 place = (P - fieldOrigin) / fieldSpacing;
  ivec3 base = clamp(ivec3(floor(place)), ivec3(0), max(fieldCounts - 2, ivec3(0)));
  vec3 share = clamp(place - vec3(base), vec3(0.0), vec3(1.0));
  int seen[8];
  float total = 0.0; // of their squares
  float vacant = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    ivec3 corner = ivec3(i & 1, (i >> 1) & 1, i >> 2);
    int probe = fieldIndex(min(base + corner, fieldCounts - 1));
    probes[i] = probe;
    vec3 linear = mix(1.0 - share, share, vec3(corner));
    vec4 record = texelFetch(fieldProbes, fieldTile(probe), 0);
    vec3 position = fieldOrigin + fieldSpacing * vec3(fieldCell(probe)) + record.xyz;
    vec3 toProbe = normalize(position - P);
    // Probes behind the surface fade out smoothly.
    float facing = 0.5 + 0.5 * dot(toProbe, N);
    float weight = facing * facing * fieldSees(probe, off - position);
    // Where weights are small they are made smaller, without a step: the light of rooms next door.
    weight *= weight < 0.2 ? weight * weight / 0.04 : 1.0;
    weights[i] = max(weight, 1e-6) * linear.x * linear.y * linear.z;
    seen[i] = int(record.w);
    vacant += record.xyz != vec3(0.0) ? linear.x * linear.y * linear.z : 0.0;
    total += weights[i] * weights[i];
  }
  // A probe counts as far as the others that count see it: one behind a wall may seem to see the point where
  // that is close to the wall, but none of those before the wall sees the probe.
  float agreements[8];
  float all = emptiness * vacant;
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
    agreed /= max(total, 1e-30);
    agreements[i] = (agreed * agreed) * (agreed * agreed);
    all += weights[i] * agreements[i];
  }
  for (int i = 0; i < 8; ++i)
  {
    weights[i] *= agreements[i] / max(all, 1e-30);
  }
}
