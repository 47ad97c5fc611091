#version 430 core
// Openness of a pixel's surface by horizons: in GI_SLICES planes that contain the view direction,
// GI_STEPS places to each side find how high the surroundings rise, and the light above them is
// known in closed form. Jimenez, Wu, Pesce and Jarabo 2016, Practical Realtime Strategies for
// Accurate Indirect Occlusion. Variants: GI_STRIDE (pixels of the window a texel here stands for).
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/sampling.glsl"
#include "ambient_occlusion/raw.glsl"
#include "ambient_occlusion/arc.glsl"

layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D normalTexture;

uniform float radius; // world units
uniform float bias;   // sine of the elevation that counts as flat

layout(location = 0) out uvec2 result;

// How the places crowd near the pixel, where a small thing fills a large angle.
const float CROWDING = 2.0;

// Pixels from a place to the viewport's border.
float pixelsToBorder(vec2 place, vec2 direction)
{
  vec2 border = mix(view.Viewport.xy, view.Viewport.xy + view.Viewport.zw, greaterThan(direction, vec2(0.0)));
  vec2 reach = (border - place) / mix(direction, vec2(1e-6), lessThan(abs(direction), vec2(1e-6)));
  return min(abs(reach.x), abs(reach.y));
}

void main()
{
  ivec2 raw = ivec2(gl_FragCoord.xy);
  ivec2 pixel = giRawPixel(raw);
  float depth = texelFetch(depthTexture, pixel, 0).r;
  if (depth >= 1.0)
  {
    result = giPackRaw(1.0, depth, vec3(0.0, 0.0, 1.0));
    return;
  }
  vec2 place = vec2(pixel) + 0.5;
  vec3 P = giViewPosition(place, depth);
  vec3 N = giDecodeOctahedral(texelFetch(normalTexture, pixel, 0).xy);
  vec3 V = normalize(giViewPosition(place, 0.0) - giViewPosition(place, 1.0));
  mat3 around = giBasis(V);
  vec2 spread = giRawSpread(raw);

  vec2 toWindow = 0.5 * view.Viewport.zw;
  ivec2 low = ivec2(view.Viewport.xy);
  ivec2 high = low + ivec2(view.Viewport.zw) - 1;
  vec4 clip = view.ViewToClip * vec4(P, 1.0);
  // Position is a ratio of functions linear in window coordinates and depth.
  vec4 perX = view.ClipToView[0] / toWindow.x;
  vec4 perY = view.ClipToView[1] / toWindow.y;
  vec4 perDepth = view.ClipToView[2] * 2.0;
  vec4 origin = view.ClipToView[3] - view.ClipToView[2] -
    (view.Viewport.x / toWindow.x + 1.0) * view.ClipToView[0] -
    (view.Viewport.y / toWindow.y + 1.0) * view.ClipToView[1];

  float closed = 0.0;
  for (int slice = 0; slice < GI_SLICES; ++slice)
  {
    float turn = (float(slice) + spread.x) * (GI_ARC_PI / float(GI_SLICES));
    vec3 T = around[0] * cos(turn) + around[1] * sin(turn);
    // Where T leads on the screen, and how many pixels a world unit is.
    vec4 along = view.ViewToClip * vec4(T, 0.0);
    vec2 direction = toWindow * (along.xy - clip.xy / clip.w * along.w) / clip.w;
    float perUnit = max(length(direction), 1e-30);
    direction /= perUnit;
    // The normal's part in the slice.
    vec2 n = vec2(max(dot(N, V), 1e-3), dot(N, T));
    float share = length(n);
    n /= share;
    vec3 tangent = n.x * T - n.y * V;
    float tilt = atan(n.y, n.x);
    float visible = 0.0;
    for (float side = -1.0; side < 2.0; side += 2.0)
    {
      float level = -side * n.y;
      float horizon = level;
      float border = pixelsToBorder(place, side * direction);
      float reach = max(min(radius * perUnit, border) - 1.0, 0.0);
      for (int i = 0; i < GI_STEPS && border > 1.0; ++i)
      {
        float t = (float(i) + spread.y) / float(GI_STEPS);
        float s = side * (1.0 + reach * pow(t, CROWDING));
        ivec2 at = clamp(ivec2(place + direction * s), low, high);
        float there = texelFetch(depthTexture, at, 0).r;
        vec2 center = vec2(at) + 0.5;
        vec4 q = origin + perX * center.x + perY * center.y + perDepth * there;
        vec3 D = q.xyz / q.w - P;
        // The texel's centre lies beside the slice: its height over the tangent plane counts, so
        // that no plane occludes itself.
        float height = dot(D, N);
        float rise = height / share;
        float run = dot(D, tangent);
        float across = rise * n.y + run * n.x;
        float toward = rise * n.x - run * n.y;
        // What is seen stands for a column behind it: of that, the part within the radius counts,
        // unless it is so far before the surface that it must be another thing.
        float top = min(toward, sqrt(max(radius * radius - across * across, 0.0)));
        float weight = clamp(2.0 - toward / radius, 0.0, 1.0);
        bool above = there < 1.0 && at != pixel && height > bias * length(D);
        float found = top * inversesqrt(max(top * top + across * across, 1e-30));
        horizon = above ? max(horizon, mix(level, found, weight)) : horizon;
      }
      visible += giArc(giClampArc(side * acos(clamp(horizon, -1.0, 1.0)), tilt), tilt, n);
    }
    closed += share * max(giOpenArc(tilt, n) - visible, 0.0);
  }
  result = giPackRaw(1.0 - closed / float(GI_SLICES), depth, N);
}
