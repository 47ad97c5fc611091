#version 430 core
// Irradiance of the sky at each pixel's surface, divided by pi: the unoccluded light, which is known exactly, times the
// share of the sampled light that arrives. Variant: GI_STRIDE (1: joins the samples around the pixel; 2, 4: upsamples from
// half or quarter resolution: Kopf, Cohen, Lischinski and Uyttendaele 2007, Joint Bilateral Upsampling).
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/alike.glsl"
#include "lib/luminance.glsl"
#include "lib/interreflection.glsl"
layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D albedoTexture;
layout(binding = 2) uniform sampler2D normalTexture;
layout(binding = 3) uniform usampler2D rawTexture;
layout(binding = 4) uniform sampler2D openLight;
#include "sky_light/raw.glsl"
#if GI_STRIDE == 1
#include "sky_light/window.glsl"
#endif

uniform int openTexels;
uniform mat3 viewToSky;
uniform float intensity;
uniform float reflectedShare; // interreflection, unless other techniques add reflected light

layout(location = 0) out vec4 irradiance;

#if GI_STRIDE != 1
GiSkySum giUpsampled(ivec2 pixel, vec2 normal)
{
  GiSurfel here =
    giSurfel(gl_FragCoord.xy, texelFetch(depthTexture, pixel, 0).r, normal, float(GI_STRIDE));
  ivec2 place = pixel - ivec2(view.Viewport.xy);
  ivec2 corner = place / GI_STRIDE;
  vec2 fraction = vec2(place - corner * GI_STRIDE) / float(GI_STRIDE);
  GiSkySum sum = GiSkySum(vec3(0.0), 0.0, 0.0, vec2(0.0), 0.0);
  // Linear on the triangle of samples around the pixel, as each one takes time.
  bool above = fraction.x + fraction.y > 1.0;
  vec2 sides = above ? 1.0 - fraction.yx : fraction;
  for (int i = 0; i < 3; ++i)
  {
    ivec2 offset = i == 0 ? ivec2(above) : ivec2(i & 1, i >> 1);
    ivec2 at = min(corner + offset, gridSize - 1);
    GiSkySum other = giUnpackSky(texelFetch(rawTexture, at, 0));
    float linear = i == 0 ? 1.0 - sides.x - sides.y : sides[i - 1];
    // If none is on the surface, all of them count a little.
    float similarity = giSimilarity(here, vec2(giPixelOf(at) - pixel), other.depth, other.normal);
    float weight = other.frames > 0.0 ? (linear + 1e-3) * (similarity + 1e-3) : 0.0;
    sum.arrived += weight * other.arrived;
    sum.expected += weight * other.expected;
  }
  return sum;
}
#endif

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  irradiance = vec4(0.0);
  vec4 albedo = texelFetch(albedoTexture, pixel, 0);
  if (albedo.a == 0.0)
  {
    return;
  }
  vec2 normal = texelFetch(normalTexture, pixel, 0).xy;
#if GI_STRIDE == 1
  GiSkySum sum = giSkyWindow(pixel - ivec2(view.Viewport.xy));
#else
  GiSkySum sum = giUpsampled(pixel, normal);
#endif
  vec2 at = giEncodeOctahedral(viewToSky * giDecodeOctahedral(normal));
  vec4 open = textureLod(openLight, (at * float(openTexels) + 1.0) / float(openTexels + 2), 0.0);
  // Without samples nothing is known to be occluded.
  vec3 light = sum.expected > 0.0 ? sum.arrived * (open.a / sum.expected) : open.rgb;
  float openness = sum.expected > 0.0 ? min(giLuminance(sum.arrived) / sum.expected, 1.0) : 1.0;
  light *= giReflectedGain(openness, reflectedShare * albedo.rgb / albedo.a);
  irradiance = vec4(intensity * light, 1.0);
}
