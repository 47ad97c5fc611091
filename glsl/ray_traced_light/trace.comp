#version 430 core
// Irradiance at each pixel's surface from what other surfaces emit and reflect and from the environment, divided by pi:
// final gathering with probes (Jensen 1996, Global Illumination using Photon Maps; Majercik et al. 2021, Scaling Probe-Based
// Real-Time Dynamic Global Illumination for Production). A ray finds the surface in a random direction, others go to a
// point of the emitters and of the sky; what both kinds can find is weighted (Veach 1997, Robust Monte Carlo Methods for
// Light Transport Simulation). Variants: GI_LIVE_FIELD (live probes know the light where a ray ends), GI_SKY_APART (another
// technique lights surfaces by what arrives straight from the environment), and those of rays/hit_light.glsl and
// rays/passage.glsl.
#define GI_POSITIONAL 1
#include "shared/view.h"
#include "shared/light.h"
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/lights.glsl"
#include "lib/sampling.glsl"
#include "lib/light_points.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"
#include "rays/toward_light.glsl"
#include "rays/emitters.glsl"
#ifdef GI_RAY_SKY
#include "rays/sky.glsl"
#endif
#include "rays/hit_light.glsl"
#ifdef GI_LIVE_FIELD
#include "ddgi/field.glsl"
#include "ddgi/seen_field.glsl"
#define REFLECTED fieldReflected
#else
#define REFLECTED(at, way, state) hitReflected(at, state)
#endif

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f, binding = 0) uniform writeonly image2D samples; // one for each block of pixels; a: 1 if there is one

layout(binding = 0) uniform sampler2D albedoTexture;
layout(binding = 1) uniform sampler2D normalTexture;
layout(binding = 2) uniform sampler2D depthTexture;

uniform int rays;
uniform ivec2 corner; // texel of the first block's sample
#include "ray_traced_light/turn.glsl"
#include "rays/pixel_surface.glsl"

const float PI = 3.14159265;

// Light from one point of the emitters.
vec3 fromEmitter(RaySurfacePoint at, vec2 u, inout uint state)
{
  EmitterChoice choice = emitterChoice(state);
  for (int i = 0; i < EMITTER_CANDIDATES; ++i)
  {
    EmitterPoint point = emitterPoint(emitterCandidate(u, i), at.position, at.normal, state);
    float density = dot(at.normal, normalize(point.path)) / PI; // of rays in random directions
    float share = density > 0.0 && point.density > 0.0
      ? density * giPowerHeuristic(point.misDensity, density) / point.density
      : 0.0;
    emitterConsider(choice, point.path, share * point.emission);
  }
  bool arrives = choice.sum > 0.0 && rayReaches(vec4(choice.path, 1.0 - 1e-4), at, state);
  return arrives ? emitterArriving(choice) : vec3(0.0);
}

#if defined(GI_RAY_SKY) && !defined(GI_SKY_APART)
// Light from one direction of the sky.
vec3 fromSky(RaySurfacePoint at, vec2 u, inout uint state)
{
  float density;
  vec3 L = raySkySample(u, density);
  float facing = dot(at.normal, L);
  bool arrives = facing > 0.0 && density > 0.0 && rayReaches(vec4(L, RAY_FAR), at, state);
  return arrives ? raySkyRadiance(L) * (facing / PI * giPowerHeuristic(density, facing / PI) / density) : vec3(0.0);
}
#endif

// Light from the surface, or the sky, in a direction that was chosen with a density of cosine / pi.
vec3 fromDirection(RaySurfacePoint at, vec3 L, inout uint state)
{
  float density = dot(at.normal, L) / PI;
  bool closed;
  vec3 origin = rayArrive(at, L, closed);
  if (closed || density <= 0.0)
  {
    return vec3(0.0);
  }
  Ray ray = Ray(origin, 0.0, L, RAY_FAR);
  RaySurfacePoint found;
  float first;
  RayHit hit = traceThrough(ray, found, first, state);
  if (hit.instance < 0)
  {
#if defined(GI_RAY_SKY) && !defined(GI_SKY_APART)
    return raySkyRadiance(L) * giPowerHeuristic(density, raySkyDensity(L));
#else
    return vec3(0.0);
#endif
  }
  float sampled = emitterMisDensity(raySurfaces[found.surface], at.position, found.position, found.geometric);
  return found.emission * giPowerHeuristic(density, sampled) + REFLECTED(found, distance(at.position, found.position), state);
}

// Black instead of a colour that is no number.
vec3 sound(vec3 light)
{
  return any(isnan(light)) || any(isinf(light)) ? vec3(0.0) : light;
}

void main()
{
  ivec2 block = ivec2(gl_GlobalInvocationID.xy);
  ivec2 pixel = block * stride + turnPlace(block.y);
  ivec2 window = pixel + ivec2(view.Viewport.xy);
  if (any(greaterThanEqual(block * stride, ivec2(view.Viewport.zw))))
  {
    return;
  }
  if (any(greaterThanEqual(pixel, ivec2(view.Viewport.zw))) || texelFetch(albedoTexture, window, 0).a == 0.0)
  {
    imageStore(samples, corner + block, vec4(0.0));
    return;
  }
  RaySurfacePoint at = rayPixelSurface(window);
  uint state = giHash(giHash(uint(window.x) + (uint(window.y) << 16)) ^ giHash(uint(view.Frame.x)));
  ivec2 offset = pixel - block * stride;
  uint place = 4u * uint(offset.y * stride.x + offset.x); // pixels in the same place of their blocks share sequences
  mat3 basis = giBasis(at.normal);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < rays; ++i)
  {
    uint number = uint(turnNumber() * rays + i);
    sum += sound(fromDirection(at, basis * giSampleCosine(giTileSample2D(number, block, place)), state));
    if (emitterCount > 0)
    {
      sum += fromEmitter(at, giTileSample2D(number, block, place + 1u), state);
    }
#if defined(GI_RAY_SKY) && !defined(GI_SKY_APART)
    sum += fromSky(at, giTileSample2D(number, block, place + 2u), state);
#endif
  }
  sum /= float(rays);
  imageStore(samples, corner + block, vec4(sound(sum), 1.0));
}
