#version 430 core
// Temporal mean of a result over the frames in which its surface was visible. Variants: GI_LAYERS (an array
// texture), GI_STILL (nothing moves), GI_CLAMP (something changed: clamp the history to the current values in the
// neighbourhood; Karis 2014, High-Quality Temporal Supersampling; Salvi 2016, An Excursion in Temporal
// Supersampling), GI_REACH (reduce the reach of the spatial filter that follows), GI_GUIDE (also show the mean, as the filter's
// guide).
// If the picture is a mean of still frames, this frame's own value is shown instead of the mean: where albedo or slope vary within a
// pixel, the mean of their products with light is not the product of the means.
#include "shared/view.h"
#include "lib/filter_reach.glsl"
#include "lib/luminance.glsl"

#ifdef GI_LAYERS
#define GI_TEXTURE sampler2DArray
#define GI_AT(pixel) ivec3(pixel, layer)
uniform int layer;
#else
#define GI_TEXTURE sampler2D
#define GI_AT(pixel) (pixel)
#endif

layout(binding = 0) uniform sampler2D reprojection; // see reproject.frag
layout(binding = 1) uniform GI_TEXTURE current;
layout(binding = 2) uniform GI_TEXTURE history;

uniform vec4 most;        // maximum number of frames in each channel's mean, including this one
uniform float clampWidth; // in standard deviations
// Frame n of a mean has a weight proportional to the power `recency` of n: 0 for a plain mean; 1 lets the first frames fade
// quickly, at 4 / 3 of its variance.
uniform float recency;
// Show as a the number of samples, plus the relative standard error of the mean's luminance, which is below 1; 0: unknown. The
// history's a is the mean square of the luminance, the current value's a the number of pixels that share a sample, negative
// if this one is another pixel's (ray_traced_light/spread.frag).
uniform bool counts;
uniform float averagedFrames; // number of still frames whose mean is the picture, including this one; 0: this frame is the picture

layout(location = 0) out vec4 mean;  // the next frame's history
layout(location = 1) out vec4 shown;
#ifdef GI_GUIDE
layout(location = 2) out vec4 guide;
#elif defined(GI_REACH)
layout(binding = 3) uniform GI_TEXTURE reachTexture;
layout(location = 2) out vec4 reach;
#endif

vec4 valueAt(ivec2 pixel)
{
  vec4 value = texelFetch(current, GI_AT(pixel), 0);
  float light = giLuminance(value.rgb);
  return counts ? vec4(value.rgb, light * light) : value;
}

// Relative standard error of a mean's luminance, from the spread of a few samples at least.
float errorOf(vec4 mean, float samples)
{
  const float least = 4.0;
  float light = giLuminance(mean.rgb);
  float variance = max(mean.a - light * light, 0.0) * (1.0 + recency / 3.0) / samples;
  return samples < least ? 0.0 : min(sqrt(variance) / max(light, 1e-20), 0.99);
}

// Weight of the current value in the mean of a number of frames. If pixels share a sample, they use those of others in the
// first frames only, in which each gets one of its own; together those count as one sample.
vec4 currentShare(vec4 frames, float sharing)
{
  float turns = abs(sharing);
  vec4 plain = (1.0 + recency) / (frames + recency);
  if (turns <= 1.0)
  {
    return plain;
  }
  vec4 samples = ceil(frames / turns);
  vec4 ownShare = 1.0 / ((samples + recency) / (1.0 + recency) + pow(samples, vec4(-recency)));
  vec4 othersShare = mix(vec4(0.0), 1.0 / frames, lessThanEqual(frames, vec4(turns)));
  return sharing > 0.0 ? ownShare : othersShare;
}

