#version 430 core
// Openness of a pixel's surface: the share of GI_SAMPLES points in the hemisphere over it that the depth buffer does
// not hide from the eye. Variants: GI_STRIDE (width in pixels of the block that a texel represents).
#include "shared/view.h"
#include "shared/occlusion.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/sampling.glsl"
#include "ambient_occlusion/raw.glsl"

layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D normalTexture;

uniform float radius; // world units
uniform float bias;   // world units

layout(location = 0) out GI_RAW result;

void main()
{
  ivec2 raw = ivec2(gl_FragCoord.xy);
  ivec2 pixel = giRawPixel(raw);
  float depth = texelFetch(depthTexture, pixel, 0).r;
  if (depth >= 1.0)
  {
    result = giPackRaw(1.0, depth, vec2(0.5), vec3(0.0));
    return;
  }
  vec3 P = giViewPosition(vec2(pixel) + 0.5, depth);
  vec2 normal = texelFetch(normalTexture, pixel, 0).xy;
  vec3 N = giDecodeOctahedral(normal);

  // Sixteen rotations, which the filter averages.
  float turn = 6.28318531 * giRawNoise(raw).x;
  mat3 around = giBasis(N);
  vec3 X = radius * (around[0] * cos(turn) + around[1] * sin(turn));
  vec3 Y = radius * (around[1] * cos(turn) - around[0] * sin(turn));
  vec3 Z = radius * N;

  vec2 toWindow = 0.5 * view.Viewport.zw;
  vec2 centre = view.Viewport.xy + toWindow;
  vec4 rowX = vec4(view.ViewToClip[0].x, view.ViewToClip[1].x, view.ViewToClip[2].x, view.ViewToClip[3].x);
  vec4 rowY = vec4(view.ViewToClip[0].y, view.ViewToClip[1].y, view.ViewToClip[2].y, view.ViewToClip[3].y);
  vec4 rowW = vec4(view.ViewToClip[0].w, view.ViewToClip[1].w, view.ViewToClip[2].w, view.ViewToClip[3].w);
  // View depth from window depth is a ratio of two linear functions.
  vec2 depthZ = vec2(view.ClipToView[2].z, view.ClipToView[3].z);
  vec2 depthW = vec2(view.ClipToView[2].w, view.ClipToView[3].w);
  ivec2 low = ivec2(view.Viewport.xy);
  ivec2 high = low + ivec2(view.Viewport.zw) - 1;

  float occluded = 0.0;
  for (int i = 0; i < GI_SAMPLES; ++i)
  {
    vec4 k = occlusion.Kernel[i];
    vec4 sampled = vec4(P + X * k.x + Y * k.y + Z * k.z, 1.0);
    float w = 1.0 / dot(rowW, sampled);
    vec2 window = centre + toWindow * vec2(dot(rowX, sampled), dot(rowY, sampled)) * w;
    ivec2 at = clamp(ivec2(window), low, high);
    float ndc = texelFetch(depthTexture, at, 0).r * 2.0 - 1.0;
    float visibleDepth = (depthZ.x * ndc + depthZ.y) / (depthW.x * ndc + depthW.y);
    // A sample is occluded if something lies in front of it. Something in front of the surface by more than the radius
    // is taken for an unrelated object.
    float ahead = visibleDepth - sampled.z;
    float falloff = 1.0 - clamp((visibleDepth - P.z) / radius - 1.0, 0.0, 1.0);
    occluded += ahead > bias ? falloff : 0.0;
  }
  result = giPackRaw(1.0 - occluded / float(GI_SAMPLES), depth, normal, vec3(0.0));
}
