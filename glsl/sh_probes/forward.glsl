// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Baked probes for what VTK draws itself. Needs lib/octahedral.glsl, lib/cube_light.glsl and
// lib/spherical_harmonics.glsl.
#include "probes/field.glsl"
#include "sh_probes/light.glsl"

// In place of a surface: all around a point, which probes on every side light alike.
void fieldCubeAt(vec3 P, vec3 V, float reach, mat3 turn, inout vec3 cube[6])
{
  vec4 sums[LIGHT_TEXELS];
  addProbesAround(P, vec3(0.0), V, reach, sums);
  for (int side = 0; side < 6; ++side)
  {
    cube[side] = harmonicLight(sums, turn * GI_CUBE_SIDES[side]);
  }
}
#include "probes/forward.glsl"
