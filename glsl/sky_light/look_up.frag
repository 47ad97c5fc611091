#version 430 core
// Looks up a part of the sky's maps for those pixels of blocks of 4 x 4 that are at one place in their block. Draws to the
// tile of that place. Variants: GI_LOOKUPS (maps in a part), GI_STRIDE, GI_CONTINUED (average with the last frame).
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/height.glsl"
#include "lib/luminance.glsl"
#include "lib/reconstruct.glsl"
#include "lib/alike.glsl"

layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D albedoTexture;
layout(binding = 2) uniform sampler2D normalTexture;
layout(binding = 3) uniform sampler2D facetTexture;
layout(binding = 4) uniform sampler2D fieldAtlas;
#ifdef GI_CONTINUED
layout(binding = 5) uniform usampler2D previousTexture;
#endif

#include "sky_light/raw.glsl"
#include "sky_light/lookup.glsl"

uniform vec4 skyMaps[4 * GI_LOOKUPS];
uniform ivec2 place; // in the block
uniform mat3 viewToScene;
uniform vec3 eye; // relative to the maps' centre

layout(location = 0) out uvec4 result;

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 pixel = giPixelOf((texel - place * gridTile) * 4 + place);
  result = uvec4(0u);
  if (texelFetch(albedoTexture, pixel, 0).a == 0.0)
  {
    return;
  }
  float depth = texelFetch(depthTexture, pixel, 0).r;
  vec2 normal = texelFetch(normalTexture, pixel, 0).xy;
  vec3 facet = texelFetch(facetTexture, pixel, 0).xyz;
  vec3 N = giDecodeOctahedral(normal);
  // Light arrives at the curved surface that the normals represent.
  vec3 P = giViewPosition(vec2(pixel) + 0.5, depth) + giDecodeHeight(facet.z) * N;
  GiSkyReceiver at =
    GiSkyReceiver(eye + viewToScene * P, viewToScene * N, viewToScene * giDecodeOctahedral(facet.xy));
  vec4 sum = vec4(0.0);
  for (int i = 0; i < GI_LOOKUPS; ++i)
  {
    sum += giSkyLight(skyMaps[4 * i], skyMaps[4 * i + 1], skyMaps[4 * i + 2], skyMaps[4 * i + 3], at);
  }
  sum /= float(GI_LOOKUPS);
  GiSkySum mean = GiSkySum(sum.rgb, sum.a, depth, normal, 1.0);
#ifdef GI_CONTINUED
  GiSkySum last = giUnpackSky(texelFetch(previousTexture, texel, 0));
  GiSurfel here = giSurfel(vec2(pixel) + 0.5, depth, normal, 1.0);
  if (last.frames > 0.0 && giSimilarity(here, vec2(0.0), last.depth, last.normal) > 0.0)
  {
    mean.frames = last.frames + 1.0;
    mean.arrived = mix(last.arrived, mean.arrived, 1.0 / mean.frames);
    mean.expected = mix(last.expected, mean.expected, 1.0 / mean.frames);
  }
#endif
  result = giPackSky(mean);
}
