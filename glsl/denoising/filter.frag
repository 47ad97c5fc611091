#version 430 core
// One level of an a-trous filter: the mean of nine samples on the same surface, each weighted by its number of frames
// (Dammertz, Sewtz, Hanika and Lensch 2010, Edge-Avoiding A-Trous Wavelet Transform for fast Global Illumination Filtering).
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/alike.glsl"
#include "denoising/signal.glsl"
layout(binding = 0) uniform usampler2D signalTexture;

uniform int step;
uniform float radius; // in pixels

layout(location = 0) out uvec4 result;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  result = texelFetch(signalTexture, pixel, 0);
  GiSignal signal = giUnpackSignal(result);
  float share = signal.frames > 0.0 ? giFilterShare(radius, float(step), signal.frames) : 0.0;
  if (share == 0.0)
  {
    return;
  }
  ivec2 low = ivec2(view.Viewport.xy);
  ivec2 high = low + ivec2(view.Viewport.zw) - 1;
  GiSurfel here = giSurfel(gl_FragCoord.xy, signal.depth, signal.normal, float(step));
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int i = 0; i < 9; ++i)
  {
    ivec2 offset = ivec2(i % 3, i / 3) - 1;
    ivec2 at = pixel + step * offset;
    if (any(lessThan(at, low)) || any(greaterThan(at, high)))
    {
      continue;
    }
    GiSignal other = giUnpackSignal(texelFetch(signalTexture, at, 0));
    vec2 kernel = mix(vec2(0.5), vec2(0.25), notEqual(offset, ivec2(0)));
    float weight = kernel.x * kernel.y * other.frames * giSimilarity(here, vec2(step * offset), other.depth, other.normal);
    sum += weight * other.value;
    weights += weight;
  }
  signal.value = mix(signal.value, sum / max(weights, 1e-6), weights > 0.0 ? share : 0.0);
  result = giPackSignal(signal);
}
