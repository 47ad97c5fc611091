#version 430 core
// The share of each light that reaches a pixel, four lights at a time: percentage-closer filtering
// (Reeves, Salesin and Cook 1987) of GI_SAMPLES taps on a disc that lies in the receiver's plane,
// so that the filter's width needs no bias of its own.
#include "shared/view.h"
#include "shared/shadow.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/noise.glsl"

layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D albedoTexture;
layout(binding = 2) uniform sampler2D normalTexture;
layout(binding = 3) uniform sampler2DArrayShadow maps;

uniform int firstLight;
uniform int lightCount;
uniform vec2 bias; // constant, slope; both in texels

layout(location = 0) out vec4 visibility;

// Beyond 87 degrees off its normal a surface takes next to no light: bound the slope there.
const float SmallestCosine = 0.05;

// The map of six that a direction from the light falls into, in the order +x -x +y -y +z -z.
int faceOf(vec3 fromLight)
{
  vec3 d = mat3(view.ViewToWorld) * fromLight;
  vec3 a = abs(d);
  if (a.x >= a.y && a.x >= a.z)
  {
    return d.x > 0.0 ? 0 : 1;
  }
  if (a.y >= a.z)
  {
    return d.y > 0.0 ? 2 : 3;
  }
  return d.z > 0.0 ? 4 : 5;
}

float shade(ShadowLightData lamp, vec3 P, vec3 N, float angle)
{
  bool positional = lamp.Position.w > 0.5;
  vec3 fromLight = P - lamp.Position.xyz;
  float distance = positional ? length(fromLight) : 1.0;
  vec3 L = positional ? -fromLight / distance : -lamp.Direction.xyz;
  float cosine = dot(N, L);
  if (cosine <= 0.0)
  {
    return 0.0;
  }
  cosine = max(cosine, SmallestCosine);
  float texel = lamp.Texel.x * distance;
  // A hardware-filtered tap reads texels up to the diagonal of one away.
  float slope = sqrt(1.0 - cosine * cosine) / cosine * 1.5;
  vec3 receiver = P + L * (texel * (bias.x + bias.y * slope));

  int map = lamp.Maps.x + (lamp.Maps.y == 6 ? faceOf(fromLight) : 0);
  mat4 toMap = shadowMaps[map].ViewToMap;
  vec4 center = toMap * vec4(receiver, 1.0);

  // Two axes of the disc, across the light, then slid along it into the receiver's plane.
  vec3 U = normalize(abs(L.z) < 0.9 ? cross(L, vec3(0.0, 0.0, 1.0)) : cross(L, vec3(0.0, 1.0, 0.0)));
  vec3 V = cross(L, U);
  float radius = lamp.Texel.y * texel;
  vec4 stepU = toMap * vec4(radius * (U - L * (dot(N, U) / cosine)), 0.0);
  vec4 stepV = toMap * vec4(radius * (V - L * (dot(N, V) / cosine)), 0.0);

  float sum = 0.0;
  for (int i = 0; i < GI_SAMPLES; ++i)
  {
    vec2 offset = giVogelDisc(i, GI_SAMPLES, angle);
    vec4 tap = center + offset.x * stepU + offset.y * stepV;
    sum += texture(maps, vec4(tap.xy / tap.w, float(map), tap.z / tap.w));
  }
  return sum / float(GI_SAMPLES);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  visibility = vec4(1.0);
  if (texelFetch(albedoTexture, pixel, 0).a == 0.0)
  {
    return;
  }
  vec3 P = giViewPosition(gl_FragCoord.xy, texelFetch(depthTexture, pixel, 0).r);
  vec3 N = giDecodeOctahedral(texelFetch(normalTexture, pixel, 0).xy);
  float angle = 6.28318531 * giInterleavedNoise(gl_FragCoord.xy, view.Frame.x);
  for (int i = 0; i < lightCount; ++i)
  {
    visibility[i] = shade(shadowLights[firstLight + i], P, N, angle);
  }
}
