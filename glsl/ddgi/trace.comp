#version 430 core
// Traces a ray of a probe: the radiance of the surface that it hits, lit by the lights and by the probes, and the
// distance. Further rays go from the probe to points of the emitters, as chance rarely finds small ones. Variants:
// GI_RAY_SKY (the environment shines), GI_SKY_APART (another technique lights surfaces by what arrives straight from the
// environment), and those of rays/passage.glsl.
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
#include "ddgi/field.glsl"
#include "ddgi/directions.glsl"
#include "ddgi/packed_direction.glsl"
#include "ddgi/states.glsl"

layout(local_size_x = 64) in;

// One row per probe. Rays in all directions: radiance, distance. Then rays to emitters: what they add to the irradiance,
// divided by pi, of a surface that faces them, and their direction by fieldPackDirection().
layout(rgba32f, binding = 0) uniform writeonly image2D found;

uniform vec3 eye; // relative to the scene's origin, for headlights
uniform int rays;
uniform int emitterRays; // in addition
uniform int update;
uniform int lightCount;
uniform int firstProbe;
uniform int lastProbe; // one past it
uniform bool lit;  // whether the probes hold light yet

const float PI = 3.14159265;
const int MAX_LIGHTS = 4; // with more lights, a random one is sampled

// Irradiance from a light, divided by pi. A VTK light stands for an irradiance of pi times its colour on Phong
// materials, and of its colour on PBR materials.
vec3 irradianceFrom(LightData light, RaySurfacePoint at, bool pbr, inout uint state)
{
  RayArrival arrival = rayArrival(light, at.position, eye, state);
  float facing = dot(at.normal, arrival.L);
  if (facing <= 0.0 || arrival.share <= 0.0)
  {
    return vec3(0.0);
  }
  if (!rayReaches(arrival.toward, at, state))
  {
    return vec3(0.0);
  }
  return light.Color.rgb * (arrival.share * facing * (pbr ? 1.0 / PI : 1.0));
}

vec3 directLight(RaySurfacePoint at, bool pbr, inout uint state)
{
  vec3 sum = vec3(0.0);
  bool all = lightCount <= MAX_LIGHTS;
  for (int i = 0; i < (all ? lightCount : 1); ++i)
  {
    int chosen = all ? i : min(int(giRandom(state) * float(lightCount)), lightCount - 1);
    sum += (all ? 1.0 : float(lightCount)) * irradianceFrom(lights[chosen], at, pbr, state);
  }
  return sum;
}

#if defined(GI_RAY_SKY) && defined(GI_SKY_APART)
// Irradiance from one direction of the sky, divided by pi.
vec3 skyLight(RaySurfacePoint at, inout uint state)
{
  float density;
  vec3 L = raySkySample(vec2(giRandom(state), giRandom(state)), density);
  float facing = dot(at.normal, L);
  bool arrives = facing > 0.0 && density > 0.0 && rayReaches(vec4(L, RAY_FAR), at, state);
  return arrives ? raySkyRadiance(L) * (facing / (PI * density)) : vec3(0.0);
}
#endif

bool isBroken(vec4 result)
{
  return any(isnan(result)) || any(isinf(result));
}

// Whether rays to emitters find an emitting point rather than rays in all directions: whichever would sample it more
// densely if it faced the probe, so that light from all around stays free of noise (a partition of the points between
// two ways to sample them, as in the maximum heuristic: Veach 1997, Robust Monte Carlo Methods for Light Transport
// Simulation). perArea: density of the choice of points on emitters.
bool emitterIsSought(float perArea, vec3 path)
{
  return float(emitterRays) * perArea * dot(path, path) > float(rays) / (4.0 * PI);
}

vec4 emitterLight(vec3 origin, int probe, int number, inout uint state)
{
  uint index = uint(update * emitterRays + number);
  EmitterPoint point = emitterPoint(giSample2D(index, giHash(uint(probe))), origin);
  vec3 light = point.emission / (PI * float(emitterRays) * max(point.density, 1e-30));
  bool arrives = emitterIsSought(point.perArea, point.path) && dot(light, vec3(1.0)) > 0.0 &&
    !blocked(Ray(origin, 0.0, point.path, 1.0 - 1e-4), state);
  return vec4(arrives ? light : vec3(0.0), fieldPackDirection(normalize(point.path)));
}

void main()
{
  int index = int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x) +
    firstProbe * (rays + emitterRays);
  int probe = index / (rays + emitterRays);
  if (probe >= lastProbe)
  {
    return;
  }
  if (probeRests(probe, update, probeState(probe)))
  {
    return;
  }
  int number = index - probe * (rays + emitterRays);
  uint state = giHash(uint(index) ^ giHash(uint(update) * 0x9e3779b9u));
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
  if (hit.instance >= 0)
  {
    int model = raySurfaces[at.surface].Where.z & GI_SURFACE_MODEL;
    bool sought = emitterIsSought(raySurfaces[at.surface].Emission.w, at.position - start);
    result.rgb = sought ? vec3(0.0) : at.emission;
    result.a = length(at.position - start);
    if (model != GI_SURFACE_UNLIT)
    {
      bool pbr = model == GI_SURFACE_PBR;
      // All reflection is diffuse here.
      vec3 albedo = pbr
        ? at.occlusion * mix(at.color.rgb * (1.0 - at.specular.w) + at.specular.w, at.color.rgb, at.metallic)
        : at.color.rgb;
      vec3 light = directLight(at, pbr, state);
#if defined(GI_RAY_SKY) && defined(GI_SKY_APART)
      light += skyLight(at, state);
#endif
      if (lit)
      {
        light += fieldIrradiance(at.position, at.normal, at.normal, -direction, result.a);
      }
      result.rgb += min(albedo, vec3(1.0)) * light;
    }
  }
#if defined(GI_RAY_SKY) && !defined(GI_SKY_APART)
  else
  {
    result.rgb = raySkyMean(direction);
  }
#endif
  imageStore(found, ivec2(number, probe), isBroken(result) ? vec4(0.0, 0.0, 0.0, RAY_FAR) : result);
}
