// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Light that varies softly with the direction, in its values along both ways of three axes: the ambient cube of
// McTaggart 2004, Half-Life 2 / Valve Source Shading (Game Developers Conference).
const vec3 GI_CUBE_SIDES[6] = vec3[6](vec3(1.0, 0.0, 0.0), vec3(-1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0),
  vec3(0.0, -1.0, 0.0), vec3(0.0, 0.0, 1.0), vec3(0.0, 0.0, -1.0));

// In a unit direction.
vec3 giCubeLight(vec3 cube[6], vec3 N)
{
  vec3 share = N * N;
  return share.x * cube[N.x < 0.0 ? 1 : 0] + share.y * cube[N.y < 0.0 ? 3 : 2] + share.z * cube[N.z < 0.0 ? 5 : 4];
}

// Over all directions.
vec3 giCubeMean(vec3 cube[6])
{
  return (cube[0] + cube[1] + cube[2] + cube[3] + cube[4] + cube[5]) / 6.0;
}
