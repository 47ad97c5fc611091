#version 430 core
// The filtered value; where the filter has no share any more, exactly the unfiltered one.
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "denoising/signal.glsl"
layout(binding = 0) uniform sampler2D current;
layout(binding = 1) uniform usampler2D signalTexture;

uniform float radius;

layout(location = 0) out vec4 result;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  result = texelFetch(current, pixel, 0);
  GiSignal signal = giUnpackSignal(texelFetch(signalTexture, pixel, 0));
  bool filtered = signal.frames > 0.0 && giFilterShare(radius, 1.0, signal.frames) > 0.0;
  result.rgb = filtered ? signal.value : result.rgb;
}
