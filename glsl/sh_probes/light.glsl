// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Light of baked probes in spherical harmonics: irradiance divided by pi, nine coefficients of three colours, in
// seven texels of four numbers (Ramamoorthi and Hanrahan 2001, An Efficient Representation for Irradiance Environment
// Maps). Needs lib/spherical_harmonics.glsl, probes/field.glsl.
layout(binding = 4) uniform sampler2D probeLight;

uniform float lightScale; // factor of the numbers in the texture

void addProbe(int probe, float weight, inout vec4 sums[GI_FIELD_HARMONICS])
{
  ivec2 tile = fieldTile(probe) * ivec2(GI_FIELD_HARMONICS, 1);
  for (int i = 0; i < GI_FIELD_HARMONICS; ++i)
  {
    sums[i] += weight * texelFetch(probeLight, tile + ivec2(i, 0), 0);
  }
}

// Coefficient of harmonic k.
vec3 harmonicColor(vec4 sums[GI_FIELD_HARMONICS], int k)
{
  int at = 3 * k;
  return vec3(sums[at / 4][at % 4], sums[(at + 1) / 4][(at + 1) % 4], sums[(at + 2) / 4][(at + 2) % 4]);
}

// Irradiance in a direction, divided by pi. So few harmonics can fall slightly below zero.
vec3 harmonicLight(vec4 sums[GI_FIELD_HARMONICS], vec3 N)
{
  float y[GI_HARMONICS];
  giHarmonics(N, y);
  vec3 light = vec3(0.0);
  for (int k = 0; k < GI_HARMONICS; ++k)
  {
    light += y[k] * harmonicColor(sums, k);
  }
  return lightScale * max(light, vec3(0.0));
}

vec3 probeIrradiance(int probe, vec3 N)
{
  vec4 sums[GI_FIELD_HARMONICS];
  for (int i = 0; i < GI_FIELD_HARMONICS; ++i)
  {
    sums[i] = vec4(0.0);
  }
  addProbe(probe, 1.0, sums);
  return harmonicLight(sums, N);
}

// Adds up the probes that light a point, weighted by fieldWeights().
void addProbesAround(vec3 P, vec3 N, vec3 V, float reach, out vec4 sums[GI_FIELD_HARMONICS])
{
  for (int i = 0; i < GI_FIELD_HARMONICS; ++i)
  {
    sums[i] = vec4(0.0);
  }
  const float least = 1e-4; // smaller weights make no visible difference
  fieldEachGrid(P)
  {
    int probes[8];
    float weights[8];
    fieldWeights(walk, P, N, V, reach, false, probes, weights);
    for (int i = 0; i < 8; ++i)
    {
      float weight = walk.share * weights[i];
      if (weight > least)
      {
        addProbe(probes[i], weight, sums);
      }
    }
  }
}

// Irradiance at a point of a surface, divided by pi. D: mean direction of the unoccluded light, N if nothing nearby
// occludes it. V, reach: as for fieldWeights().
vec3 fieldIrradiance(vec3 P, vec3 N, vec3 D, vec3 V, float reach)
{
  vec4 sums[GI_FIELD_HARMONICS];
  addProbesAround(P, N, V, reach, sums);
  return harmonicLight(sums, D);
}
