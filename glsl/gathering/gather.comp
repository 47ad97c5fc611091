#version 430 core
// Gathers the light that arrives at points in space or on surfaces, by path tracing. An invocation traces only one
// path, as software GL ends loops after 65535 iterations, counted over all loops of an invocation. A group adds up the
// paths of one point or of a few. Variants: GI_HEMISPHERE (points with normals), GI_DIRECTIONAL (with normals, and with
// the light's distribution over directions), and those of path_tracing/paths.glsl.
#define GI_POSITIONAL 1
#include "shared/light.h"
#include "shared/gathering.h"
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/lights.glsl"
#include "lib/phong.glsl"
#include "lib/pbr.glsl"
#include "lib/sampling.glsl"
#include "lib/light_points.glsl"
#include "lib/spherical_harmonics.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"
#include "rays/toward_light.glsl"
#include "path_tracing/paths.glsl"

#ifdef GI_HEMISPHERE
#ifdef GI_DIRECTIONAL
const int COLORS = 5;
#else
const int COLORS = 1;
#endif
#else
const int COLORS = GI_HARMONICS;
#endif
const int NUMBERS = 3 * COLORS + GI_GATHER_SURROUNDINGS;
const int MAX_LIGHTS = 4; // with more lights, a random one is sampled
const int GATHER_POINT = -1; // bounce index of the point itself, before a path's first surface

layout(local_size_x = GI_GATHER_GROUP) in;

uniform int pointCount;
uniform int firstSample;
uniform int samples;
uniform int lanes;     // invocations of a group per point, a power of two
uniform int blocks;    // groups per point, if it has more samples than a group
uniform int seedOfAll;
uniform float offset;  // distance of rays' origins from the surface
uniform bool lamps;    // gather the lights' direct light
uniform bool indirect; // gather all other light

vec3 lightSums[COLORS];
shared float partialSums[GI_GATHER_GROUP * NUMBERS];

// Adds a sample. radiance: from direction L, divided by the density of L.
void add(vec3 N, vec3 L, vec3 radiance)
{
  radiance = any(isnan(radiance)) || any(isinf(radiance)) ? vec3(0.0) : radiance;
#ifdef GI_HEMISPHERE
  float facing = max(dot(N, L), 0.0);
  lightSums[0] += radiance * (facing / GI_PI);
#ifdef GI_DIRECTIONAL
  vec3 mean = facing > 0.0 ? radiance / (2.0 * GI_PI) : vec3(0.0);
  lightSums[1] += mean;
  lightSums[2] += mean * L.x;
  lightSums[3] += mean * L.y;
  lightSums[4] += mean * L.z;
#endif
#else
  float y[GI_HARMONICS];
  giHarmonics(L, y);
  for (int i = 0; i < GI_HARMONICS; ++i)
  {
    lightSums[i] += radiance * y[i];
  }
#endif
}

// Probability density per solid angle of sampleDirection().
float directionDensity(vec3 N, vec3 L)
{
#ifdef GI_HEMISPHERE
  float cosine = max(dot(N, L), 0.0) / GI_PI;
#ifdef GI_DIRECTIONAL
  return cosine > 0.0 ? 0.5 * cosine + 0.25 / GI_PI : 0.0;
#else
  return cosine;
#endif
#else
  return 0.25 / GI_PI;
#endif
}

vec3 sampleDirection(vec3 N, vec2 u)
{
#ifdef GI_HEMISPHERE
#ifdef GI_DIRECTIONAL
  // Half of the samples have uniform density over the hemisphere, the other half cosine density.
  bool even = u.x < 0.5;
  u.x = even ? 2.0 * u.x : 2.0 * u.x - 1.0;
  return giBasis(N) * (even ? giSamplePower(u, 0.0) : giSampleCosine(u));
#else
  return giBasis(N) * giSampleCosine(u);
#endif
#else
  float z = 2.0 * u.x - 1.0;
  float phi = 2.0 * GI_PI * u.y;
  float radius = sqrt(max(0.0, 1.0 - z * z));
  return vec3(radius * cos(phi), radius * sin(phi), z);
#endif
}

// Adds samples of the sources: a point of the emitters, a direction of the sky.
void addSources(vec3 P, vec3 N, inout uint state)
{
  if (emitterCount > 0)
  {
    EmitterPoint point = emitterPoint(sample2D(GATHER_POINT, 0), P, vec3(0.0), state);
    vec3 L = normalize(point.path);
    float other = directionDensity(N, L);
    if (other > 0.0 && point.density > 0.0 && dot(point.emission, vec3(1.0)) > 0.0 &&
      !blocked(Ray(P, 0.0, point.path, 1.0 - 1e-4), state))
    {
      add(N, L, point.emission * (giPowerHeuristic(point.misDensity, other) / point.density));
    }
  }
#ifdef GI_RAY_SKY
  float density;
  vec3 L = raySkySample(sample2D(GATHER_POINT, 2), density);
  float other = directionDensity(N, L);
  if (other > 0.0 && density > 0.0 && !blocked(Ray(P, 0.0, L, RAY_FAR), state))
  {
    add(N, L, raySkyRadiance(L) * (giPowerHeuristic(density, other) / density));
  }
#endif
}

