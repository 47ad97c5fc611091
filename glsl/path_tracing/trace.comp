#version 430 core
// One path through every pixel, added to sums. Kajiya 1986, "The Rendering Equation"; next-event
// estimation and multiple importance sampling after Veach 1997, "Robust Monte Carlo Methods for
// Light Transport Simulation". Variants: GI_RAY_PARTLY (some surfaces let rays pass), and those of
// rays/surface.glsl.
#define GI_POSITIONAL 1
#include "shared/view.h"
#include "shared/light.h"
#include "shared/material.h"
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/lights.glsl"
#include "lib/phong.glsl"
#include "lib/pbr.glsl"
#include "lib/sampling.glsl"
#include "rays/surface.glsl"
#include "path_tracing/reflection.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

// Sums over samples.
layout(rgba32f, binding = 0) uniform image2D sumShown;   // rgb as displayed; a: how many are PBR
layout(rgba32f, binding = 1) uniform image2D sumEncoded; // rgb of PBR, linear; a: squared luminance
layout(rgba32f, binding = 2) uniform image2D sumAlbedo;  // rgb; a: samples that met a surface
layout(rgba32f, binding = 3) uniform image2D sumNormal;  // xyz in the world; w: depth

layout(binding = 0) uniform sampler2D albedoTexture;
layout(binding = 1) uniform sampler2D normalTexture;
layout(binding = 2) uniform sampler2D depthTexture;
layout(binding = 3) uniform sampler2D colorTexture;

uniform mat3 viewToScene;
uniform vec3 eye;          // relative to the scene's origin
uniform int sampleIndex;   // samples in the sums already
uniform int bounces;
uniform int lightCount;
uniform int emitterCount;
uniform float drawnReach;  // surfaces this much farther than a line or point hide it
uniform int strategy;      // 0 both, 1 light sampling, 2 BSDF sampling

const int PASSES = 64; // through surfaces that let the ray pass
const float FAR = 1e30;

uint seed;

vec2 sample2D(int bounce, int purpose)
{
  return giSample2D(uint(sampleIndex), seed + uint(bounce * 4 + purpose) * 0x9e3779b9u);
}

float randomNumber(inout uint state)
{
  state = giHash(state);
  return float(state >> 8) / 16777216.0;
}

bool passes(RaySurfacePoint at, int flags, inout uint state)
{
  bool culled = (flags & (at.front ? GI_SURFACE_CULL_FRONT : GI_SURFACE_CULL_BACK)) != 0;
#ifdef GI_RAY_CLIPPED
  culled = culled || rayClipped(raySurfaces[at.surface], at.position);
#endif
  return culled || (at.color.a < 1.0 && randomNumber(state) >= at.color.a);
}

// Where the ray ends, through what lets it pass. ray.origin moves along.
RayHit traceThrough(inout Ray ray, out RaySurfacePoint at, inout uint state)
{
  RayHit hit = traceClosest(ray);
  if (hit.instance >= 0)
  {
    at = raySurfaceAt(ray, hit);
  }
#ifdef GI_RAY_PARTLY
  for (int i = 0; i < PASSES && hit.instance >= 0; ++i)
  {
    int flags = raySurfaces[at.surface].Where.z;
    if ((flags & GI_SURFACE_PARTLY) == 0 || !passes(at, flags, state))
    {
      break;
    }
    ray.tMax -= hit.t;
    ray.origin = rayLeave(at, ray.direction);
    hit = traceClosest(ray);
    if (hit.instance >= 0)
    {
      at = raySurfaceAt(ray, hit);
    }
  }
#endif
  return hit;
}

bool blocked(Ray ray, inout uint state)
{
#ifdef GI_RAY_PARTLY
  RaySurfacePoint at;
  return traceThrough(ray, at, state).instance >= 0;
#else
  return traceAny(ray);
#endif
}

// What a lamp makes a surface send to V, were there nothing between them. VTK's lamps stand for an
// irradiance of pi times their colour where Phong materials look at them, and of their colour where
// PBR ones do.
vec3 lampReflected(LightData lamp, GiReflector r, vec3 position, bool seen)
{
  if (lamp.Kind.x == GI_LIGHT_HEADLIGHT && seen)
  {
    if (r.pbr)
    {
      return lamp.Color.rgb * giReflect(r, r.V);
    }
    float facing = max(0.000001, dot(r.N, -lamp.Direction.xyz));
    return lamp.Color.rgb * (r.albedo * facing + r.specular * pow(facing, r.power));
  }
  GiIncident incident = giIncident(lamp, position);
  vec3 reaching = lamp.Color.rgb * incident.Attenuation * (r.pbr ? 1.0 : GI_PI);
  return reaching * giReflect(r, -incident.Travel);
}

