// Sum over the sampled pixels around one, of those on the same surface. Every 4 x 4 of them look up all maps; the window
// is 5 x 5 with half a weight at its borders, so that it is centred and each map counts once. Needs sky_light/raw.glsl,
// lib/alike.glsl and a usampler2D named rawTexture.
const float GI_ALL_PARTS = 16.0; // frames after which a pixel has looked up all maps itself

GiSkySum giSkyWindow(ivec2 place)
{
  GiSkySum sum = giUnpackSky(texelFetch(rawTexture, giTexelOf(place), 0));
  float share = 1.0 - sum.frames / GI_ALL_PARTS; // of the neighbours
  if (sum.frames == 0.0 || share <= 0.0)
  {
    return sum;
  }
  GiSurfel here = giSurfel(vec2(giPixelOf(place)) + 0.5, sum.depth, sum.normal, float(GI_STRIDE));
  for (int i = 0; i < 25; ++i)
  {
    ivec2 offset = ivec2(i % 5, i / 5) - 2;
    ivec2 at = place + offset;
    if (offset == ivec2(0) || any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, gridSize)))
    {
      continue;
    }
    GiSkySum other = giUnpackSky(texelFetch(rawTexture, giTexelOf(at), 0));
    vec2 border = mix(vec2(1.0), vec2(0.5), equal(abs(offset), ivec2(2)));
    float weight = other.frames > 0.0
      ? share * border.x * border.y * giSimilarity(here, vec2(offset * GI_STRIDE), other.depth, other.normal)
      : 0.0;
    sum.arrived += weight * other.arrived;
    sum.expected += weight * other.expected;
  }
  return sum;
}