// Adds the lights' direct light, with an irradiance of pi times their colour, as on Phong materials.
void addLights(vec3 P, vec3 N, inout uint state)
{
  bool all = lightCount <= MAX_LIGHTS;
  for (int i = 0; i < (all ? lightCount : 1); ++i)
  {
    int chosen = all ? i : min(int(giRandom(state) * float(lightCount)), lightCount - 1);
    LightData light = lights[chosen];
    light.Kind.z = 0; // there is no eye
    RayArrival arrival = rayArrival(light, P, eye, state);
    vec3 direction = arrival.toward.xyz;
    vec3 irradiance = light.Color.rgb * (arrival.share * GI_PI * (all ? 1.0 : float(lightCount)));
    bool faces = true;
#ifdef GI_HEMISPHERE
    faces = dot(N, direction) > 0.0;
#endif
    if (faces && dot(irradiance, vec3(1.0)) > 0.0 &&
      !blocked(Ray(P, 0.0, direction, arrival.toward.w), state))
    {
      add(N, normalize(direction), irradiance);
    }
  }
}

// Adds the light along a random ray.
void addPath(vec3 P, vec3 N, inout uint state, inout vec3 surroundings)
{
  vec3 L = sampleDirection(N, sample2D(GATHER_POINT, 1));
  float density = directionDensity(N, L);
  if (density <= 0.0)
  {
    return;
  }
  Ray ray = Ray(P, 0.0, L, RAY_FAR);
  RaySurfacePoint at;
  float first;
  RayHit hit = traceThrough(ray, at, first, state);
  if (hit.instance >= 0)
  {
    surroundings += vec3(at.front ? 0.0 : 1.0, 1.0, length(at.position - P));
    // The origin is the point itself, as the weight of an emitter needs the distance from there.
    add(N, L, pathRadiance(Ray(P, 0.0, L, RAY_FAR), at, density, state) / density);
  }
#ifdef GI_RAY_SKY
  else
  {
    add(N, L, raySkyRadiance(L) * (giPowerHeuristic(density, raySkyDensity(L)) / density));
  }
#endif
}

void main()
{
  int local = int(gl_LocalInvocationID.x);
  int lane = local % lanes;
  int group = int(gl_WorkGroupID.x + gl_WorkGroupID.y * gl_NumWorkGroups.x);
  int block = group % blocks;
  int point = group / blocks * (GI_GATHER_GROUP / lanes) + local / lanes;
  int number = block * GI_GATHER_GROUP + lane;
  for (int i = 0; i < COLORS; ++i)
  {
    lightSums[i] = vec3(0.0);
  }
  vec3 surroundings = vec3(0.0);
  if (point < pointCount && number < samples)
  {
    vec3 N = gatherPoints[point].Normal.xyz;
    vec3 P = gatherPoints[point].Position.xyz + offset * N;
    // Seed by the position, so that a point's samples do not depend on the other points.
    uvec3 bits = floatBitsToUint(P);
    seed = giHash(bits.x ^ giHash(bits.y ^ giHash(bits.z ^ giHash(uint(seedOfAll)))));
    sampleNumber = firstSample + number;
    uint state = giHash(seed ^ giHash(uint(sampleNumber)));
    if (indirect)
    {
      addSources(P, N, state);
    }
    if (lamps)
    {
      addLights(P, N, state);
    }
    if (indirect)
    {
      addPath(P, N, state, surroundings);
    }
  }
  for (int i = 0; i < COLORS; ++i)
  {
    partialSums[local * NUMBERS + 3 * i] = lightSums[i].r;
    partialSums[local * NUMBERS + 3 * i + 1] = lightSums[i].g;
    partialSums[local * NUMBERS + 3 * i + 2] = lightSums[i].b;
  }
  partialSums[local * NUMBERS + 3 * COLORS + GI_GATHER_BACKS] = surroundings.x;
  partialSums[local * NUMBERS + 3 * COLORS + GI_GATHER_HITS] = surroundings.y;
  partialSums[local * NUMBERS + 3 * COLORS + GI_GATHER_DISTANCE] = surroundings.z;
  barrier();
  for (int k = lane; k < NUMBERS && point < pointCount; k += lanes)
  {
    float sum = 0.0;
    for (int i = 0; i < lanes; ++i)
    {
      sum += partialSums[(local - lane + i) * NUMBERS + k];
    }
    gatherResults[(point * blocks + block) * NUMBERS + k] = sum;
  }
}
