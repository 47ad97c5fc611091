// Maps uniform random numbers to directions and points.
#include "lib/sequence.glsl"

// A pseudo-random number in [0, 1). Advances the state.
float giRandom(inout uint state)
{
  state = giHash(state);
  return float(state >> 8) / 16777216.0;
}

// An orthonormal basis whose z axis is n: Duff et al. 2017, "Building an Orthonormal Basis, Revisited" (JCGT 6:1).
mat3 giBasis(vec3 n)
{
  float s = n.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (s + n.z);
  float b = n.x * n.y * a;
  return mat3(vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x), vec3(b, s + n.y * n.y * a, -n.y), n);
}

// Weight of a sample with density a that another strategy takes with density b (Veach 1997, Robust Monte Carlo Methods for
// Light Transport Simulation, 9.2.4).
float giPowerHeuristic(float a, float b)
{
  return a * a / max(a * a + b * b, 1e-30);
}

// A point with uniform density over the unit disc.
vec2 giSampleDisc(vec2 u)
{
  float phi = 6.28318530717959 * u.y;
  return sqrt(u.x) * vec2(cos(phi), sin(phi));
}

// A direction about z with density cos / pi (Malley's method: Pharr, Jakob, Humphreys 2016, PBRT, 13.6.3).
vec3 giSampleCosine(vec2 u)
{
  float radius = sqrt(u.x);
  float phi = 6.28318530717959 * u.y;
  return vec3(radius * cos(phi), radius * sin(phi), sqrt(max(0.0, 1.0 - u.x)));
}

// A direction about z with density (n + 1) / (2 pi) cos^n.
vec3 giSamplePower(vec2 u, float n)
{
  float z = pow(u.x, 1.0 / (n + 1.0));
  float radius = sqrt(max(0.0, 1.0 - z * z));
  float phi = 6.28318530717959 * u.y;
  return vec3(radius * cos(phi), radius * sin(phi), z);
}

// A microfacet normal of the GGX distribution of width a, with density D cos (Walter et al. 2007).
vec3 giSampleGGX(vec2 u, float a)
{
  float z2 = (1.0 - u.x) / (1.0 + (a * a - 1.0) * u.x);
  float radius = sqrt(max(0.0, 1.0 - z2));
  float phi = 6.28318530717959 * u.y;
  return vec3(radius * cos(phi), radius * sin(phi), sqrt(z2));
}

// A point with uniform density over a triangle: the weights of its second and third vertex (Osada et al. 2002).
vec2 giSampleTriangle(vec2 u)
{
  float root = sqrt(u.x);
  return vec2(root * (1.0 - u.y), root * u.y);
}

// A microfacet normal of the GGX distribution of width a, of those visible from V (unit, z up), with density
// D max(0, V H) G1(V) / V.z (Heitz 2018, "Sampling the GGX Distribution of Visible Normals", JCGT 7:4).
vec3 giSampleVisibleGGX(vec2 u, vec3 V, float a)
{
  vec3 stretched = normalize(vec3(a * V.xy, V.z));
  float across = dot(stretched.xy, stretched.xy);
  vec3 T1 = across > 0.0 ? vec3(-stretched.y, stretched.x, 0.0) * inversesqrt(across) : vec3(1.0, 0.0, 0.0);
  vec3 T2 = cross(stretched, T1);
  // Warp the disc to the projection of the visible part of the hemisphere.
  vec2 p = giSampleDisc(u);
  float s = 0.5 * (1.0 + stretched.z);
  p.y = (1.0 - s) * sqrt(max(0.0, 1.0 - p.x * p.x)) + s * p.y;
  vec3 n = p.x * T1 + p.y * T2 + sqrt(max(0.0, 1.0 - dot(p, p))) * stretched;
  return normalize(vec3(a * n.xy, max(n.z, 0.0)));
}