#ifndef GI_STILL
// The history at a place, by cubic interpolation, which keeps edges sharp over many frames of motion (Catmull and Rom 1974, A
// Class of Local Interpolating Splines). The result is limited to the range of the four nearest values, all of which must be
// known. corner: the lower left one of these; f: the place relative to it.
vec4 cubicHistoryAt(ivec2 corner, vec2 f)
{
  vec2 shares[4] = vec2[](f * (f * (1.0 - 0.5 * f) - 0.5), 1.0 + f * f * (1.5 * f - 2.5), f * (0.5 + f * (2.0 - 1.5 * f)),
    f * f * (0.5 * f - 0.5));
  ivec2 last = textureSize(history, 0).xy - 1;
  vec4 sum = vec4(0.0);
  vec4 least = vec4(1e30);
  vec4 most = vec4(-1e30);
  for (int i = 0; i < 16; ++i)
  {
    ivec2 place = ivec2(i & 3, i >> 2);
    vec4 value = texelFetch(history, GI_AT(clamp(corner + place - 1, ivec2(0), last)), 0);
    sum += shares[place.x].x * shares[place.y].y * value;
    bool nearest = all(lessThan(abs(vec2(place) - 1.5), vec2(1.0)));
    if (nearest)
    {
      least = min(least, value);
      most = max(most, value);
    }
  }
  // The others may lie where there was no surface, and hold anything, even NaN.
  return any(isnan(sum)) ? 0.5 * (least + most) : clamp(sum, least, most);
}
#endif

vec4 historyAt(ivec2 pixel, vec4 moved)
{
#ifdef GI_STILL
  return texelFetch(history, GI_AT(pixel), 0);
#else
  vec2 place = vec2(pixel) + moved.xy;
  vec2 corner = floor(place);
  vec2 weight = place - corner;
  if (int(moved.w) == 15)
  {
    return cubicHistoryAt(ivec2(corner), weight);
  }
  vec4 sum = vec4(0.0);
  float weights = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    if ((int(moved.w) >> i & 1) != 0)
    {
      ivec2 offset = ivec2(i & 1, i >> 1);
      vec2 shares = mix(1.0 - weight, weight, vec2(offset));
      // The only accepted pixel may have no share here, as the offset is stored with less precision.
      float share = max(shares.x * shares.y, 1e-4);
      sum += share * texelFetch(history, GI_AT(ivec2(corner) + offset), 0);
      weights += share;
    }
  }
  return sum / weights;
#endif
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 currentValue = valueAt(pixel);
  vec4 moved = texelFetch(reprojection, pixel, 0);
  mean = currentValue;
  vec4 own = currentValue;
  vec4 frames = vec4(1.0);
  float sharing = counts ? texelFetch(current, GI_AT(pixel), 0).a : 1.0;
  if (int(moved.w) != 0)
  {
    vec4 previousValue = historyAt(pixel, moved);
#ifdef GI_CLAMP
    ivec2 low = ivec2(view.Viewport.xy);
    ivec2 high = low + ivec2(view.Viewport.zw) - 1;
    vec4 moment1 = vec4(0.0);
    vec4 moment2 = vec4(0.0);
    float count = 0.0;
    for (int i = 0; i < 9; ++i)
    {
      ivec2 at = clamp(pixel + ivec2(i % 3 - 1, i / 3 - 1), low, high);
      if (texelFetch(reprojection, at, 0).z > 0.0) // a surface
      {
        vec4 near = valueAt(at);
        moment1 += near;
        moment2 += near * near;
        count += 1.0;
      }
    }
    moment1 /= count;
    vec4 width = clampWidth * sqrt(max(moment2 / count - moment1 * moment1, 0.0));
    previousValue = clamp(previousValue, moment1 - width, moment1 + width);
#endif
    frames = max(min(vec4(moved.z), most), 1.0);
    vec4 share = currentShare(frames, sharing);
    mean = mix(previousValue, currentValue, share);
    // The first still frames also show the history of moving ones.
    own = averagedFrames > 0.0 ? mix(previousValue, currentValue, min(averagedFrames * share, 1.0)) : mean;
  }
  float samples = max(floor(frames.r / max(abs(sharing), 1.0)), 1.0);
  float known = samples + errorOf(mean, samples);
  shown = counts ? vec4(own.rgb, known) : own;
#ifdef GI_GUIDE
  guide = vec4(mean.rgb, known);
#elif defined(GI_REACH)
  reach = texelFetch(reachTexture, GI_AT(pixel), 0) * giReachAfter(frames - 1.0, 4.0, 64.0);
#endif
}
