#version 430 core
// Maps the lit part of each pixel to the display. The rest of the pixel, such as background or annotations at an edge,
// keeps its colour. Variant: GI_AUTO, see exposure.glsl.
#include "lib/tone.glsl"
#include "tone_mapping/exposure.glsl"
layout(binding = 0) uniform sampler2D before;
layout(binding = 1) uniform sampler2D shownTexture;   // see resource::LitShown
layout(binding = 2) uniform sampler2D encodedTexture; // and LitEncoded
uniform int curve;

layout(location = 0) out vec4 color;

vec3 encode(vec3 linear)
{
  return pow(linear, vec3(1.0 / 2.2));
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  color = texelFetch(before, pixel, 0);
  vec4 shown = texelFetch(shownTexture, pixel, 0);
  vec4 encoded = texelFetch(encodedTexture, pixel, 0);
  float rest = 1.0 - shown.a - encoded.a; // share of the pixel that is not lit
  if (rest >= 1.0)
  {
    return;
  }
  vec3 mean = giFinite(shown.rgb / max(shown.a, 1e-6));
  vec3 meanEncoded = giFinite(encoded.rgb / max(encoded.a, 1e-6));
  vec3 drawn = shown.a * min(mean, 1.0) + encoded.a * encode(min(meanEncoded, 1.0));
  // Less than an eighth of a pixel in 255ths cannot be told from the rounding of the picture.
  vec3 kept = rest > 0.0005 ? clamp(color.rgb - drawn, 0.0, rest) : vec3(0.0);
  float factor = exposureScale();
  color.rgb = kept + shown.a * giTone(curve, factor * mean, false) +
    encoded.a * encode(giTone(curve, factor * meanEncoded, true));
}
