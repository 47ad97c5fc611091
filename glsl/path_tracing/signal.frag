#version 430 core
// What denoising filters of a path-traced picture: resource::PathLight and PathSurface. Variants: those of path_tracing/means.glsl.
#define GI_FILTERED 1
#include "shared/view.h"
#include "lib/luminance.glsl"
#include "lib/octahedral.glsl"
#include "path_tracing/means.glsl"
layout(binding = 2) uniform sampler2D sumNormal;

uniform mat3 viewToScene;

const float LEAST = 4.0;         // samples from which the error is known
const float LEAST_ERROR = 1e-3;  // 0 would mean that it is unknown
const float MOST_ERROR = 0.99;
const float STRATIFIED = 0.85;   // points are spread more evenly than the independent ones that the estimate assumes
const float BRIGHTEST = 6e4;     // what half floats hold; brighter light is not filtered

layout(location = 0) out vec4 light;
layout(location = 1) out vec4 surface;

float errorOf(ivec2 pixel, GiLit lit)
{
  vec4 encoded = texelFetch(sumEncoded, pixel, 0);
  float mean = giLuminance(texelFetch(sumShown, pixel, 0).rgb + encoded.rgb) / samples;
  float variance = max(encoded.a / samples - mean * mean, 0.0) / (samples - 1.0);
  return clamp(STRATIFIED * sqrt(variance) / max(giLuminance(giMeanReflected(pixel, lit)), 1e-20), LEAST_ERROR, MOST_ERROR);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  GiLit lit = giLit(pixel);
  float count = floor(lit.shownCount + lit.encodedCount + 0.5);
  light.rgb = giMeanLight(pixel, lit);
  light.a = count + (count >= LEAST ? errorOf(pixel, lit) : 0.0);
  vec4 normals = texelFetch(sumNormal, pixel, 0);
  vec3 normal = transpose(viewToScene) * normals.xyz;
  // Black surfaces would mislead a regression.
  vec4 albedo = texelFetch(sumAlbedo, pixel, 0);
  bool reflects = any(greaterThan(albedo.rgb + light.rgb, vec3(0.0)));
  bool exists = count > 0.0 && reflects && dot(normal, normal) > 0.0 && all(lessThan(light.rgb, vec3(BRIGHTEST)));
  float z = -normals.w / max(albedo.a, 1.0);
  vec2 clip = vec2(view.ViewToClip[2].z, view.ViewToClip[2].w) * z + vec2(view.ViewToClip[3].z, view.ViewToClip[3].w);
  surface = exists ? vec4(giEncodeOctahedral(normalize(normal)), 0.5 * clip.x / clip.y + 0.5, 1.0) : vec4(0.0);
}
