#version 430 core
// One path through every pixel, added to sums. Kajiya 1986, "The Rendering Equation"; next-event
// estimation and multiple importance sampling after Veach 1997, "Robust Monte Carlo Methods for
// Light Transport Simulation". Variants: GI_RAY_SKY (the surroundings shine), GI_RAY_EDGES
// (some surfaces show the edges of their cells), and those of rays/passage.glsl.
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
#include "rays/passage.glsl"
#ifdef GI_RAY_SKY
#include "rays/sky.glsl"
#endif
#include "path_tracing/reflection.glsl"
#ifdef GI_RAY_EDGES
#include "path_tracing/edges.glsl"
#endif

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

const float DEPTH_ERROR = 2.5e-7; // of a depth buffer of 24 bits

uint seed;

vec2 sample2D(int bounce, int purpose)
{
  return giSample2D(uint(sampleIndex), seed + uint(bounce * 4 + purpose) * 0x9e3779b9u);
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

// Light on its way to a surface: what of it the surface sends to its viewer, and the ray that must
// be free for that.
struct Arrival
{
  vec3 reflected;
  vec3 direction;
  float tMax;
  bool open; // nothing can be in the way
};

Arrival fromLamp(LightData lamp, GiReflector r, RaySurfacePoint at, bool seen)
{
  bool head = lamp.Kind.z != 0; // shines from the eye: reaches all that the eye sees
  bool local = head || lamp.Kind.x == GI_LIGHT_POSITIONAL;
  vec3 target = head ? eye : lamp.Position.xyz;
  return Arrival(lampReflected(lamp, r, at.position, seen),
    local ? target - at.position : -lamp.Direction.xyz, local ? 1.0 : RAY_FAR, head && seen);
}

Arrival fromEmitter(vec2 u, GiReflector r, RaySurfacePoint at)
{
  int index = pickEmitter(u.x);
  float before = index > 0 ? rayEmitters[index - 1].A.w : 0.0;
  RayEmitter emitter = rayEmitters[index];
  float within = clamp((u.x - before) / max(emitter.A.w - before, 1e-20), 0.0, 1.0);
  vec2 weights = giSampleTriangle(vec2(within, u.y));
  vec3 edge1 = emitter.B.xyz - emitter.A.xyz;
  vec3 edge2 = emitter.C.xyz - emitter.A.xyz;
  vec3 across = cross(edge1, edge2);
  vec3 target = emitter.A.xyz + weights.x * edge1 + weights.y * edge2;
  vec3 path = target - at.position;
  RaySurface surface = raySurfaces[floatBitsToInt(emitter.B.w)];
  float occlusion;
  vec3 emission = rayMaterial(surface, floatBitsToInt(emitter.C.w), weights,
    dot(across, path) < 0.0, occlusion).Emission.rgb;
  float density = emitterDensity(surface.Emission.w, at.position, target, normalize(across));
  vec3 L = normalize(path);
  float weight = strategy == 1 ? 1.0 : powerHeuristic(density, giReflectionDensity(r, L));
  return Arrival(density > 0.0 ? giReflect(r, L) * emission * weight / density : vec3(0.0), path,
    1.0 - 1e-4, false);
}

#ifdef GI_RAY_SKY
Arrival fromSky(vec2 u, GiReflector r)
{
  float density;
  vec3 L = raySkySample(u, density);
  float weight = strategy == 1 ? 1.0 : powerHeuristic(density, giReflectionDensity(r, L));
  return Arrival(density > 0.0 ? giReflect(r, L) * raySkyRadiance(L) * weight / density : vec3(0.0),
    L, RAY_FAR, false);
}
#endif

// What the lamps, one point of the emitters and one direction of the sky make a surface send to its
// viewer.
vec3 directLight(GiReflector r, RaySurfacePoint at, int bounce, inout uint state)
{
  vec3 sum = vec3(0.0);
  // All lamps where the eye looks, one of them elsewhere.
  bool all = bounce == 0;
  int lamps = all ? lightCount : min(lightCount, 1);
  int emitters = emitterCount > 0 && strategy != 2 ? 1 : 0;
#ifdef GI_RAY_SKY
  int skies = strategy != 2 ? 1 : 0;
#else
  const int skies = 0;
#endif
  for (int i = 0; i < lamps + emitters + skies; ++i)
  {
    Arrival arrival;
    if (i < lamps)
    {
      int chosen = all ? i : min(int(giRandom(state) * float(lightCount)), lightCount - 1);
      arrival = fromLamp(lights[chosen], r, at, all);
      arrival.reflected *= all ? 1.0 : float(lightCount);
    }
    else if (i < lamps + emitters)
    {
      arrival = fromEmitter(sample2D(bounce, 0), r, at);
    }
#ifdef GI_RAY_SKY
    else
    {
      arrival = fromSky(sample2D(bounce, 2), r);
    }
#endif
    if (dot(arrival.reflected, vec3(1.0)) > 0.0)
    {
      bool closed;
      vec3 origin = rayArrive(at, normalize(arrival.direction), closed);
      // To the point that the light comes from, from where it arrives.
      vec3 path = arrival.tMax <= 1.0 ? arrival.direction + (at.position - origin) : arrival.direction;
      Ray ray = Ray(origin, 0.0, path, arrival.tMax);
      sum += arrival.open || !(closed || blocked(ray, state)) ? arrival.reflected : vec3(0.0);
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
  // After the last reflection, one ray more finds emitters and the sky.
#ifdef GI_RAY_SKY
  int last = bounces + (strategy != 1 ? 1 : 0);
#else
  int last = bounces + (emitterCount > 0 && strategy != 1 ? 1 : 0);
#endif
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
    GiReflector r = giReflector(at, surface.Where.z & GI_SURFACE_MODEL, V);
    radiance += throughput * directLight(r, at, bounce, state);
    if (bounce == last)
    {
      break;
    }
    vec3 L = giSampleReflection(r, giRandom(state), sample2D(bounce, 1));
    density = giReflectionDensity(r, L);
    throughput *= density > 0.0 ? giReflect(r, L) / density : vec3(0.0);
    float survive = bounce < 3 ? 1.0 : min(0.95, max(throughput.r, max(throughput.g, throughput.b)));
    bool closed;
    vec3 origin = rayArrive(at, L, closed);
    if (closed || dot(throughput, vec3(1.0)) <= 0.0 || giRandom(state) >= survive)
    {
      break;
    }
    throughput /= survive;
    from = at.position;
    ray = Ray(origin, 0.0, L, RAY_FAR);
    float first;
    RayHit hit = traceThrough(ray, at, first, state);
    if (hit.instance < 0)
    {
#ifdef GI_RAY_SKY
      float other = raySkyDensity(L);
      float share = strategy == 0 ? powerHeuristic(density, other) : (strategy == 1 ? 0.0 : 1.0);
      radiance += throughput * raySkyRadiance(L) * share;
#endif
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
  bool captured = texelFetch(albedoTexture, window, 0).a > 0.0;
  int material = int(texelFetch(normalTexture, window, 0).z * 65535.0 + 0.5);
  float depth = texelFetch(depthTexture, window, 0).r;
  if (captured && (material == GI_MATERIAL_AS_DRAWN || materials[material].Model.y != 0))
  {
    ray.tMax = length(giViewPosition(center, depth) - near) * drawnReach;
  }

  RaySurfacePoint at;
  vec3 start = ray.origin;
  float first;
  RayHit hit = traceThrough(ray, at, first, state);
  // What the rasterizer drew well before the first surface is of a kind that rays do not meet.
  float farthest = length(giViewPosition(center, min(depth + DEPTH_ERROR, 1.0)) - near);
  bool hidden = captured && drawnReach < 1.0 && first > farthest * (2.0 - drawnReach);
  bool met = hit.instance >= 0 && !hidden;
  bool encoded = false;
  vec3 value = texelFetch(colorTexture, window, 0).rgb; // lines and points, background
  vec4 albedo = vec4(0.0);
  vec4 normal = vec4(0.0);
  if (met)
  {
#ifdef GI_RAY_EDGES
    at = withEdges(at, hit, transpose(viewToScene), eye, center);
#endif
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
