// Evenly spread numbers, and directions made of them.

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

// Point `index` of a (0, 2)-sequence of its own for every seed, in [0, 1).
vec2 giSample2D(uint index, uint seed)
{
  uint shuffled = giOwenScramble(index, giHash(seed));
  uvec2 p = uvec2(bitfieldReverse(shuffled), giSobolSecond(shuffled));
  p.x = giOwenScramble(p.x, giHash(seed ^ 0xa511e9b3u));
  p.y = giOwenScramble(p.y, giHash(seed ^ 0x63d83595u));
  return vec2(p >> 8) / 16777216.0;
}

// Duff et al. 2017, "Building an Orthonormal Basis, Revisited" (JCGT 6:1): z is n.
mat3 giBasis(vec3 n)
{
  float s = n.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (s + n.z);
  float b = n.x * n.y * a;
  return mat3(vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x), vec3(b, s + n.y * n.y * a, -n.y), n);
}

// By the cosine to z; density cos / pi (Malley's method: Pharr, Jakob, Humphreys 2016, PBRT, 13.6.3).
vec3 giSampleCosine(vec2 u)
{
  float radius = sqrt(u.x);
  float phi = 6.28318530717959 * u.y;
  return vec3(radius * cos(phi), radius * sin(phi), sqrt(max(0.0, 1.0 - u.x)));
}

// By a power of the cosine to z; density (n + 1) / (2 pi) cos^n.
vec3 giSamplePower(vec2 u, float n)
{
  float z = pow(u.x, 1.0 / (n + 1.0));
  float radius = sqrt(max(0.0, 1.0 - z * z));
  float phi = 6.28318530717959 * u.y;
  return vec3(radius * cos(phi), radius * sin(phi), z);
}

// A normal of the GGX distribution of width a; density D cos (Walter et al. 2007).
vec3 giSampleGGX(vec2 u, float a)
{
  float z2 = (1.0 - u.x) / (1.0 + (a * a - 1.0) * u.x);
  float radius = sqrt(max(0.0, 1.0 - z2));
  float phi = 6.28318530717959 * u.y;
  return vec3(radius * cos(phi), radius * sin(phi), sqrt(z2));
}

// Evenly over a triangle: weights of its second and third vertex (Osada et al. 2002).
vec2 giSampleTriangle(vec2 u)
{
  float root = sqrt(u.x);
  return vec2(root * (1.0 - u.y), root * u.y);
}
