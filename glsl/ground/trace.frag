#version 430 core
// As ground/catch.frag, with a ray to each light and one to the environment, for pictures that average over many frames.
// Also sums the picture's alpha over them. Variants: those of rays/passage.glsl, GI_FIRST (the first frame).
#define GI_POSITIONAL 1
#include "shared/view.h"
#include "shared/light.h"
#include "shared/material.h"
#include "rays/trace.glsl"
#include "lib/lights.glsl"
#include "lib/luminance.glsl"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/sampling.glsl"
#include "lib/light_points.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"
#include "rays/toward_light.glsl"
#ifdef GI_RAY_SKY
#include "rays/sky.glsl"
#endif
#include "ground/plane.glsl"
#include "ground/catch.glsl"

layout(binding = 0, rgba32f) uniform image2D alphas;
layout(binding = 2) uniform sampler2D before; // the picture

uniform mat3 viewToScene;
uniform vec3 eye; // relative to the scene's origin
uniform int lightCount;

layout(location = 0) out vec4 color;

const float PI = 3.14159265358979;

#ifdef GI_RAY_SKY
// Draws a direction in proportion to the environment's light on the ground: one of several candidates, which are drawn
// by its radiance or by their cosine (Talbot et al. 2005, Importance Resampling for Global Illumination). Returns the
// irradiance.
vec3 skyDirection(vec3 N, inout uint state, out vec3 direction)
{
  const int candidates = 8;
  vec3 irradiance = vec3(0.0);
  float sum = 0.0;
  direction = N;
  for (int i = 0; i < candidates; ++i)
  {
    vec2 u = vec2(giRandom(state), giRandom(state));
    float density;
    vec3 L = raySkySample(u, density);
    L = i % 2 == 0 ? L : giBasis(N) * giSampleCosine(u);
    float cosine = max(dot(N, L), 0.0);
    density = 0.5 * (raySkyDensity(L) + cosine / PI);
    vec3 light = cosine > 0.0 ? raySkyRadiance(L) * cosine / density : vec3(0.0);
    irradiance += light / float(candidates);
    sum += giLuminance(light);
    direction = giRandom(state) * sum < giLuminance(light) ? L : direction;
  }
  return irradiance;
}
#endif

vec4 caught(ivec2 pixel, vec4 background)
{
  GiGround ground = giGroundAt(gl_FragCoord.xy);
  uint state = giHash(giHash(uint(pixel.x) + (uint(pixel.y) << 16)) ^ giHash(uint(view.Frame.z)));
  RaySurfacePoint at;
  at.position = eye + viewToScene * ground.P;
  at.normal = at.geometric = viewToScene * plane.xyz;
  at.bulge = vec3(0.0);
  at.bend = 0.0;
  at.error = 1e-5 * length(ground.P);
  vec3 whole = vec3(0.0);
  vec3 arriving = vec3(0.0);
  for (int i = 0; i < lightCount; ++i)
  {
    RayArrival arrival = rayArrival(lights[i], at.position, eye, state);
    vec3 light = PI * lights[i].Color.rgb * arrival.share * max(dot(at.normal, arrival.L), 0.0);
    bool open = dot(light, vec3(1.0)) > 0.0 && (lights[i].Kind.z != 0 || rayReaches(arrival.toward, at, state));
    whole += light;
    arriving += open ? light : vec3(0.0);
  }
#ifdef GI_RAY_SKY
  vec3 direction;
  vec3 light = skyDirection(at.normal, state, direction);
  whole += light;
  arriving += rayReaches(vec4(direction, RAY_FAR), at, state) ? light : vec3(0.0);
#endif
  vec3 kept = giKept(ground, arriving, whole);
  return vec4(background.rgb * kept, mix(background.a, 1.0, giShadowAlpha(kept)));
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  color = texelFetch(before, pixel, 0);
  if (giCatches(pixel))
  {
    color = caught(pixel, color);
  }
#ifdef GI_FIRST
  imageStore(alphas, pixel, vec4(color.a, 0.0, 0.0, 1.0));
#else
  imageStore(alphas, pixel, imageLoad(alphas, pixel) + vec4(color.a, 0.0, 0.0, 1.0));
#endif
}
