#version 430 core
// Smooths stair-steps along edges, after FXAA (Lottes 2009): finds the edge through a
// pixel by its contrast, follows it in both directions to its ends, and shifts the pixel across the edge by its
// position along the step. Single dots and thin lines, which have no such edge, are blended by their contrast to the
// neighbourhood. Variant: GI_COVERAGE (only where coverage is unknown).
#include "shared/view.h"
#ifdef GI_COVERAGE
#include "anti_aliasing/coverage.glsl"
layout(binding = 1) uniform usampler2D coverageTexture;
#endif

layout(binding = 0) uniform sampler2D colorTexture;
layout(location = 0) out vec4 color;

const float SmallestContrast = 0.0312; // visibility threshold in the dark
const float RelativeContrast = 0.125;  // threshold relative to the brightest neighbour
const float DotBlend = 0.75;
const int Reach = 10; // length of the search along an edge, in pixels

ivec2 low, high;

vec4 pixelAt(ivec2 p)
{
  return texelFetch(colorTexture, clamp(p, low, high), 0);
}

float luma(vec3 c)
{
  return dot(c, vec3(0.299, 0.587, 0.114));
}

float lumaAt(ivec2 p)
{
  return luma(pixelAt(p).rgb);
}

void main()
{
  low = ivec2(view.Viewport.xy);
  high = low + ivec2(view.Viewport.zw) - 1;
  ivec2 p = ivec2(gl_FragCoord.xy);
  vec4 centre = texelFetch(colorTexture, p, 0);
  color = centre;
#ifdef GI_COVERAGE
  if (texelFetch(coverageTexture, p, 0).r != COVERAGE_UNKNOWN)
  {
    return;
  }
#endif
  float m = luma(centre.rgb);
  float n = lumaAt(p + ivec2(0, 1));
  float s = lumaAt(p + ivec2(0, -1));
  float e = lumaAt(p + ivec2(1, 0));
  float w = lumaAt(p + ivec2(-1, 0));
  float brightest = max(m, max(max(n, s), max(e, w)));
  float darkest = min(m, min(min(n, s), min(e, w)));
  float contrast = brightest - darkest;
  if (contrast < max(SmallestContrast, brightest * RelativeContrast))
  {
    return;
  }
  float ne = lumaAt(p + ivec2(1, 1));
  float nw = lumaAt(p + ivec2(-1, 1));
  float se = lumaAt(p + ivec2(1, -1));
  float sw = lumaAt(p + ivec2(-1, -1));
  float acrossVertical = abs(nw - 2.0 * w + sw) + 2.0 * abs(n - 2.0 * m + s) + abs(ne - 2.0 * e + se);
  float acrossHorizontal = abs(nw - 2.0 * n + ne) + 2.0 * abs(w - 2.0 * m + e) + abs(sw - 2.0 * s + se);
  bool horizontal = acrossVertical >= acrossHorizontal;

  // The neighbour across the edge, and the direction along it.
  float plus = horizontal ? n : e;
  float minus = horizontal ? s : w;
  bool towardPlus = abs(plus - m) >= abs(minus - m);
  ivec2 across = (horizontal ? ivec2(0, 1) : ivec2(1, 0)) * (towardPlus ? 1 : -1);
  ivec2 along = horizontal ? ivec2(1, 0) : ivec2(0, 1);
  float other = towardPlus ? plus : minus;
  float middle = 0.5 * (m + other);
  float bound = 0.25 * abs(other - m);

  int forward = 0, backward = 0;
  float endForward = 0.0, endBackward = 0.0;
  bool openForward = true, openBackward = true;
  for (int i = 1; i <= Reach && (openForward || openBackward); ++i)
  {
    if (openForward)
    {
      ivec2 q = p + along * i;
      endForward = 0.5 * (lumaAt(q) + lumaAt(q + across)) - middle;
      forward = i;
      openForward = abs(endForward) < bound;
    }
    if (openBackward)
    {
      ivec2 q = p - along * i;
      endBackward = 0.5 * (lumaAt(q) + lumaAt(q + across)) - middle;
      backward = i;
      openBackward = abs(endBackward) < bound;
    }
  }
  float nearest = float(min(forward, backward));
  float length = float(forward + backward);
  float end = forward < backward ? endForward : endBackward;
  // The step goes toward this pixel only if the contrast at the edge's end has the opposite sign.
  float shift = (end < 0.0) != (m - middle < 0.0) ? 0.5 - nearest / length : 0.0;

  float average = (2.0 * (n + s + e + w) + ne + nw + se + sw) / 12.0;
  float standsOut = clamp(abs(average - m) / contrast, 0.0, 1.0);
  float blend = standsOut * standsOut * (3.0 - 2.0 * standsOut);
  shift = max(shift, blend * blend * DotBlend);
  color = mix(centre, pixelAt(p + across), shift);
}
