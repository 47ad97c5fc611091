#version 430 core
// Traces a ray of a probe: the radiance of the surface that it hits, lit by the lights and by the probes, and the
// distance. Further rays go from the probe to points of the emitters, as chance rarely finds small ones. Variants:
// GI_SKY_APART (another technique lights surfaces by what arrives straight from the environment), and those of
// rays/hit_light.glsl and rays/passage.glsl.
#define GI_POSITIONAL 1
#include "shared/light.h"
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/lights.glsl"
#include "lib/sampling.glsl"
#include "lib/light_points.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"
#include "rays/toward_light.glsl"
#include "rays/emitters.glsl"
#ifdef GI_RAY_SKY
#define GI_RAY_SKY_CELLS 1
#include "rays/sky.glsl"
#endif
#include "rays/hit_light.glsl"
#include "ddgi/field.glsl"
#include "ddgi/seen_field.glsl"
#include "ddgi/directions.glsl"
#include "ddgi/packed_direction.glsl"
#include "ddgi/states.glsl"

layout(local_size_x = 64) in;

// One row per probe. Rays in all directions: radiance, distance. Then rays to emitters: what they add to the irradiance,
// divided by pi, of a surface that faces them, and their direction by fieldPackDirection(). If
// keepsEmitted, then for each ray in all directions, the part of its radiance that comes straight from emitters.
layout(rgba32f, binding = 0) uniform writeonly image2D found;

uniform int rays;
uniform int emitterRays; // in addition
uniform int part;        // of both, these are traced: one in `parts`
uniform bool keepsEmitted;
uniform int update;
uniform int firstProbe;
uniform int lastProbe; // one past it
uniform bool lit;  // whether the probes hold light yet

const float PI = 3.14159265;

bool isBroken(vec4 result)
{
  return any(isnan(result)) || any(isinf(result));
}

// Black instead of a colour that is no number; the distance stays.
vec4 soundResult(vec4 result)
{
  return isBroken(result) ? vec4(vec3(0.0), isBroken(vec4(result.a)) ? RAY_FAR : result.a) : result;
}

// Whether rays to emitters find an emitting point rather than rays in all directions: whichever would sample it more
// densely if it faced the probe, so that light from all around stays free of noise (a partition of the points between
// two ways to sample them, as in the maximum heuristic: Veach 1997, Robust Monte Carlo Methods for Light Transport
// Simulation). perArea: density of the choice of points by their power.
bool emitterIsSought(float perArea, vec3 path)
{
  return float(emitterRays) * perArea * dot(path, path) > float(rays) / (4.0 * PI);
}

vec4 emitterLight(vec3 origin, int probe, int number, inout uint state)
{
  uint index = uint(update * emitterRays + number);
  vec2 u = giSample2D(index, giHash(uint(probe)));
  EmitterChoice choice = emitterChoice(state);
  for (int i = 0; i < EMITTER_CANDIDATES; ++i)
  {
    EmitterPoint point = emitterPoint(emitterCandidate(u, i), origin, vec3(0.0), state);
    bool sought = point.density > 0.0 && emitterIsSought(point.perArea, point.path);
    emitterConsider(choice, point.path, sought ? point.emission / (PI * float(emitterRays / parts) * point.density) : vec3(0.0));
  }
  bool arrives = choice.sum > 0.0 && !blocked(Ray(origin, 0.0, choice.path, 1.0 - 1e-4), state);
  return vec4(arrives ? emitterArriving(choice) : vec3(0.0), fieldPackDirection(normalize(choice.path)));
}

void main()
{
  int traced = (rays + emitterRays) / parts; // by each probe
  int index = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x);
  int probe = firstProbe + index / traced;
  if (probe >= lastProbe)
  {
    return;
  }
  if (probeRests(probe, update, probeState(probe)))
  {
    return;
  }
  int number = part + parts * (index % traced);
  uint state = giHash(uint(probe * (rays + emitterRays) + number) ^ giHash(uint(update) * 0x9e3779b9u));
  vec3 start = fieldPosition(fieldGridWith(probe), probe);
  if (number >= rays)
  {
    vec4 light = emitterLight(start, probe, number - rays, state);
    imageStore(found, ivec2(number, probe), isBroken(light) ? vec4(0.0) : light);
    return;
  }
  vec3 direction = fieldTurn(probe, update) * fieldDirection(number);
  Ray ray = Ray(start, 0.0, direction, RAY_FAR);
  RaySurfacePoint at;
  float first;
  RayHit hit = traceThrough(ray, at, first, state);
  vec4 result = vec4(0.0, 0.0, 0.0, RAY_FAR);
  vec4 straight = vec4(0.0); // from emitters that can be sought
  if (hit.instance >= 0)
  {
    bool sought = emitterIsSought(raySurfaces[at.surface].Emission.w, at.position - start);
    result.a = length(at.position - start);
    vec3 emitted = sought ? vec3(0.0) : at.emission;
    result.rgb = emitted + (lit ? fieldReflected(at, RAY_FAR, state) : hitReflected(at, state));
    straight.rgb = raySurfaces[at.surface].Emission.w > 0.0 ? emitted : vec3(0.0);
  }
#if defined(GI_RAY_SKY) && !defined(GI_SKY_APART)
  else
  {
    result.rgb = raySkyMean(direction);
  }
#endif
  imageStore(found, ivec2(number, probe), soundResult(result));
  if (keepsEmitted)
  {
    imageStore(found, ivec2(rays + emitterRays + number, probe), isBroken(result) ? vec4(0.0) : straight);
  }
}
