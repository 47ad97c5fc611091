// Low-discrepancy numbers for the samples of a pixel.

// Jarzynski and Olano 2020, "Hash Functions for GPU Rendering" (JCGT 9:3): PCG.
uint giHash(uint v)
{
  uint state = v * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// Burley 2020, "Practical Hash-based Owen Scrambling" (JCGT 9:4).
uint giOwenScramble(uint v, uint seed)
{
  v = bitfieldReverse(v);
  v += seed;
  v ^= v * 0x6c50b47cu;
  v ^= v * 0xb82f1e52u;
  v ^= v * 0xc7afe638u;
  v ^= v * 0x8d22f6e6u;
  return bitfieldReverse(v);
}

// The second dimension of Sobol's sequence (1967); the first is the reversed index.
uint giSobolSecond(uint index)
{
  uint result = 0u;
  for (uint v = 0x80000000u; index != 0u; index >>= 1, v ^= v >> 1)
  {
    result ^= (index & 1u) != 0u ? v : 0u;
  }
  return result;
}

// Point `index` of Sobol's (0, 2)-sequence in [0, 1), scrambled.
vec2 giSobolPoint(uint index, uint seed)
{
  uvec2 p = uvec2(bitfieldReverse(index), giSobolSecond(index));
  p.x = giOwenScramble(p.x, giHash(seed ^ 0xa511e9b3u));
  p.y = giOwenScramble(p.y, giHash(seed ^ 0x63d83595u));
  return vec2(p >> 8) / 16777216.0;
}

// Point `index` of a (0, 2)-sequence in [0, 1). Each seed gives another sequence.
vec2 giSample2D(uint index, uint seed)
{
  return giSobolPoint(giOwenScramble(index, giHash(seed)), seed);
}

// The same for pixels whose results are averaged with those of their neighbours: point `index` of a pixel's (0, 2)-sequence.
// The 4 x 4 pixels of a tile share a sequence: its first 16 points are their first samples, the next 16 their second samples.
// So the points of a tile are evenly distributed in each frame and over frames (after Ahmed and Wonka 2020, Screen-Space
// Blue-Noise Diffusion of Monte Carlo Sampling Error via Hierarchical Ordering of Pixels). Each seed gives other sequences.
vec2 giTileSample2D(uint index, ivec2 pixel, uint seed)
{
  // Bits of the index choose which of 16 points a pixel takes. A search found these columns, with which the points of each
  // pixel alone are a (0, 2)-sequence, too: up to 4096 points (tests/gpu/TestSequence.cxx).
  const uint columns[12] = uint[](3u, 1u, 12u, 4u, 2u, 3u, 8u, 12u, 1u, 2u, 4u, 8u);
  uint tile = giHash(uint(pixel.x >> 2) + (uint(pixel.y >> 2) << 16)) + giHash(seed);
  uint shuffled = giOwenScramble(index, giHash(tile));
  ivec2 place = pixel & 3;
  uint choice = uint((place.x & 1) | (place.y & 1) << 1 | (place.x & 2) << 1 | (place.y & 2) << 2);
  for (int i = 0; i < 12; ++i)
  {
    choice ^= (shuffled >> i & 1u) != 0u ? columns[i] : 0u;
  }
  return giSobolPoint(shuffled << 4 | choice, tile);
}
