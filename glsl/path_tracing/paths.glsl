// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Radiance along a ray, by path tracing: Kajiya 1986, "The Rendering Equation"; next-event estimation
// and multiple importance sampling after Veach 1997, "Robust Monte Carlo Methods for Light Transport
// Simulation". Needs shared/light.h, rays/surface.glsl, rays/passage.glsl, rays/toward_light.glsl, lib/lights.glsl,
// lib/phong.glsl, lib/pbr.glsl, lib/sampling.glsl. Variants: GI_RAY_SKY (the environment shines), and those of
// rays/passage.glsl. The including shader sets the seed and the sample number.
#ifdef GI_RAY_SKY
#include "rays/sky.glsl"
#endif
#include "path_tracing/reflection.glsl"
#include "rays/emitters.glsl"

uniform vec3 eye;          // relative to the scene's origin
uniform int bounces;
uniform int lightCount;
uniform int strategy;      // 0 both, 1 light sampling, 2 BSDF sampling

uint seed;        // of the sample sequences
int sampleNumber; // of the current path

vec2 sample2D(int bounce, int purpose)
{
  return giSample2D(uint(sampleNumber), seed + uint(bounce * 4 + purpose) * 0x9e3779b9u);
}

// Radiance that a surface reflects from an unoccluded light toward V. A VTK light stands for an
// irradiance of pi times its colour on Phong materials, and of its colour on PBR materials.
vec3 lightReflected(LightData light, GiReflector r, vec3 position, bool seen)
{
  if (light.Kind.x == GI_LIGHT_HEADLIGHT && seen)
  {
    if (r.pbr)
    {
      return light.Color.rgb * giReflectPointLight(r, r.V);
    }
    float facing = max(0.000001, dot(r.N, -light.Direction.xyz));
    return light.Color.rgb * (r.albedo * facing + r.specular * pow(facing, r.power));
  }
  GiIncident incident = giIncident(light, position);
  vec3 reaching = light.Color.rgb * incident.Attenuation * (r.pbr ? 1.0 : GI_PI);
  return reaching * giReflectPointLight(r, -incident.Travel);
}

// A sample of direct light and its shadow ray.
struct Arrival
{
  vec3 reflected; // radiance toward the viewer if the light is unoccluded
  vec4 toward;    // the shadow ray, as from rayTowardLight()
  bool open;      // nothing can occlude the light
};

Arrival fromLight(LightData light, GiReflector r, RaySurfacePoint at, bool seen, vec2 u)
{
  if (giHasShape(light))
  {
    RayArrival arrival = rayArrival(light, at.position, eye, u);
    return Arrival(light.Color.rgb * (arrival.share * (r.pbr ? 1.0 : GI_PI)) * giReflect(r, arrival.L),
      arrival.toward, false);
  }
  // A headlight reaches everything that the eye sees.
  return Arrival(lightReflected(light, r, at.position, seen),
    rayTowardLight(light, at.position, eye), light.Kind.z != 0 && seen);
}

Arrival fromEmitter(vec2 u, GiReflector r, RaySurfacePoint at, inout uint state)
{
  EmitterPoint point = emitterPoint(u, at.position, vec3(0.0), state);
  vec3 L = normalize(point.path);
  float weight = strategy == 1 ? 1.0 : giPowerHeuristic(point.misDensity, giReflectionDensity(r, L));
  vec3 reflected = giReflect(r, L) * giArriving(r, point.emission) * weight;
  return Arrival(point.density > 0.0 ? reflected / point.density : vec3(0.0),
    vec4(point.path, 1.0 - 1e-4), false);
}

#ifdef GI_RAY_SKY
// Radiance that a surface reflects from the environment in direction L toward its viewer, per solid angle.
vec3 skyReflected(GiReflector r, vec3 L)
{
  vec3 even = giArriving(r, raySkyRadiance(L));
  vec3 gloss = giArriving(r, raySkyGloss(L));
  return even == gloss ? giReflect(r, L) * even
                       : (giReflect(r, L) - giReflectGloss(r, L)) * even + giReflectGloss(r, L) * gloss;
}

Arrival fromSky(vec2 u, GiReflector r)
{
  float density;
  vec3 L = raySkySample(u, density);
  float weight = strategy == 1 ? 1.0 : giPowerHeuristic(density, giReflectionDensity(r, L));
  return Arrival(density > 0.0 ? skyReflected(r, L) * weight / density : vec3(0.0),
    vec4(L, RAY_FAR), false);
}
#endif

