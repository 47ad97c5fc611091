// Samples before the filter: openness, depth and normal of one pixel in each block of GI_STRIDE x
// GI_STRIDE. Needs shared/view.h.

// Offset of the sampled pixel in its block. It changes each frame, so that still frames sample
// all pixels.
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

// Two numbers in [0, 1), evenly distributed over each tile of 4 x 4 texels, at a finer level over 4 x 4 such tiles, so
// that no tile repeats its neighbours, and at a still finer level over frames: rank-1 lattices, shifted
// by the sequence of Roberts 2018, The Unreasonable Effectiveness of Quasirandom Sequences.
vec2 giRawNoise(ivec2 raw)
{
  ivec2 within = raw & 3;
  ivec2 tile = (raw >> 2) & 3;
  int fine = ((within.x * 4 + within.y) * 11 + view.Frame.x * 5) & 15;
  int coarse = ((tile.x * 4 + tile.y) * 11) & 15;
  vec2 shift = vec2(coarse, (coarse * 7) & 15) / 16.0 + float(view.Frame.x) * vec2(0.7548776662, 0.5698402910);
  return fract((vec2(fine, (fine * 7) & 15) + fract(shift)) / 16.0);
}

// Texel formats of the samples.
#ifdef GI_BENT
#define GI_RAW uvec4
#define GI_RAW_OF(texel) (texel)
#else
#define GI_RAW uvec2
#define GI_RAW_OF(texel) (texel).xy
#endif

// Packs openness in ten bits, from -1 to 1 as a single slice may have more than its share
// of occlusion, and the octahedral normal in eleven bits per component. hidden: mean direction of the occluded light
// times its share, in view coordinates; stored with GI_BENT only.
GI_RAW giPackRaw(float openness, float depth, vec2 normal, vec3 hidden)
{
  uvec2 n = uvec2(normal * 2047.0 + 0.5);
  uint open = uint(clamp(openness * 0.5 + 0.5, 0.0, 1.0) * 1023.0 + 0.5);
  uvec2 word = uvec2(floatBitsToUint(depth), open << 22 | n.x << 11 | n.y);
#ifdef GI_BENT
  return uvec4(word, packSnorm2x16(0.5 * hidden.xy), packSnorm2x16(vec2(0.5 * hidden.z, 0.0)));
#else
  return word;
#endif
}

vec3 giRawHidden(GI_RAW word)
{
#ifdef GI_BENT
  return 2.0 * vec3(unpackSnorm2x16(word.z), unpackSnorm2x16(word.w).x);
#else
  return vec3(0.0);
#endif
}

// Final result: openness and, with GI_BENT, the mean direction of the arriving light times its share, in
// world coordinates, mapped to [0, 1]. The direction has unit length where nothing is occluded.
#ifdef GI_BENT
#define GI_OPEN vec4
vec4 giOpen(float openness, vec3 N, vec3 hidden)
{
  // The mean direction of an open surface's light has the length 2 / 3.
  return vec4(max(openness, 0.0), 0.5 + 0.5 * (mat3(view.ViewToWorld) * (N - 1.5 * hidden)));
}
#else
#define GI_OPEN float
float giOpen(float openness, vec3 N, vec3 hidden)
{
  return max(openness, 0.0);
}
#endif

float giRawOpenness(GI_RAW word)
{
  return float(word.y >> 22) * (2.0 / 1023.0) - 1.0;
}

float giRawDepth(GI_RAW word)
{
  return uintBitsToFloat(word.x);
}

// Octahedral.
vec2 giRawNormal(GI_RAW word)
{
  return vec2((word.y >> 11) & 2047u, word.y & 2047u) / 2047.0;
}
