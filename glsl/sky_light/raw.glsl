// Sums over a pixel's part of the sky's maps. Needs shared/view.h. Variant: GI_STRIDE (one pixel is sampled in each
// block of GI_STRIDE x GI_STRIDE).
uniform ivec2 gridSize; // number of sampled pixels
uniform ivec2 gridTile; // size of a tile: all pixels at one place in blocks of 4 x 4

struct GiSkySum
{
  vec3 arrived;   // light that is not occluded
  float expected; // luminance of that light if nothing were occluded
  float depth;    // window depth of the pixel
  vec2 normal;    // octahedral
  float frames;   // number of frames in the mean; 0 for no surface
};

uvec4 giPackSky(GiSkySum sum)
{
  uvec2 n = uvec2(sum.normal * 4095.0 + 0.5);
  return uvec4(packHalf2x16(sum.arrived.rg), packHalf2x16(vec2(sum.arrived.b, sum.expected)),
    floatBitsToUint(sum.depth), uint(min(sum.frames, 255.0)) << 24 | n.x << 12 | n.y);
}

GiSkySum giUnpackSky(uvec4 word)
{
  vec2 last = unpackHalf2x16(word.y);
  return GiSkySum(vec3(unpackHalf2x16(word.x), last.x), last.y, uintBitsToFloat(word.z),
    vec2(word.w >> 12 & 4095u, word.w & 4095u) / 4095.0, float(word.w >> 24));
}

// Texel of a sampled pixel among the tiles.
ivec2 giTexelOf(ivec2 place)
{
  return (place & 3) * gridTile + (place >> 2);
}

ivec2 giPixelOf(ivec2 place)
{
  return ivec2(view.Viewport.xy) + min(place * GI_STRIDE, ivec2(view.Viewport.zw) - 1);
}
