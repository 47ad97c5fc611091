#version 430 core
// The share of each light that reaches a pixel, four lights at a time. Variants: GI_CASCADES (a light
// with cascades), and those of shadow_maps/filter.glsl.
#include "shared/view.h"
#include "shared/shadow.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/noise.glsl"

layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D albedoTexture;
layout(binding = 2) uniform sampler2D normalTexture;
layout(binding = 3) uniform sampler2D facetTexture;
layout(binding = 4) uniform sampler2D atlas;

#include "shadow_maps/sheet.glsl"
#include "shadow_maps/filter.glsl"

uniform int firstLight;
uniform int lightCount;
uniform vec3 bias; // constant, slope, normal; all in texels
uniform bool receiverPlane; // whether depths are compared with the facet's plane

layout(location = 0) out vec4 visibility;

// Steeper than 88 degrees, a plane's depths at the next texel say nothing.
const float SmallestCosine = 0.03;
// What a depth buffer of 24 bits and the way back from it cost.
const float DepthError = 2.5e-7;
// Share of a cascade over which the next one takes over.
const float Overlap = 0.1;

struct Surface
{
  vec3 P;
  vec3 N;      // of shading
  vec3 facet;  // of the flat piece
  float error; // of P, in world units
};

GiReceiver receiverOf(ShadowLightData lamp, Surface surface, vec3 L, float distance, int map)
{
  vec3 F = surface.facet;
  float cosine = dot(F, L);
  if (cosine < SmallestCosine)
  {
    vec3 side = F - cosine * L;
    F = SmallestCosine * L + sqrt(1.0 - SmallestCosine * SmallestCosine) * normalize(side + 1e-5 * surface.N);
    cosine = SmallestCosine;
  }
  float sine = sqrt(1.0 - cosine * cosine);
  float texel = shadowMaps[map].Scale.x * distance;
  GiReceiver receiver;
  // Along the normal: Holbert 2011, Saying "Goodbye" to Shadow Acne (Game Developers Conference).
  receiver.P = surface.P + L * (texel * (bias.x + bias.y * sine / cosine) + surface.error) +
    F * (texel * bias.z * sine);
  receiver.texel = texel;
  // Two axes across the light, slid along it into the plane; left where they are, the plane is one
  // across the light, of the point's own depth.
  vec3 U = normalize(abs(L.z) < 0.9 ? cross(L, vec3(0.0, 0.0, 1.0)) : cross(L, vec3(0.0, 1.0, 0.0)));
  vec3 V = cross(L, U);
  receiver.U = receiverPlane ? U - L * (dot(F, U) / cosine) : U;
  receiver.V = receiverPlane ? V - L * (dot(F, V) / cosine) : V;
  return receiver;
}

float shade(ShadowLightData lamp, Surface surface, float angle)
{
  bool positional = lamp.Position.w > 0.5;
  vec3 fromLight = surface.P - lamp.Position.xyz;
  float distance = positional ? length(fromLight) : 1.0;
  vec3 L = positional ? -fromLight / distance : -lamp.Direction.xyz;
  if (dot(surface.N, L) <= 0.0)
  {
    return 0.0;
  }
  int map = lamp.Maps.x;
#ifdef GI_CUBE
  map += lamp.Maps.z == GI_SHADOW_CUBE ? giFaceOf(fromLight) : 0;
#endif
#ifdef GI_CASCADES
  float next = 0.0; // share of the next cascade
  if (lamp.Maps.z == GI_SHADOW_CASCADES)
  {
    // By the distance from the eye, which turning the camera does not change.
    float far = length(surface.P);
    int cascade = 0;
    while (cascade < lamp.Maps.y - 1 && far > lamp.Ends[cascade])
    {
      ++cascade;
    }
    map += cascade;
    float end = lamp.Ends[cascade];
    next = cascade < lamp.Maps.y - 1 ? clamp((far / end - 1.0) / Overlap + 1.0, 0.0, 1.0) : 0.0;
  }
  float open = 0.0;
  int parts = next > 0.0 ? 2 : 1;
  for (int part = 0; part < parts; ++part)
  {
    GiReceiver receiver = receiverOf(lamp, surface, L, distance, map + part);
    open += (part == 0 ? 1.0 - next : next) * giReaching(lamp, receiver, map + part, angle);
  }
  return open;
#else
  return giReaching(lamp, receiverOf(lamp, surface, L, distance, map), map, angle);
#endif
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  visibility = vec4(1.0);
  if (texelFetch(albedoTexture, pixel, 0).a == 0.0)
  {
    return;
  }
  float depth = texelFetch(depthTexture, pixel, 0).r;
  Surface surface;
  surface.P = giViewPosition(gl_FragCoord.xy, depth);
  surface.N = giDecodeOctahedral(texelFetch(normalTexture, pixel, 0).xy);
  surface.facet = giDecodeOctahedral(giUnpack12(texelFetch(facetTexture, pixel, 0).rgb));
  surface.error =
    length(giViewPosition(gl_FragCoord.xy, max(depth - DepthError, 0.0)) - surface.P);
  float angle = 6.28318531 * giInterleavedNoise(gl_FragCoord.xy, view.Frame.x);
  for (int i = 0; i < lightCount; ++i)
  {
    visibility[i] = shade(shadowLights[firstLight + i], surface, angle);
  }
}
