// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Light of DDGI's probes on props that VTK draws itself. Needs lib/octahedral.glsl and lib/cube_light.glsl.
#include "ddgi/field.glsl"

// Light from all around a point in space, where no surface excludes the probes on one side.
void fieldCubeAt(vec3 P, vec3 V, float reach, mat3 turn, inout vec3 cube[6])
{
  const float least = 1e-4; // smaller weights make no visible difference
  fieldEachGrid(P)
  {
    int probes[8];
    float weights[8];
    fieldWeights(walk, P, vec3(0.0), V, reach, true, probes, weights);
    for (int i = 0; i < 8; ++i)
    {
      float weight = walk.share * weights[i];
      for (int side = 0; side < 6 && weight > least; ++side)
      {
        cube[side] += weight * fieldFetch(fieldLight, probes[i], turn * GI_CUBE_SIDES[side], float(GI_FIELD_LIGHT)).rgb;
      }
    }
  }
}
#include "probes/forward.glsl"
