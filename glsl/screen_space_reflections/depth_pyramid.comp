#version 430 core
// Depth range of surfaces, for each pixel and over squares of 2, 4, ...
// 64 pixels, in one dispatch: a group reduces 64 x 64 pixels (Greene, Kass and Miller 1993,
// "Hierarchical Z-Buffer Visibility"). A surface extends from its depth by the change of depth within the
// pixel plus the thickness. Sizes are rounded up, so that a texel covers exactly its pixels; at the upper bounds of an
// odd size these are fewer.
#include "shared/view.h"
#include "shared/reflection.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"

layout(local_size_x = GI_PYRAMID_GROUP, local_size_y = GI_PYRAMID_GROUP) in;

layout(rg32f, binding = 0) uniform writeonly image2D pyramid;
layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D normalTexture;

uniform ivec2 levelOffset[GI_PYRAMID_LEVELS + 1];
uniform float thickness; // world units

const vec2 NOTHING = vec2(2.0, -1.0);

shared vec2 ranges[GI_PYRAMID_GROUP * GI_PYRAMID_GROUP];

vec2 join(vec2 a, vec2 b)
{
  return vec2(min(a.x, b.x), max(a.y, b.y));
}

void store(int level, ivec2 texel, vec2 range)
{
  ivec2 size = (ivec2(view.Viewport.zw) + (1 << level) - 1) >> level;
  if (all(lessThan(texel, size)))
  {
    imageStore(pyramid, levelOffset[level] + texel, vec4(range, 0.0, 0.0));
  }
}

float depthAt(ivec2 pixel)
{
  ivec2 low = ivec2(view.Viewport.xy);
  return giViewDepth(
    texelFetch(depthTexture, clamp(pixel + low, low, low + ivec2(view.Viewport.zw) - 1), 0).r);
}

// Change of the view depth of a surface across a pixel, by its normal, but no more
// than the change toward the nearer neighbour along each axis, which is more likely on the same surface.
float depthChange(ivec2 pixel, float depth, float z)
{
  vec2 center = vec2(pixel) + view.Viewport.xy + 0.5;
  vec3 P = giViewPosition(center, depth);
  vec3 N = giDecodeOctahedral(texelFetch(normalTexture, pixel + ivec2(view.Viewport.xy), 0).xy);
  bool parallel = view.Scene.y > 0.5;
  vec3 ray = parallel ? vec3(0.0, 0.0, -1.0) : P / max(-P.z, 1e-20);
  vec2 size = 2.0 * (parallel ? 1.0 : -z) /
    (view.Viewport.zw * vec2(view.ViewToClip[0].x, view.ViewToClip[1].y));
  float byNormal = dot(size, abs(N.xy)) / max(abs(dot(N, ray)), 1e-3);
  float left = abs(depthAt(pixel - ivec2(1, 0)) - z);
  float right = abs(depthAt(pixel + ivec2(1, 0)) - z);
  float below = abs(depthAt(pixel - ivec2(0, 1)) - z);
  float above = abs(depthAt(pixel + ivec2(0, 1)) - z);
  return min(byNormal, min(left, right) + min(below, above));
}

vec2 surfaceAt(ivec2 pixel)
{
  if (any(greaterThanEqual(pixel, ivec2(view.Viewport.zw))))
  {
    return NOTHING;
  }
  float depth = texelFetch(depthTexture, pixel + ivec2(view.Viewport.xy), 0).r;
  float z = giViewDepth(depth);
  z -= 0.5 * depthChange(pixel, depth, z) + thickness;
  float end = (view.ViewToClip[2].z * z + view.ViewToClip[3].z) /
    (view.ViewToClip[2].w * z + view.ViewToClip[3].w);
  vec2 range = vec2(depth, end * 0.5 + 0.5);
  store(0, pixel, range);
  return range;
}

void main()
{
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  ivec2 local = ivec2(gl_LocalInvocationID.xy);
  int slot = local.y * GI_PYRAMID_GROUP + local.x;
  vec2 range = NOTHING;
  for (int i = 0; i < 4; ++i)
  {
    ivec2 texel = at * 2 + ivec2(i & 1, i >> 1);
    ivec2 pixel = texel * 2;
    vec2 range2x2 = join(join(surfaceAt(pixel), surfaceAt(pixel + ivec2(1, 0))),
      join(surfaceAt(pixel + ivec2(0, 1)), surfaceAt(pixel + 1)));
    store(1, texel, range2x2);
    range = join(range, range2x2);
  }
  store(2, at, range);
  ranges[slot] = range;
  barrier();
  for (int level = 3; level <= GI_PYRAMID_LEVELS; ++level)
  {
    int side = GI_PYRAMID_GROUP >> (level - 2);
    bool working = all(lessThan(local, ivec2(side)));
    if (working)
    {
      int first = 2 * (local.y * GI_PYRAMID_GROUP + local.x);
      range = join(join(ranges[first], ranges[first + 1]),
        join(ranges[first + GI_PYRAMID_GROUP], ranges[first + GI_PYRAMID_GROUP + 1]));
      store(level, ivec2(gl_WorkGroupID.xy) * side + local, range);
    }
    barrier();
    if (working)
    {
      ranges[slot] = range;
    }
    barrier();
  }
}
