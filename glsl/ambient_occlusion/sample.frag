#version 430 core
// Openness of a pixel's surface: GI_SAMPLES points in the hemisphere over it, each hidden or not
// from the eye by the depth buffer. Writes openness and view depth.
#include "shared/view.h"
#include "shared/occlusion.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"

layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D normalTexture;

uniform float radius; // world units
uniform float bias;   // world units

layout(location = 0) out vec2 result;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 P = giViewPosition(gl_FragCoord.xy, texelFetch(depthTexture, pixel, 0).r);
  vec3 N = giDecodeOctahedral(texelFetch(normalTexture, pixel, 0).xy);

  // Sixteen turns in a tile of 4 x 4 pixels, which the filter averages; another order each frame.
  int tile = ((pixel.x & 3) * 4 + (pixel.y & 3) + view.Frame.x * 7) & 15;
  int shuffled = (tile * 11) & 15;
  float turn = 6.28318531 * (float(shuffled) + fract(float(view.Frame.x) * 0.61803399)) / 16.0;
  // Any frame around the normal: Duff et al. 2017, Building an Orthonormal Basis, Revisited.
  float s = N.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (s + N.z);
  float b = N.x * N.y * a;
  vec3 T = vec3(1.0 + s * N.x * N.x * a, s * b, -s * N.x);
  vec3 B = vec3(b, s + N.y * N.y * a, -N.y);
  vec3 X = radius * (T * cos(turn) + B * sin(turn));
  vec3 Y = radius * (B * cos(turn) - T * sin(turn));
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

  float hidden = 0.0;
  for (int i = 0; i < GI_SAMPLES; ++i)
  {
    vec4 k = occlusion.Kernel[i];
    vec4 sampled = vec4(P + X * k.x + Y * k.y + Z * k.z, 1.0);
    float w = 1.0 / dot(rowW, sampled);
    vec2 window = centre + toWindow * vec2(dot(rowX, sampled), dot(rowY, sampled)) * w;
    ivec2 at = clamp(ivec2(window), low, high);
    float ndc = texelFetch(depthTexture, at, 0).r * 2.0 - 1.0;
    float seen = (depthZ.x * ndc + depthZ.y) / (depthW.x * ndc + depthW.y);
    // Hidden if something lies before the sample, but no further than the radius before the
    // surface: beyond, it is another thing in front.
    float ahead = seen - sampled.z;
    float near = 1.0 - clamp((seen - P.z) / radius - 1.0, 0.0, 1.0);
    hidden += ahead > bias ? near : 0.0;
  }
  result = vec2(1.0 - hidden / float(GI_SAMPLES), P.z);
}
