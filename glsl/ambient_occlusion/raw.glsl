// What is sampled, before it is filtered: openness, depth and normal of one pixel in GI_STRIDE x
// GI_STRIDE. Needs shared/view.h.

// The pixel of its block that a texel stands for: another one each frame, so that still frames see
// all of them.
ivec2 giRawOffset()
{
#if GI_STRIDE == 2
  int turn = view.Frame.x & 3;
  return ivec2(turn == 1 || turn == 2 ? 1 : 0, turn == 1 || turn == 3 ? 1 : 0);
#else
  return ivec2(0);
#endif
}

ivec2 giRawPixel(ivec2 raw)
{
  ivec2 low = ivec2(view.Viewport.xy);
  return clamp(raw * GI_STRIDE + giRawOffset(), low, low + ivec2(view.Viewport.zw) - 1);
}

// Two numbers in [0, 1), spread evenly over every 4 x 4 texels, within that over 4 x 4 such tiles, so
// that no tile looks like its neighbours, and within that over frames: lattices of rank 1, shifted
// by the sequence of Roberts 2018, The Unreasonable Effectiveness of Quasirandom Sequences.
vec2 giRawSpread(ivec2 raw)
{
  ivec2 within = raw & 3;
  ivec2 tile = (raw >> 2) & 3;
  int fine = ((within.x * 4 + within.y) * 11 + view.Frame.x * 5) & 15;
  int coarse = ((tile.x * 4 + tile.y) * 11) & 15;
  vec2 shift = vec2(coarse, (coarse * 7) & 15) / 16.0 + float(view.Frame.x) * vec2(0.7548776662, 0.5698402910);
  return fract((vec2(fine, (fine * 7) & 15) + fract(shift)) / 16.0);
}

// Ten bits of openness, which reaches from -1 to 1 as a single slice may hold more than its share
// of occlusion; the octahedral normal in eleven
// bits each.
uvec2 giPackRaw(float openness, float depth, vec2 normal)
{
  uvec2 n = uvec2(normal * 2047.0 + 0.5);
  uint open = uint(clamp(openness * 0.5 + 0.5, 0.0, 1.0) * 1023.0 + 0.5);
  return uvec2(floatBitsToUint(depth), open << 22 | n.x << 11 | n.y);
}

float giRawOpenness(uvec2 word)
{
  return float(word.y >> 22) * (2.0 / 1023.0) - 1.0;
}

float giRawDepth(uvec2 word)
{
  return uintBitsToFloat(word.x);
}

// Octahedral.
vec2 giRawNormal(uvec2 word)
{
  return vec2((word.y >> 11) & 2047u, word.y & 2047u) / 2047.0;
}
