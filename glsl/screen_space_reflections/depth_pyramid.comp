#version 430 core
// Where surfaces begin and end along the view, as depths: of each pixel, and over squares of 2, 4, ...
// 64 pixels, in one dispatch, as a group reduces 64 x 64 pixels (Greene, Kass and Miller 1993,
// "Hierarchical Z-Buffer Visibility"). A surface ends by the thickness behind its beginning. Sizes are
// rounded up, so a texel covers exactly its pixels, of which there are fewer at the upper bounds of an
// odd size.
#include "shared/view.h"
#include "shared/reflection.h"
#include "lib/reconstruct.glsl"

layout(local_size_x = GI_PYRAMID_GROUP, local_size_y = GI_PYRAMID_GROUP) in;

layout(rg32f, binding = 0) uniform writeonly image2D pyramid;
layout(binding = 0) uniform sampler2D depthTexture;

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

vec2 surfaceAt(ivec2 pixel)
{
  if (any(greaterThanEqual(pixel, ivec2(view.Viewport.zw))))
  {
    return NOTHING;
  }
  float depth = texelFetch(depthTexture, pixel + ivec2(view.Viewport.xy), 0).r;
  float z = giViewDepth(depth) - thickness;
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
    vec2 four = join(join(surfaceAt(pixel), surfaceAt(pixel + ivec2(1, 0))),
      join(surfaceAt(pixel + ivec2(0, 1)), surfaceAt(pixel + 1)));
    store(1, texel, four);
    range = join(range, four);
  }
  store(2, at, range);
  ranges[slot] = range;
  barrier();
  for (int level = 3; level <= GI_PYRAMID_LEVELS; ++level)
  {
    int side = GI_PYRAMID_GROUP >> (level - 2);
    bool active_ = all(lessThan(local, ivec2(side)));
    if (active_)
    {
      int first = 2 * (local.y * GI_PYRAMID_GROUP + local.x);
      range = join(join(ranges[first], ranges[first + 1]),
        join(ranges[first + GI_PYRAMID_GROUP], ranges[first + GI_PYRAMID_GROUP + 1]));
      store(level, ivec2(gl_WorkGroupID.xy) * side + local, range);
    }
    barrier();
    if (active_)
    {
      ranges[slot] = range;
    }
    barrier();
  }
}
