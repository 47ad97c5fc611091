#version 430 core
// Reflected light of a pixel's lobe, from its own rays and its neighbours', each weighted by this
// lobe's value in its direction (Stachowiak 2015, "Stochastic Screen-Space Reflections"). Writes the
// mean radiance over the lobe times the confidence, and the confidence. Variants: GI_EXTENDED (textures, PBR).
#include "shared/view.h"
#include "shared/material.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/noise.glsl"
#include "lib/pbr.glsl"
#include "lib/sampling.glsl"
#include "screen_space_reflections/lobe.glsl"

layout(binding = 5) uniform sampler2DArray rayTexture;
layout(binding = 6) uniform sampler2DArray foundTexture;

uniform int samples;
uniform int neighbours; // 0 uses only the pixel's own rays

layout(location = 0) out vec4 reflection;
layout(location = 1) out float reach; // of the filter, in scene units; -1 where nothing is traced

const float WIDEST = 24.0; // pixels
const float REACH = 0.25;  // as a share of the footprint; more blurs reflected edges

// Size of a pixel at a distance from the eye, in a parallel projection at any.
float pixelAt(float distance)
{
  return 2.0 * distance / (view.Viewport.w * view.ViewToClip[1].y);
}

// Radius in pixels over which the lobe blurs a reflection at this distance: the lobe's angle, which is
// twice that of the microfacets, as seen from the eye, for which the reflected object lies behind the mirror.
float footprint(Lobe lobe, vec3 P, float distanceToHit)
{
  float distance = view.Scene.y > 0.5 ? 1.0 : -P.z * (1.0 + distanceToHit / length(P));
  return clamp(2.0 * lobe.width * distanceToHit / pixelAt(distance), 0.0, WIDEST);
}

void addRays(Lobe lobe, vec3 P, ivec2 window, inout vec4 sum, inout float weights)
{
  for (int i = 0; i < samples; ++i)
  {
    vec4 ray = texelFetch(rayTexture, ivec3(window, i), 0);
    if (ray.w > 0.0)
    {
      float weight = lobeValue(lobe, normalize(ray.xyz - P)) / ray.w;
      sum += weight * texelFetch(foundTexture, ivec3(window, i), 0);
      weights += weight;
    }
  }
}

// Distances to what the rays of a pixel and its eight neighbours hit: the nearest, and the harmonic mean. If none hits: where the
// pixel's own ray ended. Must not depend on the pixel's own ray alone: the choice of neighbours would depend on what that ray
// found, and pixels whose ray missed would lose light.
vec2 hitDistances(vec3 P, ivec2 window, ivec2 low, ivec2 high)
{
  float nearest = 0.0; // inverse
  float sum = 0.0;
  float hits = 0.0;
  for (int i = 0; i < 9; ++i)
  {
    ivec2 at = clamp(window + ivec2(i % 3, i / 3) - 1, low, high);
    vec4 ray = texelFetch(rayTexture, ivec3(at, 0), 0);
    if (ray.w > 0.0 && texelFetch(foundTexture, ivec3(at, 0), 0).a > 0.0)
    {
      float near = 1.0 / max(length(ray.xyz - P), 1e-20);
      nearest = max(nearest, near);
      sum += near;
      hits += 1.0;
    }
  }
  if (hits > 0.0)
  {
    return vec2(1.0 / nearest, hits / sum);
  }
  vec4 own = texelFetch(rayTexture, ivec3(window, 0), 0);
  return vec2(own.w > 0.0 ? length(own.xyz - P) : 0.0);
}

void main()
{
  ivec2 window = ivec2(gl_FragCoord.xy);
  vec3 P = giViewPosition(gl_FragCoord.xy, texelFetch(depthTexture, window, 0).r);
  reflection = vec4(0.0);
  reach = -1.0;
  Lobe lobe = lobeAt(window, P);
  if (texelFetch(albedoTexture, window, 0).a == 0.0 || !isTraced(lobe))
  {
    return;
  }
  reach = 0.0;
  if (isMirror(lobe))
  {
    reflection = texelFetch(foundTexture, ivec3(window, 0), 0);
    return;
  }
  float weights = 0.0;
  addRays(lobe, P, window, reflection, weights);
  ivec2 low = ivec2(view.Viewport.xy);
  ivec2 high = low + ivec2(view.Viewport.zw) - 1;
  vec2 distances = hitDistances(P, window, low, high);
  float radius = footprint(lobe, P, distances.x);
  reach = REACH * footprint(lobe, P, distances.y) * pixelAt(view.Scene.y > 0.5 ? 1.0 : -P.z);
  float turn = 6.28318531 * giInterleavedNoise(gl_FragCoord.xy, view.Frame.x);
  for (int i = 0; i < neighbours && radius >= 1.0; ++i)
  {
    ivec2 other = window + ivec2(round(radius * giVogelDisc(i, neighbours, turn)));
    vec4 normal = texelFetch(normalTexture, clamp(other, low, high), 0);
    bool similar = dot(giDecodeOctahedral(normal.xy), lobe.N) > 0.9;
    if (similar && other != window && all(equal(other, clamp(other, low, high))))
    {
      addRays(lobe, P, other, reflection, weights);
    }
  }
  reflection /= max(weights, 1e-20);
}
