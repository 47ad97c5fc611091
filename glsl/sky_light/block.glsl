// Sum over a block of 4 x 4 sampled pixels, which together have looked up all maps, of those on the same surface. Needs
// sky_light/raw.glsl, lib/alike.glsl and a usampler2D named rawTexture.
const float GI_ALL_PARTS = 16.0; // frames after which a pixel has looked up all maps itself

GiSkySum giSkyBlock(ivec2 place)
{
  GiSkySum sum = giUnpackSky(texelFetch(rawTexture, giTexelOf(place), 0));
  float share = 1.0 - sum.frames / GI_ALL_PARTS; // of the neighbours
  if (sum.frames == 0.0 || share <= 0.0)
  {
    return sum;
  }
  GiSurfel here = giSurfel(vec2(giPixelOf(place)) + 0.5, sum.depth, sum.normal, float(GI_STRIDE));
  // The block begins at alternating sides, so that it is not off to one of them.
  ivec2 first = -1 - (place & 1);
  for (int i = 0; i < 16; ++i)
  {
    ivec2 offset = first + ivec2(i & 3, i >> 2);
    ivec2 at = place + offset;
    if (offset == ivec2(0) || any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, gridSize)))
    {
      continue;
    }
    GiSkySum other = giUnpackSky(texelFetch(rawTexture, giTexelOf(at), 0));
    float weight = other.frames > 0.0
      ? share * giSimilarity(here, vec2(offset * GI_STRIDE), other.depth, other.normal)
      : 0.0;
    sum.arrived += weight * other.arrived;
    sum.expected += weight * other.expected;
  }
  return sum;
}
