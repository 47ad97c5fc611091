// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Light of the sky on props that VTK draws itself (see forward/indirect.glsl): looks up GI_SKY_LOOKUPS maps at each point.
// GI_SKY_SHARE is the share of the light that this is: 0 if others add to it. Needs lib/octahedral.glsl,
// lib/cube_light.glsl and lib/luminance.glsl.
uniform sampler2D fieldAtlas;
#include "sky_light/lookup.glsl"
uniform vec4 fieldMaps[4 * GI_SKY_LOOKUPS];
uniform mat4 fieldFromView; // to positions relative to the maps' centre
uniform mat3 fieldToSky;
uniform sampler2D fieldOpen; // irradiance where nothing is occluded
uniform int fieldOpenTexels;
uniform float fieldIntensity;
uniform float fieldGrainSize;

vec3 fieldLight(vec4 sum, vec3 N)
{
  vec2 at = giEncodeOctahedral(fieldToSky * N);
  vec4 open = textureLod(fieldOpen, (at * float(fieldOpenTexels) + 1.0) / float(fieldOpenTexels + 2), 0.0);
  return fieldIntensity * (sum.a > 0.0 ? sum.rgb * (open.a / sum.a) : open.rgb);
}

vec4 fieldIndirect(vec3 P, vec3 N, vec3 V, float reach)
{
  if (fieldHalf <= 0.0)
  {
    return vec4(0.0); // this mapper sets no uniforms
  }
  vec3 normal = mat3(fieldFromView) * N;
  GiSkyReceiver at = GiSkyReceiver((fieldFromView * vec4(P, 1.0)).xyz, normal, normal);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < GI_SKY_LOOKUPS; ++i)
  {
    sum += giSkyLight(fieldMaps[4 * i], fieldMaps[4 * i + 1], fieldMaps[4 * i + 2], fieldMaps[4 * i + 3], at);
  }
  return vec4(fieldLight(sum, normal), GI_SKY_SHARE);
}

float fieldIndirectCube(vec3 P, vec3 V, float reach, out vec3 cube[6])
{
  vec4 sums[6];
  for (int side = 0; side < 6; ++side)
  {
    sums[side] = vec4(0.0);
    cube[side] = vec3(0.0);
  }
  if (fieldHalf <= 0.0)
  {
    return 0.0;
  }
  vec3 place = (fieldFromView * vec4(P, 1.0)).xyz;
  for (int i = 0; i < GI_SKY_LOOKUPS; ++i)
  {
    vec4 depth = fieldMaps[4 * i + 2];
    vec4 weight = fieldMaps[4 * i + 3];
    vec3 against = normalize(depth.xyz);
    GiSkyReceiver at = GiSkyReceiver(place, -against, -against);
    float open = giSkyOpen(fieldMaps[4 * i], fieldMaps[4 * i + 1], dot(depth.xyz, place) + depth.w, length(depth.xyz),
      weight.a, at);
    for (int side = 0; side < 6; ++side)
    {
      // The sides are those of view coordinates.
      vec3 light = max(0.0, -dot(mat3(fieldFromView) * GI_CUBE_SIDES[side], depth.xyz)) * weight.rgb;
      sums[side] += vec4(open * light, giLuminance(light));
    }
  }
  for (int side = 0; side < 6; ++side)
  {
    cube[side] = fieldLight(sums[side], mat3(fieldFromView) * GI_CUBE_SIDES[side]);
  }
  return GI_SKY_SHARE;
}

float fieldGrain()
{
  return fieldGrainSize;
}
