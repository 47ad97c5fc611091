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

// Point `index` of a (0, 2)-sequence in [0, 1). Each seed gives another sequence.
vec2 giSample2D(uint index, uint seed)
{
  uint shuffled = giOwenScramble(index, giHash(seed));
  uvec2 p = uvec2(bitfieldReverse(shuffled), giSobolSecond(shuffled));
  p.x = giOwenScramble(p.x, giHash(seed ^ 0xa511e9b3u));
  p.y = giOwenScramble(p.y, giHash(seed ^ 0x63d83595u));
  return vec2(p >> 8) / 16777216.0;
}
