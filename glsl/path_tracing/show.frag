#version 430 core
// Mean of the samples so far. Variant: GI_RADIANCE (linear radiance, not the colour for display).
layout(binding = 0) uniform sampler2D sumShown;
layout(binding = 1) uniform sampler2D sumEncoded;
layout(binding = 2) uniform sampler2D colorTexture;

uniform float samples;

layout(location = 0) out vec4 color;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 shown = texelFetch(sumShown, pixel, 0);
  vec3 encoded = texelFetch(sumEncoded, pixel, 0).rgb;
#ifdef GI_RADIANCE
  color.rgb = (shown.rgb + encoded) / samples;
#else
  // The part of the pixel that PBR surfaces cover is averaged first and then encoded as in VTK.
  vec3 mean = shown.a > 0.0 ? pow(max(encoded / shown.a, 0.0), vec3(1.0 / 2.2)) : vec3(0.0);
  color.rgb = (shown.rgb + shown.a * mean) / samples;
#endif
  color.a = texelFetch(colorTexture, pixel, 0).a;
}
