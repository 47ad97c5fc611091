// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Light of baked probes on props that VTK draws itself. Needs lib/octahedral.glsl, lib/cube_light.glsl and
// lib/spherical_harmonics.glsl.
#include "probes/field.glsl"
#include "sh_probes/light.glsl"

// Light from all around a point in space, where no surface excludes the probes on one side.
void fieldCubeAt(vec3 P, vec3 V, float reach, mat3 turn, inout vec3 cube[6])
{
  vec4 sums[GI_FIELD_HARMONICS];
  addProbesAround(P, vec3(0.0), V, reach, sums);
  vec3 colors[GI_HARMONICS];
  for (int k = 0; k < GI_HARMONICS; ++k)
  {
    colors[k] = harmonicColor(sums, k);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    // In opposite directions only the sign of band 1 differs.
    float y[GI_HARMONICS];
    giHarmonics(turn * GI_CUBE_SIDES[2 * axis], y);
    vec3 even = y[0] * colors[0];
    for (int k = 4; k < GI_HARMONICS; ++k)
    {
      even += y[k] * colors[k];
    }
    vec3 odd = y[1] * colors[1] + y[2] * colors[2] + y[3] * colors[3];
    cube[2 * axis] = lightScale * max(even + odd, vec3(0.0));
    cube[2 * axis + 1] = lightScale * max(even - odd, vec3(0.0));
  }
}
#include "probes/forward.glsl"
