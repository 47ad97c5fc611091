#version 430 core
// Traces rays on the screen from each reflecting pixel, in directions sampled from its lobe.
// Variants: GI_EXTENDED (textures, PBR), GI_DEBUG (store how rays ended), GI_FALLBACK_RAYS (rays
// through the scene find what the screen does not show; with the variants of rays/passage.glsl).
#define GI_POSITIONAL 1
#include "shared/view.h"
#include "shared/material.h"
#include "shared/reflection.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/pbr.glsl"
#include "lib/sampling.glsl"
#include "screen_space_reflections/lobe.glsl"
#include "screen_space_reflections/march.glsl"
#ifdef GI_FALLBACK_RAYS
#include "shared/light.h"
#include "lib/lights.glsl"
#include "lib/phong.glsl"
#include "lib/light_points.glsl"
#include "rays/trace.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"
#include "rays/toward_light.glsl"
#include "path_tracing/reflection.glsl"
#include "screen_space_reflections/rays.glsl"
#endif

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f, binding = 0) uniform writeonly image2DArray rays;  // xyz: end, w: density, -1 for none
layout(rgba16f, binding = 1) uniform writeonly image2DArray light; // rgb: radiance times a; a: confidence
#ifdef GI_DEBUG
layout(rgba32f, binding = 2) uniform writeonly image2D ends; // xy: pixel, z: reason, w: confidence
#endif

layout(binding = 6) uniform sampler2D litTexture;

uniform int samples;

void skip(ivec2 window, int reason)
{
  for (int i = 0; i < samples; ++i)
  {
    imageStore(rays, ivec3(window, i), vec4(0.0, 0.0, 0.0, -1.0));
  }
#ifdef GI_DEBUG
  imageStore(ends, window, vec4(-1.0, -1.0, float(reason), 0.0));
#endif
}

vec3 litAt(vec2 place)
{
  ivec2 pixel = clamp(ivec2(place), ivec2(0), ivec2(view.Viewport.zw) - 1);
  return texelFetch(litTexture, pixel + ivec2(view.Viewport.xy), 0).rgb;
}

void main()
{
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 low = ivec2(view.Viewport.xy);
  ivec2 window = pixel + low;
  if (any(greaterThanEqual(pixel, ivec2(view.Viewport.zw))))
  {
    return;
  }
  if (texelFetch(albedoTexture, window, 0).a == 0.0)
  {
    skip(window, GI_REFLECTION_NONE);
    return;
  }
  float depth = texelFetch(depthTexture, window, 0).r;
  vec3 P = giViewPosition(vec2(window) + 0.5, depth);
  Lobe lobe = lobeAt(window, P);
  if (!isTraced(lobe))
  {
    skip(window, !lobe.reflects || dot(lobe.color, vec3(1.0)) <= 0.0 ? GI_REFLECTION_NONE
        : isWeak(lobe) ? GI_REFLECTION_WEAK : GI_REFLECTION_ROUGH);
    return;
  }
  uint state = giHash(giHash(uint(window.x) + (uint(window.y) << 16)) ^ giHash(uint(view.Frame.x)));
  for (int i = 0; i < samples; ++i)
  {
    vec3 L = sampleLobe(lobe, giTileSample2D(uint(view.Frame.x * samples + i), pixel, 0u));
    MarchResult result = MarchResult(GI_REFLECTION_HORIZON, P, vec2(-1.0), 1.0);
    vec3 radiance = vec3(0.0);
    if (dot(lobe.N, L) > 0.0)
    {
      result = march(pixel, depth, P, L, lobe.V);
      radiance = result.end == GI_REFLECTION_HIT
        ? result.confidence * litAt(result.window) : vec3(0.0);
#ifdef GI_FALLBACK_RAYS
      vec3 rayLight;
      if (result.confidence < 1.0 && rayRadiance(P, lobe.N, L, state, rayLight))
      {
        radiance += (1.0 - result.confidence) * rayLight;
        result.confidence = 1.0;
        result.end = result.end == GI_REFLECTION_HIT ? GI_REFLECTION_HIT : GI_REFLECTION_RAY;
      }
#endif
    }
    float density = result.end == GI_REFLECTION_HORIZON ? -1.0
      : isMirror(lobe) ? 0.0 : lobeDensity(lobe, L);
    imageStore(rays, ivec3(window, i), vec4(result.position, density));
    imageStore(light, ivec3(window, i), vec4(radiance, result.confidence));
#ifdef GI_DEBUG
    if (i == 0)
    {
      imageStore(ends, window, vec4(result.window, float(result.end), result.confidence));
    }
#endif
  }
}
