// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Real spherical harmonics of the bands 0 to 2, orthonormal over the sphere, in the order and with the signs
// of Ramamoorthi and Hanrahan 2001, An Efficient Representation for Irradiance Environment Maps.
const int GI_HARMONICS = 9;

// Values of all nine harmonics in a unit direction.
void giHarmonics(vec3 d, out float y[GI_HARMONICS])
{
  y[0] = 0.28209479177;           // sqrt(1 / (4 pi))
  y[1] = 0.48860251190 * d.y;     // sqrt(3 / (4 pi))
  y[2] = 0.48860251190 * d.z;
  y[3] = 0.48860251190 * d.x;
  y[4] = 1.09254843059 * d.x * d.y; // sqrt(15 / (4 pi))
  y[5] = 1.09254843059 * d.y * d.z;
  y[6] = 0.31539156525 * (3.0 * d.z * d.z - 1.0); // sqrt(5 / (16 pi))
  y[7] = 1.09254843059 * d.x * d.z;
  y[8] = 0.54627421529 * (d.x * d.x - d.y * d.y);
}
