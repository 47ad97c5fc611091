#version 430 core
// What the filter knows of a pixel, as a colour. Variants: those of denoising/signal.glsl, GI_REPROJECTED (there is a mean over
// frames).
#include "lib/octahedral.glsl"
#include "lib/filter_reach.glsl"
#include "denoising/signal.glsl"
layout(binding = 0) uniform usampler2D signalTexture;
#ifdef GI_REPROJECTED
layout(binding = 1) uniform sampler2D reprojection;
#endif

uniform int show; // as vtkGIDenoising's parameter: 1: raw, 2: filtered, 3: frames, 4: error, 5: reach

layout(location = 0) out vec4 color;

// Dark blue, blue, green, yellow.
vec3 ramp(float share)
{
  const vec3 colors[4] = vec3[](vec3(0.1, 0.05, 0.35), vec3(0.1, 0.4, 0.7), vec3(0.2, 0.7, 0.35), vec3(1.0, 0.95, 0.3));
  float place = 3.0 * clamp(share, 0.0, 1.0);
  int first = min(int(place), 2);
  return mix(colors[first], colors[first + 1], place - float(first));
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  GiSignal signal = giUnpackSignal(texelFetch(signalTexture, pixel, 0));
  color = vec4(vec3(0.0), 1.0);
  if (signal.frames == 0.0)
  {
    return;
  }
  float frames = signal.frames;
#if defined(GI_REPROJECTED) && !defined(GI_LIGHT) // only light knows the frames of its mean
  frames = max(frames, texelFetch(reprojection, pixel, 0).z);
#endif
#ifdef GI_SHARES
  vec3 value = signal.value.rgb;
#else
  vec3 value = pow(signal.value.rgb, vec3(1.0 / 2.2));
#endif
#ifdef GI_LIGHT
  bool known = signal.error > 0.0;
  float error = signal.error;
#else
  const bool known = false;
  const float error = 0.0;
#endif
  color.rgb = show <= 2 ? value
    : (show == 3 ? ramp(log2(frames) / 6.0) : (show == 4 ? (known ? ramp(error) : vec3(0.0)) : ramp(signal.reach.x / radius)));
}
