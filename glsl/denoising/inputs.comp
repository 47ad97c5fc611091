#version 430 core
// What the network gets: for each pixel 16 numbers that depend neither on the unit of light nor on that of length. Blocks of
// 2x2 pixels get their mean; of single pixels only the layers of fine.glsl know.
#define GI_LIGHT
#include "shared/view.h"
#include "shared/denoising.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/alike.glsl"
#include "lib/filter_reach.glsl"
#include "lib/luminance.glsl"
#include "denoising/signal.glsl"
#include "denoising/network/fine.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D signalTexture;
layout(binding = 1) uniform sampler2D tileTexture;
layout(rgba16f, binding = 0) writeonly uniform image2DArray inputs;
layout(rgba16f, binding = 1) writeonly uniform image2DArray fine;

const float DEPTH_CHANGE = 16.0; // scale of the relative change of depth from pixel to pixel
const float MOST_LIGHT = 3.0;    // times the mean: what is brighter looks like what the training knows

GiSignal signalAt(ivec2 at)
{
  GiSignal signal = giUnpackSignal(texelFetch(signalTexture, at + ivec2(view.Viewport.xy), 0));
  signal.frames = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, ivec2(view.Viewport.zw))) ? signal.frames : 0.0;
  return signal;
}

// Mean luminance around a block: of the nearest tiles and their neighbours, with the weights of linear interpolation.
float scaleAt(ivec2 block)
{
  vec2 place = (2.0 * vec2(block) + 1.0) / float(GI_DENOISING_TILE) - 0.5;
  ivec2 corner = ivec2(floor(place)) - 1;
  vec2 f = fract(place);
  vec2 sum = vec2(0.0);
  for (int i = 0; i < 16; ++i)
  {
    ivec2 k = ivec2(i & 3, i >> 2);
    ivec2 tile = corner + k;
    if (all(greaterThanEqual(tile, ivec2(0))) && all(lessThan(vec2(tile), ceil(view.Viewport.zw / float(GI_DENOISING_TILE)))))
    {
      vec2 weight = mix(mix(vec2(1.0), f, equal(k, ivec2(3))), 1.0 - f, equal(k, ivec2(0)));
      sum += weight.x * weight.y * texelFetch(tileTexture, tile, 0).rg;
    }
  }
  return max(sum.x / max(sum.y, 1e-6), 1e-20);
}

// A pixel counts as no brighter than the brightest of its neighbours on the same surface, so that a single bright path does not
// look like an edge of light.
void fetchInputs(ivec2 at, GiSignal here, float scale, out vec4 v[4])
{
  vec2 place = vec2(at) + 0.5 + view.Viewport.xy;
  GiSurfel surfel = giSurfel(place, here.depth, here.normal, 1.0);
  vec3 N = giDecodeOctahedral(here.normal);
  float z = giViewDepth(here.depth);
  vec3 light = vec3(0.0);
  float weights = 0.0;
  float edge = 0.0;
  vec2 change = vec2(0.0);
  float brightest = -1.0; // luminance of neighbours; negative: there are none
  for (int i = 0; i < 9; ++i)
  {
    ivec2 offset = ivec2(i % 3, i / 3) - 1;
    GiSignal other = signalAt(at + offset);
    if (other.frames == 0.0)
    {
      continue;
    }
    float weight = other.frames * giSimilarity(surfel, vec2(offset), other.depth, other.normal);
    light += weight * other.value.rgb;
    weights += weight;
    if (offset != ivec2(0) && weight > 0.0)
    {
      brightest = max(brightest, giLuminance(other.value.rgb));
    }
    if (abs(offset.x) + abs(offset.y) == 1)
    {
      edge += 1.0 - clamp(dot(N, giDecodeOctahedral(other.normal)), 0.0, 1.0);
      float relative = DEPTH_CHANGE * clamp(giViewDepth(other.depth) / z - 1.0, -1.0, 1.0);
      change = mix(change, vec2(relative), equal(offset, ivec2(1)));
    }
  }
  float own = giLuminance(here.value.rgb);
  float share = brightest < 0.0 ? 1.0 : min(brightest / max(own, 1e-20), 1.0);
  vec3 value = log(1.0 + min(share * here.value.rgb / scale, MOST_LIGHT));
  vec3 mean = log(1.0 + min(light / (max(weights, 1e-6) * scale), MOST_LIGHT));
  float noise = log(1.0 + min(share * here.error * own / scale, MOST_LIGHT));
  float toEye = dot(N, giToEye(giViewPosition(place, here.depth)));
  v[0] = vec4(value, mean.r);
  v[1] = vec4(mean.gb, noise, here.frames / (here.frames + 8.0));
  v[2] = vec4(N, toEye);
  v[3] = vec4(edge, 1.0, change);
}

void main()
{
  ivec2 block = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(2.0 * vec2(block), view.Viewport.zw)))
  {
    return;
  }
  float scale = scaleAt(block);
  vec4 sums[4] = vec4[](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
  float count = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    ivec2 at = 2 * block + ivec2(i & 1, i >> 1);
    GiSignal here = signalAt(at);
    vec4 hidden[GI_FINE];
    for (int four = 0; four < GI_FINE; ++four)
    {
      hidden[four] = vec4(0.0); // without a surface: read by the filter, with a weight of 0
    }
    if (here.frames > 0.0)
    {
      vec4 v[4];
      fetchInputs(at, here, scale, v);
      giFine(v, hidden);
      for (int four = 0; four < 4; ++four)
      {
        sums[four] += v[four];
      }
      count += 1.0;
    }
    for (int four = 0; four < GI_FINE; ++four)
    {
      imageStore(fine, ivec3(at + ivec2(view.Viewport.xy), four), hidden[four]);
    }
  }
  for (int four = 0; four < 4; ++four)
  {
    imageStore(inputs, ivec3(block, four), sums[four] / max(count, 1.0));
  }
}
