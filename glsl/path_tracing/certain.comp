#version 430 core
// Adds what the first surfaces show without chance, which needs no filter: what they emit, and light from lights without a shape
// whose rays pass no translucent surface. Variants: those of path_tracing/paths.glsl and path_tracing/first_surface.glsl.
#define GI_POSITIONAL 1
#include "shared/view.h"
#include "shared/light.h"
#include "shared/material.h"
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/lights.glsl"
#include "lib/luminance.glsl"
#include "lib/phong.glsl"
#include "lib/pbr.glsl"
#include "lib/sampling.glsl"
#include "lib/light_points.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"
#include "rays/toward_light.glsl"
#include "path_tracing/paths.glsl"
#include "path_tracing/first_surface.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f, binding = 0) uniform image2D sumCertain; // rgb at the points of the paths; a: number of samples
layout(rgba32f, binding = 1) uniform image2D sumFine;    // rgb at more points of the pixel; a: number of those on lit surfaces

uniform int sampleIndex;    // of the path
uniform int certainSamples; // number of samples in the sums
uniform vec2 shift;         // of the path from the pixel's centre, in pixels
uniform vec2 jitter;        // of the frame, in pixels

const int FINE_SAMPLES = 4; // more points per path: its own would leave edges of shadows and textures rough
const uint FINE_SEED = 0x3c6ef372u;

// The state of random numbers changes where there is a choice.
vec3 certainRadiance(RaySurfacePoint at, int model, bool sure, uint state)
{
  vec3 radiance = at.emission;
  GiReflector r = giReflector(at, model, normalize(eye - at.position));
  for (int i = 0; i < lightCount && sure; ++i)
  {
    if (!giHasShape(lights[i]))
    {
      Arrival arrival = fromLight(lights[i], r, at, true, vec2(0.0));
      uint choice = state;
      bool reaches = dot(arrival.reflected, vec3(1.0)) > 0.0 && (arrival.open || rayReaches(arrival.toward, at, choice));
      radiance += reaches && choice == state ? arrival.reflected : vec3(0.0);
    }
  }
  return radiance;
}

// a: whether the point shows a lit surface.
vec4 certainAt(ivec2 window, vec2 shift, uint state)
{
  Ray ray;
  RaySurfacePoint at;
  uint choice = state;
  if (!firstSurface(window, shift, ray, at, choice))
  {
    return vec4(0.0);
  }
  RaySurface surface = raySurfaces[at.surface];
  int model = surface.Where.z & GI_SURFACE_MODEL;
  if (model == GI_SURFACE_UNLIT)
  {
    return vec4(0.0);
  }
  vec3 value = certainRadiance(at, model, choice == state, choice);
  value = any(isnan(value)) || any(isinf(value)) ? vec3(0.0) : value;
  return vec4(rayColoredByData(surface) ? mix(at.color.rgb, value, giDataLit(model == GI_SURFACE_PBR)) : value, 1.0);
}

void main()
{
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 window = pixel + ivec2(view.Viewport.xy);
  if (any(greaterThanEqual(pixel, ivec2(view.Viewport.zw))))
  {
    return;
  }
  bool more = certainSamples > 0;
  uint state = startPath(window, sampleIndex);
  vec4 certain = vec4(certainAt(window, shift, state).rgb, 1.0);
  imageStore(sumCertain, window, certain + (more ? imageLoad(sumCertain, window) : vec4(0.0)));
  vec4 fine = more ? imageLoad(sumFine, window) : vec4(0.0);
  for (int i = 0; i < FINE_SAMPLES; ++i)
  {
    uint index = uint(certainSamples * FINE_SAMPLES + i);
    vec2 place = giSample2D(index, seed + FINE_SEED) - 0.5;
    fine += certainAt(window, jitter + place, giHash(state + FINE_SEED + uint(i)));
  }
  imageStore(sumFine, window, fine);
}
