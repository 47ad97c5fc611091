#version 430 core
// Finds the exposure at which lit surfaces have a given mean brightness on the display: the mean of the logarithm, as in
// Reinhard et al. 2002, "Photographic Tone Reproduction for Digital Images", section 3. One group reads the whole picture,
// or a regular grid of its pixels if it is large.
#include "shared/view.h"
#include "lib/luminance.glsl"

layout(local_size_x = 256) in;

layout(rgba32f, binding = 0) uniform image2D exposure; // r: factor; g: 1
layout(binding = 0) uniform sampler2D shownTexture;
layout(binding = 1) uniform sampler2D encodedTexture;

uniform float autoBrightness; // mean brightness on the display
uniform float share;          // of the new exposure; the rest is the previous frame's

const int LANES = 256;
const int SAMPLES = 32768;
// Share of the mean brightness that is added to each pixel, so that black pixels do not count too much.
const float DARKEST = 0.01;
const float LIMIT = 60.0; // of the exposure, in stops

shared vec4 sums[LANES];

vec4 total(vec4 own)
{
  int lane = int(gl_LocalInvocationID.x);
  sums[lane] = own;
  barrier();
  for (int step = LANES / 2; step > 0; step /= 2)
  {
    if (lane < step)
    {
      sums[lane] += sums[lane + step];
    }
    barrier();
  }
  vec4 sum = sums[0];
  barrier();
  return sum;
}

// The part of a pixel; nothing where it is not finite.
vec4 partOf(sampler2D source, ivec2 pixel)
{
  vec4 part = texelFetch(source, pixel, 0);
  return any(isnan(part)) || any(isinf(part)) ? vec4(0.0) : part;
}

float brightness(vec4 part)
{
  return max(giLuminance(part.rgb / max(part.a, 1e-6)), 0.0);
}

void main()
{
  ivec2 area = ivec2(view.Viewport.zw);
  int stride = max(1, int(ceil(sqrt(float(area.x) * float(area.y) / float(SAMPLES)))));
  ivec2 count = (area + stride - 1) / stride;
  // The mean of the fourth roots hardly depends on a few very bright pixels.
  vec4 sum = vec4(0.0);
  for (int i = int(gl_LocalInvocationID.x); i < count.x * count.y; i += LANES)
  {
    ivec2 pixel = min(stride * ivec2(i % count.x, i / count.x) + stride / 2, area - 1) + ivec2(view.Viewport.xy);
    vec4 shown = partOf(shownTexture, pixel);
    vec4 encoded = partOf(encodedTexture, pixel);
    sum.x += shown.a + encoded.a;
    sum.y += shown.a * pow(brightness(shown), 0.25) + encoded.a * pow(brightness(encoded), 0.25);
  }
  sum = total(sum);
  float darkest = sum.x > 0.0 ? DARKEST * pow(sum.y / sum.x, 4.0) : 0.0;
  // On the display a factor k multiplies values by k, or by its power of 1 / 2.2 if they are encoded.
  vec4 logs = vec4(0.0);
  for (int i = int(gl_LocalInvocationID.x); i < count.x * count.y && darkest > 0.0; i += LANES)
  {
    ivec2 pixel = min(stride * ivec2(i % count.x, i / count.x) + stride / 2, area - 1) + ivec2(view.Viewport.xy);
    vec4 shown = partOf(shownTexture, pixel);
    vec4 encoded = partOf(encodedTexture, pixel);
    logs.x += shown.a + encoded.a;
    logs.y += shown.a + encoded.a / 2.2;
    logs.z += shown.a * log2(brightness(shown) + darkest) +
      encoded.a / 2.2 * log2(brightness(encoded) + darkest);
  }
  logs = total(logs);
  if (gl_LocalInvocationID.x == 0u)
  {
    vec4 previous = imageLoad(exposure, ivec2(0));
    float stops = clamp((log2(autoBrightness) * logs.x - logs.z) / max(logs.y, 1e-6), -LIMIT, LIMIT);
    // Without lit surfaces the exposure stays as it is.
    bool found = darkest > 0.0;
    float before = share < 1.0 && previous.r > 0.0 ? log2(previous.r) : (found ? stops : 0.0);
    imageStore(exposure, ivec2(0), vec4(exp2(mix(before, found ? stops : before, share)), 1.0, 0.0, 0.0));
  }
}
