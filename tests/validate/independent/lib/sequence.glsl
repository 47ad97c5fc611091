// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Replaces glsl/lib/sequence.glsl by independent random numbers.

// Jarzynski and Olano 2020, "Hash Functions for GPU Rendering" (JCGT 9:3): PCG.
uint giHash(uint v)
{
  uint state = v * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

vec2 giSample2D(uint index, uint seed)
{
  uint x = giHash(giHash(index) ^ giHash(seed));
  uint y = giHash(x ^ 0xa511e9b3u);
  return vec2(uvec2(x, y) >> 8) / 16777216.0;
}

vec2 giTileSample2D(uint index, ivec2 pixel, uint seed)
{
  return giSample2D(index, giHash(uint(pixel.x) + (uint(pixel.y) << 16)) + seed);
}
