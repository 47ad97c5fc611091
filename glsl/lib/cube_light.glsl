// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Irradiance in any direction from its values in the six axis directions. Irradiance is nearly a quadratic polynomial
// of the direction (Ramamoorthi and Hanrahan 2001, An Efficient Representation for Irradiance Environment Maps). The
// six values determine such a polynomial except for its mixed terms.
const vec3 GI_CUBE_SIDES[6] = vec3[6](vec3(1.0, 0.0, 0.0), vec3(-1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0),
  vec3(0.0, -1.0, 0.0), vec3(0.0, 0.0, 1.0), vec3(0.0, 0.0, -1.0));

// Irradiance in the unit direction N.
vec3 giCubeLight(vec3 cube[6], vec3 N)
{
  vec3 sum = vec3(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    vec3 even = 0.5 * (cube[2 * axis] + cube[2 * axis + 1]);
    vec3 odd = 0.5 * (cube[2 * axis] - cube[2 * axis + 1]);
    sum += N[axis] * (N[axis] * even + odd);
  }
  return max(sum, vec3(0.0));
}

// Mean irradiance over all directions.
vec3 giCubeMean(vec3 cube[6])
{
  return (cube[0] + cube[1] + cube[2] + cube[3] + cube[4] + cube[5]) / 6.0;
}
