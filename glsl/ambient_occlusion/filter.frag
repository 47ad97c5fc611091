#version 430 core
// Average over the 4 x 4 pixels that share the sampling pattern, as far as they lie on the same
// surface: in the plane through this pixel, within a tolerance.
#include "shared/view.h"
#include "lib/octahedral.glsl"

layout(binding = 0) uniform sampler2D rawTexture; // openness, view depth
layout(binding = 1) uniform sampler2D normalTexture;

uniform float tolerance; // world units

layout(location = 0) out float openness;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 centre = texelFetch(rawTexture, pixel, 0).xy;
  vec3 N = giDecodeOctahedral(texelFetch(normalTexture, pixel, 0).xy);
  // World units a pixel at this depth, then how far the plane falls per pixel.
  float w = view.Scene.y > 0.5 ? 1.0 : -centre.y;
  vec2 size = 2.0 * w / (view.Viewport.zw * vec2(view.ViewToClip[0].x, view.ViewToClip[1].y));
  vec2 fall = -N.xy / max(abs(N.z), 0.1) * sign(N.z) * size;
  ivec2 low = ivec2(view.Viewport.xy);
  ivec2 high = low + ivec2(view.Viewport.zw) - 1;

  float sum = 0.0;
  float weights = 0.0;
  for (int y = -2; y <= 1; ++y)
  {
    for (int x = -2; x <= 1; ++x)
    {
      vec2 other = texelFetch(rawTexture, clamp(pixel + ivec2(x, y), low, high), 0).xy;
      float off = abs(other.y - centre.y - dot(fall, vec2(x, y)));
      float weight = off < tolerance ? 1.0 : 0.0;
      sum += weight * other.x;
      weights += weight;
    }
  }
  openness = weights > 0.0 ? sum / weights : centre.x;
}
