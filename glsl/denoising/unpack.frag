#version 430 core
// The filtered value; where the filter has no share any more, exactly the unfiltered one. Variants: those of
// denoising/signal.glsl.
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/filter_reach.glsl"
#include "denoising/signal.glsl"
#ifdef GI_SHARES
layout(binding = 0) uniform sampler2DArray current;
uniform int layer;
#else
layout(binding = 0) uniform sampler2D current;
#endif
layout(binding = 1) uniform usampler2D signalTexture;
#ifdef GI_JOINT
layout(binding = 2) uniform sampler2D values;
#endif

layout(location = 0) out vec4 result;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  GiSignal signal = giUnpackSignal(texelFetch(signalTexture, pixel, 0));
#ifdef GI_SHARES
  result = signal.frames > 0.0 ? signal.value : texelFetch(current, ivec3(pixel, layer), 0);
#else
  result = texelFetch(current, pixel, 0);
  bool filtered = signal.frames > 0.0 && giFilterShare(signal.reach, 1.0).x > 0.0;
#ifdef GI_LOBE
  result = filtered ? signal.value : result;
#elif defined(GI_JOINT)
  result.rgb = filtered ? texelFetch(values, pixel, 0).rgb : result.rgb;
#else
  result.rgb = filtered ? signal.value.rgb : result.rgb;
#endif
#endif
}
