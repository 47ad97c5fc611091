// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Light of probes on props that VTK draws itself (see forward/indirect.glsl). Needs probes/field.glsl,
// fieldIrradiance() and fieldCubeAt().
uniform mat4 fieldFromView;
uniform float fieldIntensity;

vec4 fieldIndirect(vec3 P, vec3 N, vec3 V, float reach)
{
  if (fieldColumns == 0)
  {
    return vec4(0.0); // this mapper sets no uniforms
  }
  mat3 turn = mat3(fieldFromView);
  vec3 place = (fieldFromView * vec4(P, 1.0)).xyz;
  vec3 D = turn * N; // there is no bent normal here
  return vec4(fieldIntensity * fieldIrradiance(place, D, D, turn * V, reach), 1.0);
}

float fieldIndirectCube(vec3 P, vec3 V, float reach, out vec3 cube[6])
{
  for (int side = 0; side < 6; ++side)
  {
    cube[side] = vec3(0.0);
  }
  if (fieldColumns == 0)
  {
    return 0.0;
  }
  mat3 turn = mat3(fieldFromView);
  fieldCubeAt((fieldFromView * vec4(P, 1.0)).xyz, turn * V, reach, turn, cube);
  for (int side = 0; side < 6; ++side)
  {
    cube[side] *= fieldIntensity;
  }
  return 1.0;
}

float fieldGrain()
{
  return fieldCellSize(fieldGridOf(fieldGrids - 1));
}