// Estimates the direct light that a surface reflects to its viewer, from the lights, one point of the emitters and one
// direction of the sky.
vec3 directLight(GiReflector r, RaySurfacePoint at, bool seen, int bounce, inout uint state)
{
  vec3 sum = vec3(0.0);
  // All lights at the first surface, a random one at later ones.
  bool all = seen || lightCount <= 1;
  int lightSamples = all ? lightCount : min(lightCount, 1);
  int emitterSamples = emitterCount > 0 && strategy != 2 ? 1 : 0;
#ifdef GI_RAY_SKY
  int skySamples = strategy != 2 ? 1 : 0;
#else
  const int skySamples = 0;
#endif
  for (int i = 0; i < lightSamples + emitterSamples + skySamples; ++i)
  {
    Arrival arrival;
    if (i < lightSamples)
    {
      int chosen = all ? i : min(int(giRandom(state) * float(lightCount)), lightCount - 1);
      vec2 u = giSample2D(uint(sampleNumber), seed + uint(bounce * 4 + 3 + chosen * 4096) * 0x9e3779b9u);
      arrival = fromLight(lights[chosen], r, at, seen, u);
      arrival.reflected *= all ? 1.0 : float(lightCount);
    }
    else if (i < lightSamples + emitterSamples)
    {
      arrival = fromEmitter(sample2D(bounce, 0), r, at, state);
    }
#ifdef GI_RAY_SKY
    else
    {
      arrival = fromSky(sample2D(bounce, 2), r);
    }
#endif
    if (dot(arrival.reflected, vec3(1.0)) > 0.0)
    {
      bool open = arrival.open || rayReaches(arrival.toward, at, state);
      sum += open ? arrival.reflected : vec3(0.0);
    }
  }
  return sum;
}

// Radiance along a ray, given its first surface. density: probability density per solid angle with which the ray's
// direction was sampled, for its weight against light sampling; 0 for a ray from the eye.
vec3 pathRadiance(Ray ray, RaySurfacePoint at, float density, inout uint state)
{
  bool fromEye = density <= 0.0;
  vec3 radiance = vec3(0.0);
  vec3 throughput = vec3(1.0);
  // Where indirect light arrives as on surfaces coloured by data, radiance and throughput start from scratch there.
  vec3 before = vec3(0.0);
  vec3 reflectance = vec3(0.0);
  bool held = false;
  vec3 from = ray.origin;
  // After the last reflection, one more ray finds emitters and the sky.
#ifdef GI_RAY_SKY
  int last = bounces + (strategy != 1 ? 1 : 0);
#else
  int last = bounces + (emitterCount > 0 && strategy != 1 ? 1 : 0);
#endif
  for (int bounce = 0; bounce <= last; ++bounce)
  {
    RaySurface surface = raySurfaces[at.surface];
    float weight = 1.0;
    if ((bounce > 0 || !fromEye) && surface.Emission.w > 0.0)
    {
      float other = emitterMisDensity(surface, from, at.position, at.geometric);
      weight = strategy == 0 ? giPowerHeuristic(density, other) : (strategy == 1 ? 0.0 : 1.0);
    }
    radiance += throughput * at.emission * weight;
    if (bounce > bounces || (surface.Where.z & GI_SURFACE_MODEL) == GI_SURFACE_UNLIT)
    {
      break;
    }
    // VTK takes the view direction from the camera's position in a parallel projection too.
    bool seen = bounce == 0 && fromEye;
    vec3 V = seen ? normalize(eye - at.position) : -ray.direction;
    GiReflector r = giReflector(at, surface.Where.z & GI_SURFACE_MODEL, V);
    r.data = seen && giDataKeepsHue && rayColoredByData(surface);
    radiance += throughput * directLight(r, at, seen, bounce, state);
    if (bounce == last)
    {
      break;
    }
    vec3 L = giSampleReflection(r, giRandom(state), sample2D(bounce, 1));
    density = giReflectionDensity(r, L);
    vec3 arriving = throughput / max(density, 1e-30); // still to be multiplied by the reflectance
    throughput *= density > 0.0 ? giReflect(r, L) / density : vec3(0.0);
    float survive = bounce < 3 ? 1.0 : min(0.95, max(throughput.r, max(throughput.g, throughput.b)));
    bool closed;
    vec3 origin = rayArrive(at, L, closed);
    if (closed || dot(throughput, vec3(1.0)) <= 0.0 || giRandom(state) >= survive)
    {
      break;
    }
    throughput /= survive;
    if (r.data)
    {
      held = true;
      before = radiance;
      reflectance = throughput;
      radiance = vec3(0.0);
      throughput = vec3(1.0);
    }
    from = at.position;
    ray = Ray(origin, 0.0, L, RAY_FAR);
    float first;
    RayHit hit = traceThrough(ray, at, first, state);
    if (hit.instance < 0)
    {
#ifdef GI_RAY_SKY
      float other = raySkyDensity(L);
      float share = strategy == 0 ? giPowerHeuristic(density, other) : (strategy == 1 ? 0.0 : 1.0);
      vec3 shining = arriving / survive * skyReflected(r, L) * share;
      before += r.data ? shining : vec3(0.0);
      radiance += r.data ? vec3(0.0) : shining;
#endif
      break;
    }
  }
  return held ? before + reflectance * giDataLight(radiance) : radiance;
}