float powerHeuristic(float a, float b)
{
  return a * a / max(a * a + b * b, 1e-30);
}

// Density per area of light sampling at a point seen along a direction, per solid angle.
float emitterDensity(float perArea, vec3 from, vec3 to, vec3 normal)
{
  vec3 path = to - from;
  float square = dot(path, path);
  return perArea * square * sqrt(square) / max(abs(dot(normal, path)), 1e-20);
}

int pickEmitter(float u)
{
  int low = 0;
  int high = emitterCount - 1;
  while (low < high)
  {
    int middle = (low + high) / 2;
    bool before = u < rayEmitters[middle].A.w;
    high = before ? middle : high;
    low = before ? low : middle + 1;
  }
  return low;
}

// What the lamps and one point of the emitters make a surface send to its viewer.
vec3 directLight(GiReflector r, RaySurfacePoint at, int bounce, inout uint state)
{
  vec3 sum = vec3(0.0);
  // All lamps where the eye looks, one of them elsewhere.
  bool all = bounce == 0;
  int lamps = all ? lightCount : min(lightCount, 1);
  int emitters = emitterCount > 0 && strategy != 2 ? 1 : 0;
  for (int i = 0; i < lamps + emitters; ++i)
  {
    vec2 u = sample2D(bounce, 0);
    vec3 reflected;
    Ray ray = Ray(at.position, 0.0, vec3(0.0), FAR);
    bool open = false;
    if (i < lamps)
    {
      int chosen = all ? i : min(int(randomNumber(state) * float(lightCount)), lightCount - 1);
      LightData lamp = lights[chosen];
      reflected = lampReflected(lamp, r, at.position, all) * (all ? 1.0 : float(lightCount));
      bool head = lamp.Kind.z != 0; // shines from the eye: reaches all that the eye sees
      open = head && all;
      vec3 target = head ? eye : lamp.Position.xyz;
      bool local = head || lamp.Kind.x == GI_LIGHT_POSITIONAL;
      ray.direction = local ? target - at.position : -lamp.Direction.xyz;
      ray.tMax = local ? 1.0 : FAR;
    }
    else
    {
      int index = pickEmitter(u.x);
      float before = index > 0 ? rayEmitters[index - 1].A.w : 0.0;
      RayEmitter emitter = rayEmitters[index];
      float within = clamp((u.x - before) / max(emitter.A.w - before, 1e-20), 0.0, 1.0);
      vec2 weights = giSampleTriangle(vec2(within, u.y));
      vec3 edge1 = emitter.B.xyz - emitter.A.xyz;
      vec3 edge2 = emitter.C.xyz - emitter.A.xyz;
      vec3 target = emitter.A.xyz + weights.x * edge1 + weights.y * edge2;
      RaySurface surface = raySurfaces[floatBitsToInt(emitter.B.w)];
      vec4 color;
      vec3 emission;
      rayColors(surface, floatBitsToInt(emitter.C.w), weights, color, emission);
      float density =
        emitterDensity(surface.Emission.w, at.position, target, normalize(cross(edge1, edge2)));
      ray.direction = target - at.position;
      vec3 L = normalize(ray.direction);
      float weight = strategy == 1 ? 1.0 : powerHeuristic(density, giReflectionDensity(r, L));
      reflected = density > 0.0 ? giReflect(r, L) * emission * weight / density : vec3(0.0);
      ray.tMax = 1.0 - 1e-4;
    }
    if (dot(reflected, vec3(1.0)) > 0.0)
    {
      // A direction below the surface proper meets it at once: no light leaks through facets.
      bool inside = dot(at.geometric, ray.direction) <= 0.0;
      ray.origin = rayLeave(at, at.geometric);
      sum += open || !(inside || blocked(ray, state)) ? reflected : vec3(0.0);
    }
  }
  return sum;
}

