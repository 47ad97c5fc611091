// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// DDGI's probes for what VTK draws itself. Needs lib/octahedral.glsl and lib/cube_light.glsl.
#include "ddgi/field.glsl"

// In place of a surface: all around a point, which probes on every side light alike.
void fieldCubeAt(vec3 P, vec3 V, float reach, mat3 turn, inout vec3 cube[6])
{
  const float least = 1e-4; // less makes no difference that is seen
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