// Radiance along a ray from its first surface on.
vec3 pathRadiance(Ray ray, RaySurfacePoint at, inout uint state)
{
  vec3 radiance = vec3(0.0);
  vec3 throughput = vec3(1.0);
  vec3 from = ray.origin;
  float density = 0.0; // of the direction that led here
  // After the last reflection, one ray more finds emitters.
  int last = bounces + (emitterCount > 0 && strategy != 1 ? 1 : 0);
  for (int bounce = 0; bounce <= last; ++bounce)
  {
    RaySurface surface = raySurfaces[at.surface];
    float weight = 1.0;
    if (bounce > 0 && surface.Emission.w > 0.0)
    {
      float other = emitterDensity(surface.Emission.w, from, at.position, at.geometric);
      weight = strategy == 0 ? powerHeuristic(density, other) : (strategy == 1 ? 0.0 : 1.0);
    }
    radiance += throughput * at.emission * weight;
    if (bounce > bounces || (surface.Where.z & GI_SURFACE_MODEL) == GI_SURFACE_UNLIT)
    {
      break;
    }
    // VTK looks from the camera's place in a parallel projection too.
    vec3 V = bounce == 0 ? normalize(eye - at.position) : -ray.direction;
    GiReflector r = giReflector(surface, at.color, at.normal, V);
    radiance += throughput * directLight(r, at, bounce, state);
    if (bounce == last)
    {
      break;
    }
    vec3 L = giSampleReflection(r, randomNumber(state), sample2D(bounce, 1));
    density = giReflectionDensity(r, L);
    throughput *= density > 0.0 ? giReflect(r, L) / density : vec3(0.0);
    float survive = bounce < 3 ? 1.0 : min(0.95, max(throughput.r, max(throughput.g, throughput.b)));
    if (dot(at.geometric, L) <= 0.0 || dot(throughput, vec3(1.0)) <= 0.0 ||
      randomNumber(state) >= survive)
    {
      break;
    }
    throughput /= survive;
    from = at.position;
    ray = Ray(rayLeave(at, L), 0.0, L, FAR);
    RayHit hit = traceThrough(ray, at, state);
    if (hit.instance < 0)
    {
      break;
    }
  }
  return radiance;
}

void main()
{
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 window = pixel + ivec2(view.Viewport.xy);
  if (any(greaterThanEqual(pixel, ivec2(view.Viewport.zw))))
  {
    return;
  }
  seed = giHash(uint(window.x) + (uint(window.y) << 16));
  uint state = giHash(seed ^ giHash(uint(sampleIndex)));

  // The frame's shift is in the matrices.
  vec2 center = vec2(window) + 0.5;
  vec3 near = giViewPosition(center, 0.0);
  vec3 path = giViewPosition(center, 1.0) - near;
  vec3 direction = normalize(path);
  Ray ray = Ray(eye + viewToScene * near, 0.0, viewToScene * direction, length(path));
  bool drawn = texelFetch(albedoTexture, window, 0).a > 0.0 &&
    int(texelFetch(normalTexture, window, 0).z * 65535.0 + 0.5) == GI_MATERIAL_AS_DRAWN;
  if (drawn)
  {
    vec3 there = giViewPosition(center, texelFetch(depthTexture, window, 0).r);
    ray.tMax = length(there - near) * drawnReach;
  }

  RaySurfacePoint at;
  vec3 start = ray.origin;
  RayHit hit = traceThrough(ray, at, state);
  bool met = hit.instance >= 0;
  bool encoded = false;
  vec3 value = texelFetch(colorTexture, window, 0).rgb; // lines and points, background
  vec4 albedo = vec4(0.0);
  vec4 normal = vec4(0.0);
  if (met)
  {
    albedo = vec4(at.color.rgb, 1.0);
    normal = vec4(at.normal, dot(at.position - start, viewToScene * vec3(0.0, 0.0, -1.0)) - near.z);
    encoded = (raySurfaces[at.surface].Where.z & GI_SURFACE_MODEL) == GI_SURFACE_PBR;
    value = pathRadiance(ray, at, state);
    value = any(isnan(value)) || any(isinf(value)) ? vec3(0.0) : value;
  }
  float luminance = dot(value, vec3(0.2126, 0.7152, 0.0722));
  bool more = sampleIndex > 0;
  vec4 none = vec4(0.0);
  vec4 shown = more ? imageLoad(sumShown, window) : none;
  vec4 linear = more ? imageLoad(sumEncoded, window) : none;
  vec4 albedos = more ? imageLoad(sumAlbedo, window) : none;
  vec4 normals = more ? imageLoad(sumNormal, window) : none;
  imageStore(sumShown, window, shown + (encoded ? vec4(0.0, 0.0, 0.0, 1.0) : vec4(value, 0.0)));
  imageStore(sumEncoded, window,
    linear + vec4(encoded ? value : vec3(0.0), luminance * luminance));
  imageStore(sumAlbedo, window, albedos + albedo);
  imageStore(sumNormal, window, normals + normal);
}
